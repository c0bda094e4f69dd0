#include "plico/io/page/pdf.h"

// QPDF 11 asks to be told that PointerHolder is not used.
#define POINTERHOLDER_TRANSITION 4
#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include "plico/font/font.h"

namespace plico {
namespace {

constexpr double kPointsPerMillimetre = 72 / 25.4;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void show_text(cairo_t* context, const Text& text, const Pen& pen) {
  cairo_save(context);
  cairo_set_source_rgb(context, pen.color[0], pen.color[1], pen.color[2]);
  cairo_translate(context, text.start.x(), text.start.y());
  const Eigen::Matrix2d turn = rotation(text.angle);  // cairo_rotate takes the sine of the machine's libm
  const cairo_matrix_t matrix = {turn(0, 0), turn(1, 0), turn(0, 1), turn(1, 1), 0, 0};
  cairo_transform(context, &matrix);
  cairo_scale(context, 1, -1);  // the page has y upwards, letters have not
  cairo_set_font_size(context, text.size);
  cairo_move_to(context, 0, 0);
  cairo_show_text(context, text.text.c_str());
  cairo_restore(context);
}

// Only the texts, one page a drawing, with their font embedded.
std::string text_pages(const std::vector<Drawing>& pages) {
  std::string bytes;
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, 100, 100);
  cairo_t* context = cairo_create(surface);
  cairo_select_font_face(context, Font::kFamily, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  for (const Drawing& page : pages) {
    const Vec2 size = page.size * kPointsPerMillimetre;
    cairo_pdf_surface_set_size(surface, size.x(), size.y());
    cairo_save(context);
    cairo_translate(context, 0, size.y());
    cairo_scale(context, kPointsPerMillimetre, -kPointsPerMillimetre);
    for (const Text& text : page.texts) show_text(context, text, page.pens[text.pen]);
    cairo_restore(context);
    cairo_show_page(context);
  }
  cairo_destroy(context);
  cairo_surface_finish(surface);
  cairo_surface_destroy(surface);
  return bytes;
}

template <class... Args>
void add(std::string& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

// The lines of one layer as PDF operators, in millimetres.
std::string operators(const Drawing& drawing, Layer layer) {
  std::string out;
  add(out, "{0:.12f} 0 0 {0:.12f} 0 0 cm 1 j\n", kPointsPerMillimetre);
  int last_pen = -1;
  for (const Stroke& stroke : drawing.strokes) {
    if (stroke.layer != layer) continue;
    const Pen& pen = drawing.pens[stroke.pen];
    if (stroke.pen != last_pen) {
      add(out, "{} {} {} {}\n", decimal(pen.color[0]), decimal(pen.color[1]), decimal(pen.color[2]),
          pen.fill ? "rg" : "RG");
      add(out, "{} w [", decimal(pen.width));
      for (double d : pen.dash) add(out, "{} ", decimal(d));
      add(out, "] 0 d\n");
      last_pen = stroke.pen;
    }
    const char* command = "m";
    for (const Vec2& p : stroke.points) {
      add(out, "{} {} {}\n", decimal(p.x()), decimal(p.y()), command);
      command = "l";
    }
    add(out, "{}\n", pen.fill ? "f" : stroke.closed ? "s" : "S");
  }
  return out;
}

QPDFObjectHandle box_of(const Drawing& drawing) {
  const Vec2 size = drawing.size * kPointsPerMillimetre;
  return QPDFObjectHandle::newArray(
      QPDFObjectHandle::Rectangle(0, 0, std::round(size.x() * 1e4) / 1e4, std::round(size.y() * 1e4) / 1e4));
}

class PdfWriter {
 public:
  PdfWriter(const std::vector<Drawing>& pages, const std::string& title, const std::string& creator) : pages_(pages) {
    pdf_.emptyPDF();
    add_layers();
    add_information(title, creator);
  }

  std::string run() {
    const std::string bytes = text_pages(pages_);
    QPDF text;
    text.processMemoryFile("text", bytes.data(), bytes.size());
    const std::vector<QPDFPageObjectHelper> texts = QPDFPageDocumentHelper(text).getAllPages();
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      QPDFPageObjectHelper page = texts[i];
      add_page(pages_[i], pdf_.copyForeignObject(page.getFormXObjectForPage(false)));
    }
    return written();
  }

 private:
  void add_layers() {
    std::string all;
    for (Layer layer : kLayers) {
      groups_.push_back(pdf_.makeIndirectObject(QPDFObjectHandle::parse(fmt::format(
          "<< /Type /OCG /Name ({}) /Usage << /CreatorInfo << /Creator (plico) /Subtype /Technical >> >> >>",
          name(layer)))));
      all += groups_.back().unparse() + " ";
    }
    QPDFObjectHandle root = pdf_.getRoot();
    root.replaceKey("/OCProperties",
                    QPDFObjectHandle::parse(
                        &pdf_, fmt::format("<< /OCGs [{0}] /D << /Name (Layers) /Order [{0}] /ON [{0}] >> >>", all)));
    root.replaceKey("/ViewerPreferences", QPDFObjectHandle::parse("<< /PrintScaling /None /DisplayDocTitle true >>"));
  }

  void add_information(const std::string& title, const std::string& creator) {
    QPDFObjectHandle information = QPDFObjectHandle::newDictionary();
    information.replaceKey("/Title", QPDFObjectHandle::newUnicodeString(title));
    information.replaceKey("/Creator", QPDFObjectHandle::newUnicodeString(creator));
    pdf_.getTrailer().replaceKey("/Info", pdf_.makeIndirectObject(information));
  }

  // Every layer is one form with its optional content group; the page only calls them, cuts last.
  void add_page(const Drawing& drawing, const QPDFObjectHandle& text_form) {
    QPDFObjectHandle forms = QPDFObjectHandle::newDictionary();
    std::string content;
    for (Layer layer : kDrawOrder) {
      const std::string form_name = fmt::format("/{}", name(layer));
      QPDFObjectHandle form = line_form(drawing, layer);
      if (layer == Layer::Text) form = text_form;
      form.getDict().replaceKey("/OC", groups_[static_cast<int>(layer)]);
      forms.replaceKey(form_name, form);
      content += form_name + " Do\n";
    }
    QPDFObjectHandle page = QPDFObjectHandle::parse("<< /Type /Page >>");
    page.replaceKey("/MediaBox", box_of(drawing));
    page.replaceKey("/Resources", QPDFObjectHandle::parse("<< >>"));
    page.getKey("/Resources").replaceKey("/XObject", forms);
    page.replaceKey("/Contents", QPDFObjectHandle::newStream(&pdf_, content));
    QPDFPageDocumentHelper(pdf_).addPage(QPDFPageObjectHelper(pdf_.makeIndirectObject(page)), false);
  }

  QPDFObjectHandle line_form(const Drawing& drawing, Layer layer) {
    QPDFObjectHandle form = QPDFObjectHandle::newStream(&pdf_, operators(drawing, layer));
    form.getDict().replaceKey("/Type", QPDFObjectHandle::newName("/XObject"));
    form.getDict().replaceKey("/Subtype", QPDFObjectHandle::newName("/Form"));
    form.getDict().replaceKey("/BBox", box_of(drawing));
    form.getDict().replaceKey("/Resources", QPDFObjectHandle::newDictionary());
    return form;
  }

  std::string written() {
    QPDFWriter writer(pdf_);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.setMinimumPDFVersion("1.5");
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.setCompressStreams(true);
    writer.write();
    const std::unique_ptr<Buffer> buffer(writer.getBuffer());
    return {reinterpret_cast<const char*>(buffer->getBuffer()), buffer->getSize()};
  }

  const std::vector<Drawing>& pages_;
  QPDF pdf_;
  std::vector<QPDFObjectHandle> groups_;  // in the order of kLayers
};

}  // namespace

std::string write_pdf(const std::vector<Drawing>& pages, const std::string& title, const std::string& creator) {
  return PdfWriter(pages, title, creator).run();
}

}  // namespace plico
