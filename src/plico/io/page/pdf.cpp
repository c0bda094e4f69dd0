#include "plico/io/page/pdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plico/io/page/pdf_letters.h"
#include "plico/io/page/pdf_objects.h"

namespace plico {
namespace {

constexpr double kPointsPerMillimetre = 72 / 25.4;

template <class... Args>
void add(std::string& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

std::string color_of(const Color& color) {
  return fmt::format("{} {} {}", decimal(color[0]), decimal(color[1]), decimal(color[2]));
}

void take_pen(std::string& out, const Pen& pen) {
  add(out, "{} {}\n{} w [", color_of(pen.color), pen.fill ? "rg" : "RG", decimal(pen.width));
  for (double d : pen.dash) add(out, "{} ", decimal(d));
  add(out, "] 0 d\n");
}

void draw_points(std::string& out, const std::vector<Vec2>& points) {
  const char* command = "m";
  for (const Vec2& p : points) {
    add(out, "{} {} {}\n", decimal(p.x()), decimal(p.y()), command);
    command = "l";
  }
}

void draw_stroke(std::string& out, const Stroke& stroke, const Pen& pen) {
  draw_points(out, stroke.points);
  add(out, "{}\n", pen.fill ? "f" : stroke.closed ? "s" : "S");
}

void write_text(std::string& out, const Text& text, const Pen& pen, const PdfLetters& letters) {
  const Eigen::Matrix2d turn = rotation(text.angle);
  add(out, "BT {} rg {} {} {} {} {} {} Tm {}ET\n", color_of(pen.color), decimal(turn(0, 0)), decimal(turn(1, 0)),
      decimal(turn(0, 1)), decimal(turn(1, 1)), decimal(text.start.x()), decimal(text.start.y()),
      letters.shown(text.text, text.size));
}

// One layer as PDF operators, in millimetres.
std::string operators(const Drawing& drawing, Layer layer, const PdfLetters& letters) {
  std::string out;
  add(out, "{0:.12f} 0 0 {0:.12f} 0 0 cm 1 j\n", kPointsPerMillimetre);
  int last_pen = -1;
  for (const Stroke& stroke : drawing.strokes) {
    if (stroke.layer != layer) continue;
    const Pen& pen = drawing.pens[stroke.pen];
    if (stroke.pen != last_pen) take_pen(out, pen);
    last_pen = stroke.pen;
    draw_stroke(out, stroke, pen);
  }
  if (layer == Layer::Text)
    for (const Text& text : drawing.texts) write_text(out, text, drawing.pens[text.pen], letters);
  return out;
}

std::string box_of(const Drawing& drawing) {
  const Vec2 size = drawing.size * kPointsPerMillimetre;
  return fmt::format("[0 0 {} {}]", decimal(std::round(size.x() * 1e4) / 1e4),
                     decimal(std::round(size.y() * 1e4) / 1e4));
}

class PdfWriter {
 public:
  PdfWriter(const std::vector<Drawing>& drawings, const std::string& title, const std::string& creator)
      : is_painted_(std::ranges::any_of(drawings, &Drawing::is_painted)),
        catalog_(objects_.add()),
        pages_(objects_.add()),
        letters_(drawings, objects_) {
    add_layers();
    std::vector<int> pages;
    for (const Drawing& drawing : drawings) pages.push_back(add_page(drawing));
    objects_.set(pages_, fmt::format("<< /Type /Pages /Kids {} /Count {} >>", pdf_references(pages), pages.size()));
    information_ = objects_.add(fmt::format("<< /Title {} /Creator {} >>", pdf_text(title), pdf_text(creator)));
  }

  std::string run() const { return objects_.written(catalog_, information_); }

 private:
  void add_layer(std::string_view name) {
    groups_.push_back(objects_.add(fmt::format(
        "<< /Type /OCG /Name ({}) /Usage << /CreatorInfo << /Creator (plico) /Subtype /Technical >> >> >>", name)));
  }

  void add_layers() {
    for (Layer layer : kLayers) add_layer(name(layer));
    if (is_painted_) add_layer(kColorLayer);
    objects_.set(catalog_,
                 fmt::format("<< /Type /Catalog /Pages {0} /ViewerPreferences << /PrintScaling /None /DisplayDocTitle "
                             "true >>\n/OCProperties << /OCGs {1} /D << /Name (Layers) /Order {1} /ON {1} >> >> >>",
                             pdf_reference(pages_), pdf_references(groups_)));
  }

  // Every layer is one form with its optional content group; the page only calls them, cuts last.
  int add_page(const Drawing& drawing) {
    std::string forms, content;
    if (drawing.is_painted()) {
      add(forms, "/{} {} ", kColorLayer, pdf_reference(add_color_form(drawing)));
      add(content, "/{} Do\n", kColorLayer);
    }
    for (Layer layer : kDrawOrder) {
      add(forms, "/{} {} ", name(layer), pdf_reference(add_form(drawing, layer)));
      add(content, "/{} Do\n", name(layer));
    }
    const int calls = objects_.add_stream("", content);
    return objects_.add(
        fmt::format("<< /Type /Page /Parent {} /MediaBox {} /Resources << /XObject << {}>> >> /Contents {} >>",
                    pdf_reference(pages_), box_of(drawing), forms, pdf_reference(calls)));
  }

  int add_form(const Drawing& drawing, Layer layer) {
    const std::string entries =
        fmt::format("/Type /XObject /Subtype /Form /BBox {} /OC {} /Resources << /Font {} >>", box_of(drawing),
                    pdf_reference(groups_[static_cast<int>(layer)]), layer == Layer::Text ? letters_.fonts() : "<< >>");
    return objects_.add_stream(entries, operators(drawing, layer, letters_));
  }

  // Colours as polygons or as a picture, below all layers.
  int add_color_form(const Drawing& drawing) {
    std::string out = fmt::format("{0:.12f} 0 0 {0:.12f} 0 0 cm\n", kPointsPerMillimetre), pictures;
    for (const ColorFill& fill : drawing.fills) {
      add(out, "{} rg\n", color_of(fill.color));
      draw_points(out, fill.points);
      add(out, "f\n");
    }
    const PagePicture& page = drawing.picture;
    if (page.picture.width > 0) {
      pictures = fmt::format("/XObject << /PICTURE {} >>", pdf_reference(add_picture(page.picture)));
      add(out, "{} 0 0 {} {} {} cm /PICTURE Do\n", decimal(page.size.x()), decimal(page.size.y()),
          decimal(page.low.x()), decimal(page.low.y()));
    }
    return objects_.add_stream(fmt::format("/Type /XObject /Subtype /Form /BBox {} /OC {} /Resources << {} >>",
                                           box_of(drawing), pdf_reference(groups_.back()), pictures),
                               out);
  }

  int add_picture(const Picture& picture) {
    std::string color, alpha;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      for (std::size_t k = 0; k < 3; ++k) color += static_cast<char>(picture.rgba[i + k]);
      alpha += static_cast<char>(picture.rgba[i + 3]);
    }
    const std::string size = fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /BitsPerComponent 8",
                                         picture.width, picture.height);
    const int mask = objects_.add_stream(size + " /ColorSpace /DeviceGray", alpha);
    return objects_.add_stream(fmt::format("{} /ColorSpace /DeviceRGB /SMask {}", size, pdf_reference(mask)), color);
  }

  PdfObjects objects_;
  const bool is_painted_;
  int catalog_ = 0, pages_ = 0, information_ = 0;
  PdfLetters letters_;
  std::vector<int> groups_;  // in the order of kLayers, then that of colours
};

}  // namespace

std::string write_pdf(const std::vector<Drawing>& pages, const std::string& title, const std::string& creator) {
  return PdfWriter(pages, title, creator).run();
}

}  // namespace plico
