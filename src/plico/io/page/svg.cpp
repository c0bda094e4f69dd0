#include "plico/io/page/svg.h"

#include <fmt/format.h>

#include <iterator>

#include "plico/font/font.h"
#include "plico/io/text/base64.h"
#include "plico/io/text/png.h"
#include "plico/io/text/xml_text.h"

namespace plico {
namespace {

constexpr int kEffort = 6;  // of compressing pictures: more is slow

class SvgWriter {
 public:
  explicit SvgWriter(const Drawing& drawing) : drawing_(drawing) {}

  std::string run() {
    const std::string w = decimal(drawing_.size.x()), h = decimal(drawing_.size.y());
    out("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
        "     version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\"{2}>\n",
        w, h, drawing_.picture.picture.width > 0 ? " xmlns:xlink=\"http://www.w3.org/1999/xlink\"" : "");
    out("<title>{}</title>\n", xml_text(drawing_.title));
    write_style();
    if (drawing_.is_painted()) write_colors();
    for (Layer layer : kDrawOrder) write_layer(layer);
    out("</svg>\n");
    return std::move(text_);
  }

 private:
  template <class... Args>
  void out(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void write_style() {
    out("<style>\npath{{fill:none;stroke-linejoin:round;stroke-linecap:butt}}\n"
        "text{{font-family:'{}',Verdana,sans-serif;stroke:none}}\n",
        Font::kFamily);
    for (std::size_t i = 0; i < drawing_.pens.size(); ++i) {
      const Pen& pen = drawing_.pens[i];
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

  void write_colors() {
    out("<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\">\n", kColorLayer);
    for (const ColorFill& fill : drawing_.fills) {
      out("<path style=\"fill:{}\" d=\"", hex_text(fill.color));
      write_points(fill.points);
      out("Z\"/>\n");
    }
    const PagePicture& page = drawing_.picture;
    if (page.picture.width > 0)
      out("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
          "xlink:href=\"data:image/png;base64,{}\"/>\n",
          decimal(page.low.x()), decimal(flipped(page.low.y() + page.size.y())), decimal(page.size.x()),
          decimal(page.size.y()), base64(write_png(page.picture, kEffort)));
    out("</g>\n");
  }

  void write_layer(Layer layer) {
    out("<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\">\n", name(layer));
    for (const Stroke& stroke : drawing_.strokes)
      if (stroke.layer == layer) write_stroke(stroke);
    if (layer == Layer::Text)
      for (const Text& text : drawing_.texts) write_text(text);
    out("</g>\n");
  }

  double flipped(double y) const { return drawing_.size.y() - y; }

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

  const Drawing& drawing_;
  std::string text_;
};

}  // namespace

std::string write_svg(const Drawing& drawing) { return SvgWriter(drawing).run(); }

}  // namespace plico
