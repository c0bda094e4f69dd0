#include "plico/io/page/pdf.h"

#include <fmt/format.h>

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

std::string color_of(const Pen& pen) {
  return fmt::format("{} {} {}", decimal(pen.color[0]), decimal(pen.color[1]), decimal(pen.color[2]));
}

void take_pen(std::string& out, const Pen& pen) {
  add(out, "{} {}\n{} w [", color_of(pen), pen.fill ? "rg" : "RG", decimal(pen.width));
  for (double d : pen.dash) add(out, "{} ", decimal(d));
  add(out, "] 0 d\n");
}

void draw_stroke(std::string& out, const Stroke& stroke, const Pen& pen) {
  const char* command = "m";
  for (const Vec2& p : stroke.points) {
    add(out, "{} {} {}\n", decimal(p.x()), decimal(p.y()), command);
    command = "l";
  }
  add(out, "{}\n", pen.fill ? "f" : stroke.closed ? "s" : "S");
}

void write_text(std::string& out, const Text& text, const Pen& pen, const PdfLetters& letters) {
  const Eigen::Matrix2d turn = rotation(text.angle);
  add(out, "BT {} rg {} {} {} {} {} {} Tm {}ET\n", color_of(pen), decimal(turn(0, 0)), decimal(turn(1, 0)),
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
      : catalog_(objects_.add()), pages_(objects_.add()), letters_(drawings, objects_) {
    add_layers();
    std::vector<int> pages;
    for (const Drawing& drawing : drawings) pages.push_back(add_page(drawing));
    objects_.set(pages_, fmt::format("<< /Type /Pages /Kids {} /Count {} >>", pdf_references(pages), pages.size()));
    information_ = objects_.add(fmt::format("<< /Title {} /Creator {} >>", pdf_text(title), pdf_text(creator)));
  }

  std::string run() const { return objects_.written(catalog_, information_); }

 private:
  void add_layers() {
    for (Layer layer : kLayers)
      groups_.push_back(objects_.add(fmt::format(
          "<< /Type /OCG /Name ({}) /Usage << /CreatorInfo << /Creator (plico) /Subtype /Technical >> >> >>",
          name(layer))));
    objects_.set(catalog_,
                 fmt::format("<< /Type /Catalog /Pages {0} /ViewerPreferences << /PrintScaling /None /DisplayDocTitle "
                             "true >>\n/OCProperties << /OCGs {1} /D << /Name (Layers) /Order {1} /ON {1} >> >> >>",
                             pdf_reference(pages_), pdf_references(groups_)));
  }

  // Every layer is one form with its optional content group; the page only calls them, cuts last.
  int add_page(const Drawing& drawing) {
    std::string forms, content;
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

  PdfObjects objects_;
  int catalog_ = 0, pages_ = 0, information_ = 0;
  PdfLetters letters_;
  std::vector<int> groups_;  // in the order of kLayers
};

}  // namespace

std::string write_pdf(const std::vector<Drawing>& pages, const std::string& title, const std::string& creator) {
  return PdfWriter(pages, title, creator).run();
}

}  // namespace plico
