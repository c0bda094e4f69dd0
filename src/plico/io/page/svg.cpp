#include "plico/io/page/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "plico/font/font.h"
#include "plico/io/text/base64.h"
#include "plico/io/text/png.h"
#include "plico/io/text/xml_text.h"

namespace plico {
namespace {

constexpr double kBetweenPages = 10;  // millimetres
constexpr int kEffort = 6;            // of compressing pictures: more is slow

class SvgWriter {
 public:
  explicit SvgWriter(std::span<const Drawing> pages) : pages_(pages) {
    for (const Drawing& page : pages) {
      left_.push_back(left_.empty() ? 0 : size_.x() + kBetweenPages);
      size_ = {left_.back() + page.size.x(), std::max(size_.y(), page.size.y())};
    }
  }

  std::string run() {
    const std::string w = decimal(size_.x()), h = decimal(size_.y());
    const bool pictures = has([](const Drawing& page) { return page.picture.picture.width > 0; });
    out("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
        "{3}     version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\"{2}>\n",
        w, h, pictures ? " xmlns:xlink=\"http://www.w3.org/1999/xlink\"" : "",
        pages_.size() > 1 ? "     xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\"\n" : "");
    out("<title>{}</title>\n", xml_text(pages_.front().title));
    if (pages_.size() > 1) write_page_places();
    write_style();
    if (has([](const Drawing& page) { return page.is_painted(); }))
      write_group(kColorLayer, [&](const Drawing& page) { write_colors(page); });
    for (Layer layer : kDrawOrder) write_group(name(layer), [&](const Drawing& page) { write_layer(page, layer); });
    out("</svg>\n");
    return std::move(text_);
  }

 private:
  template <class... Args>
  void out(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  template <class Fact>
  bool has(Fact fact) const {
    return std::any_of(pages_.begin(), pages_.end(), fact);
  }

  // Inkscape's own element for pages; other programs show them beside each other.
  void write_page_places() {
    out("<sodipodi:namedview>\n");
    for (std::size_t i = 0; i < pages_.size(); ++i)
      out("<inkscape:page id=\"page{0}\" inkscape:label=\"{0}\" x=\"{1}\" y=\"0\" width=\"{2}\" height=\"{3}\"/>\n",
          i + 1, decimal(left_[i]), decimal(pages_[i].size.x()), decimal(pages_[i].size.y()));
    out("</sodipodi:namedview>\n");
  }

  // A layer, and in it what each page has of it.
  template <class Write>
  void write_group(std::string_view layer, Write write) {
    out("<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\">\n", layer);
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      height_ = pages_[i].size.y();
      if (i > 0) out("<g transform=\"translate({} 0)\">\n", decimal(left_[i]));
      write(pages_[i]);
      if (i > 0) out("</g>\n");
    }
    out("</g>\n");
  }

  void write_style() {
    const std::vector<Pen>& pens = std::max_element(pages_.begin(), pages_.end(), [](const auto& a, const auto& b) {
                                     return a.pens.size() < b.pens.size();
                                   })->pens;  // pages begin with the same ones
    out("<style>\npath{{fill:none;stroke-linejoin:round;stroke-linecap:butt}}\n"
        "text{{font-family:'{}',Verdana,sans-serif;stroke:none}}\n",
        Font::kFamily);
    for (std::size_t i = 0; i < pens.size(); ++i) {
      const Pen& pen = pens[i];
      if (pen.fill) {
        out("path.p{}{{fill:{};stroke:none}}\n", i, hex_text(pen.color));
        continue;
      }
      out("path.p{}{{stroke:{};stroke-width:{}", i, hex_text(pen.color), decimal(pen.width));
      for (std::size_t k = 0; k < pen.dash.size(); ++k)
        out("{}{}", k ? "," : ";stroke-dasharray:", decimal(pen.dash[k]));
      out("}}\n");
      out("text.p{}{{fill:{}}}\n", i, hex_text(pen.color));
    }
    out("</style>\n");
  }

  void write_colors(const Drawing& page) {
    for (const ColorFill& fill : page.fills) {
      out("<path style=\"fill:{}\" d=\"", hex_text(fill.color));
      write_points(fill.points);
      out("Z\"/>\n");
    }
    const PagePicture& shown = page.picture;
    if (shown.picture.width > 0)
      out("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
          "xlink:href=\"data:image/png;base64,{}\"/>\n",
          decimal(shown.low.x()), decimal(flipped(shown.low.y() + shown.size.y())), decimal(shown.size.x()),
          decimal(shown.size.y()), base64(write_png(shown.picture, kEffort)));
  }

  void write_layer(const Drawing& page, Layer layer) {
    for (const Stroke& stroke : page.strokes)
      if (stroke.layer == layer) write_stroke(stroke);
    if (layer == Layer::Text)
      for (const Text& text : page.texts) write_text(text);
  }

  double flipped(double y) const { return height_ - y; }

  void write_stroke(const Stroke& stroke) {
    out("<path class=\"p{}\"", stroke.pen);
    if (!stroke.part.empty()) out(" data-part=\"{}\"", xml_text(stroke.part));
    out(" d=\"");
    write_points(stroke.points);
    out("{}\"/>\n", stroke.closed ? "Z" : "");
  }

  void write_points(const std::vector<Vec2>& points) {
    char command = 'M';
    for (const Vec2& p : points) {
      out("{}{} {}", command, decimal(p.x()), decimal(flipped(p.y())));
      command = 'L';
    }
  }

  void write_text(const Text& text) {
    const std::string x = decimal(text.start.x()), y = decimal(flipped(text.start.y()));
    out("<text class=\"p{}\" x=\"{}\" y=\"{}\" font-size=\"{}\"", text.pen, x, y, decimal(text.size));
    if (text.angle != 0) out(" transform=\"rotate({} {} {})\"", decimal(-degrees(text.angle)), x, y);
    out(">{}</text>\n", xml_text(text.text));
  }

  std::span<const Drawing> pages_;
  std::vector<double> left_;  // of each page
  Vec2 size_ = Vec2::Zero();  // of all together
  double height_ = 0;         // of the page that is being written
  std::string text_;
};

}  // namespace

std::string write_svg(const Drawing& drawing) { return SvgWriter({&drawing, 1}).run(); }

std::string write_svg(const std::vector<Drawing>& pages) {
  return pages.empty() ? write_svg(Drawing{}) : SvgWriter(pages).run();
}

}  // namespace plico
