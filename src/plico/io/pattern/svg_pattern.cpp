#include "plico/io/pattern/svg_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/fold/arrange_lines.h"
#include "plico/io/pattern/svg_style.h"
#include "plico/io/text/text_scanner.h"
#include "plico/io/text/xml.h"

namespace plico {
namespace {

constexpr double kDrawnMerge = 1e-3;  // of the drawing; Origami Simulator joins ends within 3 units, of some hundreds

std::optional<Assignment> assignment_of_color(int color) {
  switch (color) {
    case 0xff0000:
      return Assignment::Mountain;
    case 0x0000ff:
      return Assignment::Valley;
    case 0x000000:
      return Assignment::Boundary;
    case 0x00ff00:
      return Assignment::Cut;
    case 0xffff00:
      return Assignment::Flat;
    case 0xff00ff:
      return Assignment::Unassigned;
    default:
      return {};
  }
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
  std::string stroke = "none", stroke_opacity = "1";
  double opacity = 1;  // of all groups around
};

class SvgReader {
 public:
  SvgReader(std::string_view bytes, const std::string& name) : xml_(bytes, name) {}

  std::vector<DrawnLine> run() {
    if (local_name(xml_.root()) != "svg")
      fail("root", fmt::format("the outermost element is {}, must be svg", quoted_word(xml_.root().name())),
           xml_.root());
    gather_rules(xml_.root(), 0);
    visit(xml_.root(), {}, 0);
    return std::move(lines_);
  }

  std::vector<std::string> left_out() const {
    std::vector<std::string> result;
    if (colorless_ > 0)
      result.push_back(
          fmt::format("{} shapes with no stroke, or one of another colour, were left out (first at line {})",
                      colorless_, first_colorless_));
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

  void gather_rules(const pugi::xml_node& node, int depth) {
    xml_.check_depth(node, depth);
    if (local_name(node) == "style") {
      std::string text;
      for (const pugi::xml_node& child : node.children()) text += child.value();
      for (const auto& [selector, style] : parse_style_sheet(text))
        for (const auto& [key, value] : style) rules_[selector][key] = value;
    }
    for (const pugi::xml_node& child : node.children()) gather_rules(child, depth + 1);
  }

  // Attributes, then rules from the general to the special, then style="".
  SvgStyle style_of(const pugi::xml_node& node) const {
    SvgStyle style;
    const auto add = [&](const SvgStyle& more) {
      for (const auto& [key, value] : more) style[key] = value;
    };
    for (const char* key : {"stroke", "opacity", "stroke-opacity", "display"})
      if (const auto attribute = node.attribute(key)) style[key] = attribute.value();
    const auto rule = [&](const std::string& selector) {
      if (const auto at = rules_.find(selector); at != rules_.end()) add(at->second);
    };
    const std::string element(local_name(node));
    rule("*");
    rule(element);
    std::string classes = node.attribute("class").value();
    for (std::size_t start = 0; start < classes.size();) {
      const std::size_t end = std::min(classes.find(' ', start), classes.size());
      rule("." + classes.substr(start, end - start));
      rule(element + "." + classes.substr(start, end - start));
      start = end + 1;
    }
    add(parse_declarations(node.attribute("style").value()));
    return style;
  }

  double opacity(const std::string& text, const pugi::xml_node& node) const {
    const bool percent = text.ends_with('%');
    double value = 0;
    if (!parse_number(std::string_view(text).substr(0, text.size() - (percent ? 1 : 0)), value) ||
        !std::isfinite(value))
      fail("opacity", fmt::format("opacity is {}, must be a number in [0, 1]", quoted_word(text)), node);
    return std::clamp(percent ? value / 100 : value, 0.0, 1.0);
  }

  Context inside(const pugi::xml_node& node, Context context, const SvgStyle& style) const {
    const auto given = [&](const char* key) {
      const auto at = style.find(key);
      return at == style.end() || at->second == "inherit" ? nullptr : &at->second;
    };
    if (const std::string* stroke = given("stroke")) context.stroke = *stroke;
    if (const std::string* value = given("stroke-opacity")) context.stroke_opacity = *value;
    if (const std::string* value = given("opacity")) context.opacity *= opacity(*value, node);
    if (const auto transform = node.attribute("transform")) {
      const auto own = parse_transform(transform.value());
      if (!own) fail("transform", fmt::format("transform {} cannot be read", quoted_word(transform.value())), node);
      context.to_drawing = context.to_drawing * *own;
    }
    return context;
  }

  void visit(const pugi::xml_node& node, const Context& outer, int depth) {
    if (node.type() != pugi::node_element) return;
    xml_.check_depth(node, depth);
    const std::string_view name = local_name(node);
    for (const char* skipped : {"defs", "style", "title", "desc", "metadata", "clipPath", "mask", "symbol", "pattern",
                                "marker", "script", "namedview", "linearGradient", "radialGradient"})
      if (name == skipped) return;
    const SvgStyle style = style_of(node);
    if (const auto display = style.find("display"); display != style.end() && display->second == "none") return;
    const Context context = inside(node, outer, style);
    if (name == "svg" || name == "g" || name == "a" || name == "switch") {
      for (const pugi::xml_node& child : node.children()) visit(child, context, depth + 1);
      return;
    }
    draw(node, name, context);
  }

  void draw(const pugi::xml_node& node, std::string_view name, const Context& context) {
    const bool shape = name == "line" || name == "polyline" || name == "polygon" || name == "rect" || name == "path" ||
                       name == "circle" || name == "ellipse";
    if (!shape) {
      ++unknown_;
      return;
    }
    const std::optional<int> color = parse_color(context.stroke);
    const std::optional<Assignment> assignment = color ? assignment_of_color(*color) : std::nullopt;
    if (!assignment) {
      if (colorless_++ == 0) first_colorless_ = xml_.line(node);
      return;
    }
    pen_ = {*assignment, flat_fold_angle(*assignment) * context.opacity * opacity(context.stroke_opacity, node),
            context.to_drawing, xml_.line(node)};
    if (name == "line")
      chain(node, {{value(node, "x1"), value(node, "y1")}, {value(node, "x2"), value(node, "y2")}}, false);
    else if (name == "polyline" || name == "polygon")
      chain(node, points(node), name == "polygon");
    else if (name == "rect")
      rectangle(node);
    else if (name == "path")
      path(node);
    else
      fail("curve", fmt::format("a {} is a curve; creases are straight", name), node,
           "replace curves by straight lines");
  }

  double value(const pugi::xml_node& node, const char* key) const {
    std::string_view text = node.attribute(key).value();
    if (text.ends_with("px")) text.remove_suffix(2);
    double x = 0;
    if (!text.empty() && !(parse_number(text, x) && std::abs(x) <= kLargestCoordinate))
      fail("number", fmt::format("{} is {}, must be a number", key, quoted_word(text)), node);
    return x;
  }

  std::vector<Vec2> points(const pugi::xml_node& node) const {
    std::vector<double> numbers;
    if (!parse_number_list(node.attribute("points").value(), numbers) || numbers.size() % 2 != 0)
      fail("number", "points is not a list of coordinate pairs", node);
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < numbers.size(); i += 2) result.emplace_back(numbers[i], numbers[i + 1]);
    return result;
  }

  void rectangle(const pugi::xml_node& node) {
    if (value(node, "rx") != 0 || value(node, "ry") != 0)
      fail("curve", "the rectangle has round corners; creases are straight", node, "set rx and ry to 0");
    const double x = value(node, "x"), y = value(node, "y"), w = value(node, "width"), h = value(node, "height");
    chain(node, {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true);
  }

  void chain(const pugi::xml_node& node, const std::vector<Vec2>& at, bool closed) {
    for (std::size_t i = 0; i + 1 < at.size(); ++i) add(node, at[i], at[i + 1]);
    if (closed && at.size() > 2) add(node, at.back(), at.front());
  }

  void add(const pugi::xml_node& node, const Vec2& a, const Vec2& b) {
    const auto placed = [&](const Vec2& p) {
      const Vec2 q = pen_.to_drawing * p;
      if (!(q.cwiseAbs().maxCoeff() <= kLargestCoordinate)) fail("number", "a coordinate is too large", node);
      return Vec2(q.x(), 0.0 - q.y());
    };
    lines_.push_back({placed(a), placed(b), pen_.assignment, pen_.fold_angle, pen_.line});
  }

  // The commands M L H V Z and their small letters.
  void path(const pugi::xml_node& node) {
    const std::string_view d = node.attribute("d").value();
    Vec2 at(0, 0), start(0, 0);
    for (std::size_t i = d.find_first_not_of(" \t\r\n,"); i < d.size();) {
      const char command = d[i];
      if (std::string_view("CcSsQqTtAa").find(command) != std::string_view::npos)
        fail("curve", fmt::format("the path has a curve (command {}, byte {}); creases are straight", command, i), node,
             "replace curves by straight lines");
      if (std::string_view("MmLlHhVvZz").find(command) == std::string_view::npos)
        fail("path",
             fmt::format("the path has {} at byte {}, must be one of M L H V Z",
                         quoted_word(std::string_view(&command, 1)), i),
             node);
      const std::size_t next = std::min(d.find_first_of("MmLlHhVvZzCcSsQqTtAa", i + 1), d.size());
      std::vector<double> numbers;
      if (!parse_number_list(d.substr(i + 1, next - i - 1), numbers))
        fail("path", fmt::format("the path has something that is no number after byte {}", i), node);
      run_command(node, command, numbers, at, start);
      i = next;
    }
  }

  void run_command(const pugi::xml_node& node, char command, const std::vector<double>& numbers, Vec2& at,
                   Vec2& start) {
    const bool relative = command >= 'a';
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    const std::size_t step = kind == 'Z' ? 0 : kind == 'H' || kind == 'V' ? 1 : 2;
    if (step == 0 ? !numbers.empty() : numbers.empty() || numbers.size() % step != 0)
      fail("path", fmt::format("path command {} has {} numbers", command, numbers.size()), node);
    if (kind == 'Z') {
      if (at != start) add(node, at, start);
      at = start;
    }
    for (std::size_t i = 0; i < numbers.size(); i += step) {
      Vec2 to = at;
      if (kind != 'V') to.x() = numbers[i] + (relative ? at.x() : 0);
      if (kind != 'H') to.y() = numbers[i + step - 1] + (relative ? at.y() : 0);
      if (kind == 'M' && i == 0)
        start = to;
      else
        add(node, at, to);
      at = to;
    }
  }

  struct Pen {
    Assignment assignment = Assignment::Boundary;
    double fold_angle = 0;
    Eigen::Affine2d to_drawing = Eigen::Affine2d::Identity();
    int line = 0;
  };

  XmlFile xml_;
  std::map<std::string, SvgStyle, std::less<>> rules_;
  Pen pen_;
  std::vector<DrawnLine> lines_;
  int colorless_ = 0, first_colorless_ = 0, unknown_ = 0;
};

}  // namespace

ImportedPattern read_svg_pattern(std::string_view bytes, const std::string& name) {
  SvgReader reader(bytes, name);
  const std::vector<DrawnLine> lines = reader.run();
  if (lines.empty())
    throw InvalidInput("svg/no-creases", "no stroke has the colour of a crease or border", name,
                       "draw mountains #f00, valleys #00f, the border #000");
  Arrangement arranged = arrange_lines(lines, {.merge = kDrawnMerge});
  ImportedPattern result{std::move(arranged.sheet), reader.left_out()};
  for (std::string& note : notes(arranged)) result.notes.push_back(std::move(note));
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
