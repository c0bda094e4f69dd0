#include "plico/io/pattern/svg_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/fold/arrange_lines.h"
#include "plico/io/pattern/svg_path.h"
#include "plico/io/pattern/svg_style.h"
#include "plico/io/text/text_scanner.h"
#include "plico/io/text/xml.h"

namespace plico {
namespace {

constexpr int kMostElements = 2'000'000;  // drawn; <use> of <use> can make any number of them from a small file
constexpr double kSameHue = 20;           // degrees: print colours are off by less, orange is 21 from yellow

std::optional<Assignment> exact_assignment(int color) {
  switch (color) {
    case 0xff0000:
      return Assignment::Mountain;
    case 0x0000ff:
      return Assignment::Valley;
    case 0x000000:
      return Assignment::Boundary;
    case 0x00ff00:
    case 0x008000:  // "green", which Origami Simulator takes for a cut
      return Assignment::Cut;
    case 0xffff00:
      return Assignment::Flat;
    case 0xff00ff:
      return Assignment::Unassigned;
    default:
      return {};
  }
}

// Of a colour that a drawing program has changed, as for print: what is nearly black, or strong and of nearly the hue.
std::optional<Assignment> nearest_assignment(int color) {
  const int red = color >> 16, green = color >> 8 & 255, blue = color & 255;
  const int most = std::max({red, green, blue}), chroma = most - std::min({red, green, blue});
  if (most <= 64) return Assignment::Boundary;
  if (chroma < 96 || 2 * chroma < most) return {};
  double hue = most == red     ? 60.0 * (green - blue) / chroma
               : most == green ? 120 + 60.0 * (blue - red) / chroma
                               : 240 + 60.0 * (red - green) / chroma;
  if (hue < 0) hue += 360;
  constexpr std::pair<double, int> kHues[] = {{0, 0xff0000},   {60, 0xffff00},  {120, 0x00ff00},
                                              {240, 0x0000ff}, {300, 0xff00ff}, {360, 0xff0000}};
  for (const auto& [known, pure] : kHues)
    if (std::abs(hue - known) <= kSameHue) return exact_assignment(pure);
  return {};
}

const char* color_of(Assignment assignment) {
  switch (assignment) {
    case Assignment::Mountain:
      return "#f00";
    case Assignment::Valley:
      return "#00f";
    case Assignment::Boundary:
      return "#000";
    case Assignment::Cut:
      return "#0f0";
    case Assignment::Flat:
    case Assignment::Join:
      return "#ff0";
    case Assignment::Unassigned:
      break;
  }
  return "#f0f";
}

// What an element hands down to those inside it.
struct Context {
  Eigen::Affine2d to_drawing = Eigen::Affine2d::Identity();
  std::string stroke = "none", stroke_opacity = "1", color = "black";
  double opacity = 1;  // of all groups around
  bool visible = true;
};

// Strokes with a meaning, in the drawing's coordinates, y up.
struct Drawn {
  std::vector<SvgStroke> strokes;
  std::vector<DrawnLine> meanings;  // of each stroke; without ends
};

class SvgReader {
 public:
  SvgReader(std::string_view bytes, const std::string& name) : xml_(bytes, name) {}

  Drawn run() {
    if (local_name(xml_.root()) != "svg")
      fail("root", fmt::format("the outermost element is {}, must be svg", quoted_word(xml_.root().name())),
           xml_.root());
    gather(xml_.root(), 0);
    visit(xml_.root(), {}, 0);
    return std::move(drawn_);
  }

  std::vector<std::string> assumed() const {
    std::vector<std::string> result;
    if (near_colors_ > 0)
      result.push_back(
          fmt::format("shapes that have nearly the colour of a crease were taken for one: {}, as {} for {}",
                      near_colors_, near_color_, near_meaning_));
    if (colorless_ > 0)
      result.push_back(
          fmt::format("{} shapes with no stroke, or one of another colour, were left out (first at line {})",
                      colorless_, first_colorless_));
    if (const int rules = rules_.num_left_out(); rules > 0)
      result.push_back(fmt::format("{} rule{} of the style sheet {} left out: selectors are elements, classes and ids",
                                   rules, rules == 1 ? "" : "s", rules == 1 ? "was" : "were"));
    if (unknown_ > 0) result.push_back(fmt::format("{} elements that draw no lines were left out", unknown_));
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& code, const std::string& message, const pugi::xml_node& node,
                         const std::string& suggestion = {}) const {
    throw InvalidInput("svg/" + code, message, xml_.place(node), suggestion);
  }

  static std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') + 1);  // npos + 1 is 0
  }

  // Style sheets, and the elements that <use> may name.
  void gather(const pugi::xml_node& node, int depth) {
    xml_.check_depth(node, depth);
    if (local_name(node) == "style") {
      std::string text;
      for (const pugi::xml_node& child : node.children()) text += child.value();
      rules_.add(text);
    }
    if (const auto id = node.attribute("id")) by_id_.emplace(id.value(), node);
    for (const pugi::xml_node& child : node.children()) gather(child, depth + 1);
  }

  // Where it stands in the file: what <use> draws elsewhere keeps its own.
  static std::vector<SvgElement> chain_of(pugi::xml_node node) {
    std::vector<SvgElement> chain;
    for (; node.type() == pugi::node_element; node = node.parent())
      chain.push_back({local_name(node), node.attribute("id").value(), node.attribute("class").value()});
    return chain;
  }

  // Attributes, then rules, then style="".
  SvgStyle style_of(const pugi::xml_node& node) const {
    SvgStyle style;
    for (const char* key : {"stroke", "opacity", "stroke-opacity", "display", "visibility", "color"})
      if (const auto attribute = node.attribute(key)) style[key] = attribute.value();
    if (!rules_.empty())
      for (const auto& [key, value] : rules_.style_of(chain_of(node))) style[key] = value;
    for (const auto& [key, value] : parse_declarations(node.attribute("style").value())) style[key] = value;
    return style;
  }

  double opacity(const std::string& text, const pugi::xml_node& node) const {
    const std::optional<double> value = parse_opacity(text);
    if (!value) fail("opacity", fmt::format("opacity is {}, must be a number in [0, 1]", quoted_word(text)), node);
    return *value;
  }

  Context inside(const pugi::xml_node& node, Context context, const SvgStyle& style) const {
    const auto given = [&](const char* key) {
      const auto at = style.find(key);
      return at == style.end() || at->second == "inherit" ? nullptr : &at->second;
    };
    if (const std::string* stroke = given("stroke")) context.stroke = *stroke;
    if (const std::string* color = given("color")) context.color = *color;
    if (const std::string* value = given("stroke-opacity")) context.stroke_opacity = *value;
    if (const std::string* value = given("opacity")) {
      context.opacity *= opacity(*value, node);
      if (!given("stroke-opacity")) context.stroke_opacity = "1";  // as Origami Simulator: one of the two is the angle
    }
    if (const std::string* value = given("visibility")) context.visible = *value == "visible";
    if (const auto transform = node.attribute("transform")) {
      const auto own = parse_transform(transform.value());
      if (!own) fail("transform", fmt::format("transform {} cannot be read", quoted_word(transform.value())), node);
      context.to_drawing = context.to_drawing * *own;
    }
    return context;
  }

  void visit(const pugi::xml_node& node, const Context& outer, int depth, bool used = false) {
    if (node.type() != pugi::node_element) return;
    xml_.check_depth(node, depth);
    if (++visited_ > kMostElements) fail("size", fmt::format("more than {} elements are drawn", kMostElements), node);
    const std::string_view name = local_name(node);
    for (const char* skipped : {"defs", "style", "title", "desc", "metadata", "clipPath", "mask", "pattern", "marker",
                                "script", "namedview", "linearGradient", "radialGradient"})
      if (name == skipped) return;
    if (name == "symbol" && !used) return;
    const SvgStyle style = style_of(node);
    if (const auto display = style.find("display"); display != style.end() && display->second == "none") return;
    Context context = inside(node, outer, style);
    if (name == "use") return follow(node, context, depth);
    if (name == "svg" && depth > 0) context.to_drawing.translate(Vec2(length(node, "x"), length(node, "y")));
    if (name == "svg" || name == "g" || name == "a" || name == "switch" || name == "symbol") {
      for (const pugi::xml_node& child : node.children()) visit(child, context, depth + 1);
      return;
    }
    draw(node, name, context);
  }

  // A <use> of itself goes deeper until check_depth stops it.
  void follow(const pugi::xml_node& node, Context context, int depth) {
    std::string_view target;
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string_view key = attribute.name();
      if (key.substr(key.find(':') + 1) == "href") target = attribute.value();
    }
    const auto at = target.starts_with('#') ? by_id_.find(target.substr(1)) : by_id_.end();
    if (at == by_id_.end())
      fail("use", fmt::format("use of {}, which is no element of this file", quoted_word(target)), node);
    context.to_drawing.translate(Vec2(length(node, "x"), length(node, "y")));
    visit(at->second, context, depth + 1, true);
  }

  static bool is_shape(std::string_view name) {
    for (const char* shape : {"line", "polyline", "polygon", "rect", "path", "circle", "ellipse"})
      if (name == shape) return true;
    return false;
  }

  void draw(const pugi::xml_node& node, std::string_view name, const Context& context) {
    if (!is_shape(name)) {
      ++unknown_;
      return;
    }
    if (!context.visible) return;
    const std::optional<SvgColor> color =
        parse_color(context.stroke == "currentColor" ? context.color : context.stroke);
    std::optional<Assignment> assignment = color ? exact_assignment(color->rgb) : std::nullopt;
    if (color && !assignment) {
      assignment = nearest_assignment(color->rgb);
      if (assignment && near_colors_++ == 0) near_color_ = context.stroke, near_meaning_ = color_of(*assignment);
    }
    if (!assignment) {
      if (colorless_++ == 0) first_colorless_ = xml_.line(node);
      return;
    }
    const double share = context.opacity * opacity(context.stroke_opacity, node) * color->alpha;
    const DrawnLine meaning{{0, 0}, {0, 0}, *assignment, flat_fold_angle(*assignment) * share, xml_.line(node)};
    for (const SvgStroke& stroke : strokes_of(node, name)) add(node, stroke, context.to_drawing, meaning);
  }

  std::vector<SvgStroke> strokes_of(const pugi::xml_node& node, std::string_view name) const {
    if (name == "line")
      return chain({{length(node, "x1"), length(node, "y1")}, {length(node, "x2"), length(node, "y2")}}, false);
    if (name == "polyline" || name == "polygon") return chain(points(node), name == "polygon");
    if (name == "rect") return rectangle(node);
    if (name == "circle" || name == "ellipse") return ellipse(node, name == "circle");
    SvgPath path = parse_path(node.attribute("d").value());
    if (!path.error.empty()) fail("path", path.error, node);
    return std::move(path.strokes);
  }

  double length(const pugi::xml_node& node, const char* key) const {
    const std::string_view text = node.attribute(key).value();
    if (text.empty()) return 0;
    const std::optional<double> value = parse_length(text);
    if (!value || !(std::abs(*value) <= kLargestCoordinate))
      fail("number", fmt::format("{} is {}, must be a number", key, quoted_word(text)), node);
    return *value;
  }

  std::vector<Vec2> points(const pugi::xml_node& node) const {
    std::vector<double> numbers;
    if (!parse_number_list(node.attribute("points").value(), numbers) || numbers.size() % 2 != 0)
      fail("number", "points is not a list of coordinate pairs", node);
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < numbers.size(); i += 2) result.emplace_back(numbers[i], numbers[i + 1]);
    return result;
  }

  std::vector<SvgStroke> rectangle(const pugi::xml_node& node) const {
    const Vec2 size(length(node, "width"), length(node, "height"));
    if (size.minCoeff() < 0) fail("number", "a rectangle's width and height must be at least 0", node);
    const bool x = node.attribute("rx"), y = node.attribute("ry");  // one stands for both
    return rectangle_strokes({length(node, "x"), length(node, "y")}, size, length(node, x ? "rx" : "ry"),
                             length(node, y ? "ry" : "rx"));
  }

  std::vector<SvgStroke> ellipse(const pugi::xml_node& node, bool circle) const {
    const double rx = length(node, circle ? "r" : "rx"), ry = length(node, circle ? "r" : "ry");
    if (!(rx > 0 && ry > 0)) return {};
    return ellipse_strokes({length(node, "cx"), length(node, "cy")}, rx, ry);
  }

  static std::vector<SvgStroke> chain(const std::vector<Vec2>& at, bool closed) {
    std::vector<SvgStroke> strokes;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) strokes.push_back({at[i], at[i + 1]});
    if (closed && at.size() > 2) strokes.push_back({at.back(), at.front()});
    return strokes;
  }

  void add(const pugi::xml_node& node, const SvgStroke& stroke, const Eigen::Affine2d& to_drawing,
           const DrawnLine& meaning) {
    const auto placed = [&](const Vec2& p) {
      const Vec2 q = to_drawing * p;
      if (!(std::abs(q.x()) <= kLargestCoordinate && std::abs(q.y()) <= kLargestCoordinate))
        fail("number", "a coordinate is too large", node);
      return Vec2(q.x(), 0.0 - q.y());
    };
    drawn_.strokes.push_back({placed(stroke.a), placed(stroke.b), stroke.curved});
    if (stroke.curved) drawn_.strokes.back().c = placed(stroke.c), drawn_.strokes.back().d = placed(stroke.d);
    drawn_.meanings.push_back(meaning);
    if (drawn_.strokes.size() > static_cast<std::size_t>(kMostElements))
      fail("size", fmt::format("more than {} lines are drawn", kMostElements), node);
  }

  XmlFile xml_;
  SvgRules rules_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;  // the first of each name
  Drawn drawn_;
  std::string near_color_, near_meaning_;
  int near_colors_ = 0, colorless_ = 0, first_colorless_ = 0, unknown_ = 0, visited_ = 0;
};

double longer_side(const std::vector<SvgStroke>& strokes) {
  Eigen::AlignedBox2d box;
  for (const SvgStroke& stroke : strokes) {
    box.extend(stroke.a).extend(stroke.b);
    if (stroke.curved) box.extend(stroke.c).extend(stroke.d);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

// Curves become chains of lines; the note says how many and how far they are from what was drawn.
std::vector<DrawnLine> straightened(const Drawn& drawn, double flatness, std::vector<std::string>& notes) {
  const double size = longer_side(drawn.strokes);
  const double tolerance = flatness > 0 ? std::max(flatness, kLeastFlatness * size) : kFlatness * size;
  std::vector<DrawnLine> lines;
  int curves = 0, pieces = 0;
  for (std::size_t i = 0; i < drawn.strokes.size(); ++i) {
    const std::vector<Vec2> points = flatten(drawn.strokes[i], tolerance);
    for (std::size_t k = 1; k < points.size(); ++k) {
      DrawnLine line = drawn.meanings[i];
      line.a = points[k - 1], line.b = points[k];
      lines.push_back(line);
    }
    if (points.size() == 2) continue;
    ++curves;
    pieces += static_cast<int>(points.size()) - 1;
  }
  if (curves > 0)
    notes.push_back(fmt::format("{} curve{} became {} straight lines, no farther than {:.3g} from {} (--flatten)",
                                curves, curves == 1 ? "" : "s", pieces, tolerance, curves == 1 ? "it" : "them"));
  return lines;
}

}  // namespace

ImportedPattern read_svg_pattern(std::string_view bytes, const std::string& name, const DrawingOptions& options) {
  check(options);
  SvgReader reader(bytes, name);
  const Drawn drawn = reader.run();
  if (drawn.strokes.empty())
    throw InvalidInput("svg/no-creases", "no stroke has the colour of a crease or border", name,
                       "draw mountains #f00, valleys #00f, the border #000");
  ImportedPattern result{{}, reader.assumed()};
  const std::vector<DrawnLine> lines = straightened(drawn, options.flatten, result.notes);
  Arrangement arranged = arrange_lines(lines, {.merge = kDrawnMerge, .found = true, .distance = options.merge});
  for (std::string& note : notes(arranged)) result.notes.push_back(std::move(note));
  result.sheet = std::move(arranged.sheet);
  return result;
}

std::string write_svg_pattern(const CreasePattern& sheet) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : sheet.vertices) box.extend(p);
  if (box.isEmpty()) box.extend(Vec2(0, 0));
  const Vec2 size = box.sizes();
  const double margin = 0.02 * size.maxCoeff();
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" viewBox=\"{} {} {} {}\">\n"
      "<g fill=\"none\" stroke-width=\"{}\" stroke-linecap=\"round\">\n",
      box.min().x() - margin, -box.max().y() - margin, size.x() + 2 * margin, size.y() + 2 * margin, margin / 8);
  for (const Crease& e : sheet.edges) {
    const Vec2 &a = sheet.vertices[e.a], &b = sheet.vertices[e.b];
    fmt::format_to(std::back_inserter(out), "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\"", a.x(),
                   0.0 - a.y(), b.x(), 0.0 - b.y(), color_of(e.assignment));
    if (e.assignment == Assignment::Mountain || e.assignment == Assignment::Valley)
      fmt::format_to(std::back_inserter(out), " opacity=\"{}\"", std::min(std::abs(e.fold_angle) / kPi, 1.0));
    out += "/>\n";
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace plico
