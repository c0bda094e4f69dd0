#include "plico/io/pattern/opx.h"

#include <cmath>
#include <map>

#include "plico/base/error.h"
#include "plico/fold/arrange_lines.h"
#include "plico/io/text/text_scanner.h"
#include "plico/io/text/xml.h"

namespace plico {
namespace {

class OpxReader {
 public:
  OpxReader(std::string_view bytes, const std::string& name) : xml_(bytes, name) {}

  std::vector<DrawnLine> run() {
    visit(xml_.root(), 0);
    return std::move(lines_);
  }

 private:
  void visit(const pugi::xml_node& node, int depth) {
    xml_.check_depth(node, depth);
    const std::string_view type = node.attribute("class").value();
    if (std::string_view(node.name()) == "object" && type.ends_with("OriLineProxy"))
      lines_.push_back(read_line(node));
    else
      for (const pugi::xml_node& child : node.children()) visit(child, depth + 1);
  }

  DrawnLine read_line(const pugi::xml_node& node) const {
    std::map<std::string_view, double> value;
    for (const pugi::xml_node& field : node.children("void"))
      value[field.attribute("property").value()] = number(field.first_child());
    const double type = value["type"];
    Assignment assignment = Assignment::Flat;
    if (type == 1)
      assignment = Assignment::Boundary;
    else if (type == 2)
      assignment = Assignment::Mountain;
    else if (type == 3)
      assignment = Assignment::Valley;
    else if (type != 0)
      throw InvalidInput("opx/type", fmt::format("line type {} must be in [0, 3]", type), xml_.place(node),
                         "0 is auxiliary, 1 border, 2 mountain, 3 valley");
    return {{value["x0"], 0.0 - value["y0"]},
            {value["x1"], 0.0 - value["y1"]},
            assignment,
            flat_fold_angle(assignment),
            xml_.line(node)};
  }

  double number(const pugi::xml_node& node) const {
    double x = 0;
    const std::string_view text = node.child_value();
    if (!parse_number(text, x) || !(std::abs(x) <= kLargestCoordinate))
      throw InvalidInput("read/number",
                         fmt::format("a field of a line is {}, must be a finite number", quoted_word(text)),
                         xml_.place(node));
    return x;
  }

  XmlFile xml_;
  std::vector<DrawnLine> lines_;
};

}  // namespace

ImportedPattern read_opx(std::string_view bytes, const std::string& name, const DrawingOptions& options) {
  check(options);
  Arrangement arranged =
      arrange_lines(OpxReader(bytes, name).run(), {.merge = kRoundedMerge, .found = true, .distance = options.merge});
  ImportedPattern result{std::move(arranged.sheet), notes(arranged)};
  result.notes.emplace_back("the file has no fold angles: mountains and valleys are folded by 180 degrees");
  return result;
}

}  // namespace plico
