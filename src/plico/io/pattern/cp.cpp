#include "plico/io/pattern/cp.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "plico/base/error.h"
#include "plico/fold/arrange_lines.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

constexpr std::array<Assignment, 5> kTypes{Assignment::Unassigned, Assignment::Boundary, Assignment::Mountain,
                                           Assignment::Valley, Assignment::Flat};

int type_of(Assignment assignment) {
  switch (assignment) {
    case Assignment::Boundary:
    case Assignment::Cut:
      return 1;
    case Assignment::Mountain:
      return 2;
    case Assignment::Valley:
      return 3;
    case Assignment::Flat:
    case Assignment::Join:
      return 4;
    case Assignment::Unassigned:
      break;
  }
  return 0;
}

}  // namespace

ImportedPattern read_cp(std::string_view bytes, const std::string& name, const DrawingOptions& options) {
  check(options);
  TextScanner scan(bytes, name);
  std::vector<DrawnLine> lines;
  bool creased = false;
  while (scan.more()) {
    const int type = scan.integer("the type of a line"), place = scan.line();
    if (type < 0 || type > 4)
      scan.fail("cp/type", fmt::format("line type {} must be in [0, 4]", type),
                "1 is border, 2 mountain, 3 valley, 4 auxiliary");
    std::array<double, 4> at{};
    for (double& x : at) {
      x = scan.number("a coordinate");
      if (!(std::abs(x) <= kLargestCoordinate))
        scan.fail("read/number", fmt::format("a coordinate is {}, must be finite", x));
    }
    const Assignment assignment = kTypes[type];
    creased = creased || type == 2 || type == 3;
    lines.push_back({{at[0], -at[1]}, {at[2], -at[3]}, assignment, flat_fold_angle(assignment), place});
  }
  Arrangement arranged = arrange_lines(lines, {.merge = kRoundedMerge, .found = true, .distance = options.merge});
  ImportedPattern result{std::move(arranged.sheet), notes(arranged)};
  if (creased)
    result.notes.emplace_back("the file has no fold angles: mountains and valleys are folded by 180 degrees");
  return result;
}

std::string write_cp(const CreasePattern& sheet) {
  std::string out;
  for (const Crease& e : sheet.edges) {
    const Vec2 &a = sheet.vertices[e.a], &b = sheet.vertices[e.b];
    fmt::format_to(std::back_inserter(out), "{} {} {} {} {}\n", type_of(e.assignment), a.x(), 0.0 - a.y(), b.x(),
                   0.0 - b.y());
  }
  return out;
}

}  // namespace plico
