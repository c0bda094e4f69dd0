#include "plico/fabricate/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr double kBetween = 5;                         // millimetres from run to run
constexpr double kLargestText = 5, kTextShare = 0.25;  // of labels: millimetres, and of a side

using Node = std::pair<int, int>;  // of the square lattice, in sides

// Faces of the strip that lie side by side.
struct Run {
  int first = 0, count = 0;
  Node low, size;
};

// The strip on the lattice: corners of face 0 at (0, 0) .. (1, 1).
class Strip {
 public:
  explicit Strip(const CreasePattern& sheet) : sheet_(sheet) {
    const std::vector<int>& face = sheet.faces.front();
    origin_ = sheet.vertices[face[0]];
    side_ = (sheet.vertices[face[1]] - origin_).norm();
    for (int e = 0; e < static_cast<int>(sheet.edges.size()); ++e) edge_[ends(sheet.edges[e].a, sheet.edges[e].b)] = e;
  }

  int num_faces() const { return static_cast<int>(sheet_.faces.size()); }
  const CreasePattern& sheet() const { return sheet_; }
  Node node(int vertex) const {
    const Vec2 at = (sheet_.vertices[vertex] - origin_) / side_;
    return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  }
  // Its lower left corner.
  Node cell(int face) const {
    Node low = node(sheet_.faces[face][0]);
    for (int v : sheet_.faces[face]) low = {std::min(low.first, node(v).first), std::min(low.second, node(v).second)};
    return low;
  }
  int edge(int a, int b) const { return edge_.at(ends(a, b)); }

 private:
  static Node ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  const CreasePattern& sheet_;
  Vec2 origin_;
  double side_ = 1;
  std::map<Node, int> edge_;
};

// From `first` on as long as no square lies over another and all fit into `room` squares.
Run longest_run(const Strip& strip, int first, const Node& room) {
  Run run{first, 0, {}, {}};
  Node low, high;
  std::set<Node> taken;
  for (int face = first; face < strip.num_faces(); ++face) {
    const Node at = strip.cell(face);
    const Node new_low = run.count ? Node{std::min(low.first, at.first), std::min(low.second, at.second)} : at;
    const Node new_high = run.count ? Node{std::max(high.first, at.first), std::max(high.second, at.second)} : at;
    const Node size{new_high.first - new_low.first + 1, new_high.second - new_low.second + 1};
    if (size.first > room.first || size.second > room.second || !taken.insert(at).second) break;
    low = new_low;
    high = new_high;
    run = {first, run.count + 1, low, size};
  }
  return run;
}

class RunSheets {
 public:
  RunSheets(const CreasePattern& sheet, const RunOptions& options)
      : strip_(sheet), options_(options), text_(std::min(kLargestText, kTextShare * options.side)) {
    const Vec2 room = printable(options.page) / options.side;
    room_ = {static_cast<int>(room.x() + 1e-9), static_cast<int>(room.y() + 1e-9)};
    if (room_.first < 1 || room_.second < 1)
      throw InvalidOption(fmt::format("side = {:g} mm is more than the {:g} x {:g} mm that a page has room for",
                                      options.side, printable(options.page).x(), printable(options.page).y()));
  }

  PageLayout build() {
    layout_.margin = options_.page.margin;
    const Vec2 room = printable(options_.page);
    Vec2 at = Vec2::Zero();  // where the next run may stand, from the lower left of the printable part
    double row = 0;          // height of the row
    for (int first = 0; first < strip_.num_faces();) {
      const Run run = longest_run(strip_, first, room_);
      const Vec2 size = options_.side * Vec2(run.size.first, run.size.second);
      if (at.x() + size.x() > room.x() + 1e-9) at = {0, at.y() + std::exchange(row, 0) + kBetween};
      if (layout_.pages.empty() || at.y() + size.y() > room.y() + 1e-9) {
        layout_.pages.emplace_back().size = options_.page.size;
        at.setZero();
        row = 0;
      }
      add_part(run, options_.page.margin.low() + at);
      at.x() += size.x() + kBetween;
      row = std::max(row, size.y());
      first += run.count;
    }
    return std::move(layout_);
  }

 private:
  Vec2 place(const Node& node, const Run& run, const Vec2& corner) const {
    return corner + options_.side * Vec2(node.first - run.low.first, node.second - run.low.second);
  }

  void add_part(const Run& run, const Vec2& corner) {
    PlacedPart part;
    part.part = static_cast<int>(layout_.parts.size());
    part.name = fmt::format("{}", part.part + 1);
    part.page = static_cast<int>(layout_.pages.size()) - 1;
    for (int face = run.first; face < run.first + run.count; ++face) add_panel(part, face, run, corner);
    part.outlines = {outline(run, corner)};
    if (run.first > 0) add_joint(part, run.first - 1, run.first, run, corner);
    const int last = run.first + run.count - 1;
    if (last + 1 < strip_.num_faces()) add_joint(part, last, last, run, corner);
    layout_.parts.push_back(std::move(part));
  }

  void add_panel(PlacedPart& part, int face, const Run& run, const Vec2& corner) {
    const CreasePattern& sheet = strip_.sheet();
    const std::vector<int>& vertices = sheet.faces[face];
    PlacedPanel panel;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      panel.corners.push_back(place(strip_.node(vertices[i]), run, corner));
      panel.edges.push_back(strip_.edge(vertices[i], vertices[(i + 1) % vertices.size()]));
    }
    const Vec2 centre = (panel.corners[0] + panel.corners[2]) / 2;
    Mark glued{{}, true};
    for (const Vec2& at : panel.corners)
      glued.points.push_back(centre + (1 - 2 * options_.trim / options_.side) * (at - centre));
    part.marks.push_back(std::move(glued));
    part.labels.push_back({fmt::format("{}", face), centre, 0, text_});
    part.panels.push_back(std::move(panel));
    if (face + 1 == run.first + run.count) return;
    const Crease& fold = sheet.edges[face];
    part.folds.push_back({face, place(strip_.node(fold.a), run, corner), place(strip_.node(fold.b), run, corner),
                          fold.assignment, fold.fold_angle});
  }

  // Beside the middle of the hinge's edge, within the face.
  void add_joint(PlacedPart& part, int hinge, int face, const Run& run, const Vec2& corner) {
    const Crease& edge = strip_.sheet().edges[hinge];
    const Vec2 middle = (place(strip_.node(edge.a), run, corner) + place(strip_.node(edge.b), run, corner)) / 2;
    const Node cell = strip_.cell(face);
    const Vec2 centre = place(cell, run, corner) + Vec2::Constant(options_.side / 2);
    part.labels.push_back({fmt::format("J{}", hinge), middle + 0.4 * (centre - middle), 0, 0.7 * text_});
  }

  // Along the right sides of the faces and back along the left ones: squares that only lie beside each other are cut
  // apart.
  std::vector<Vec2> outline(const Run& run, const Vec2& corner) const {
    std::vector<Node> right, left;
    for (int face = run.first; face < run.first + run.count; ++face) {
      const std::vector<int>& vertices = strip_.sheet().faces[face];
      const bool is_first = face == run.first, is_last = face + 1 == run.first + run.count;
      const int to_next = is_last ? 0 : side_of(face, face);
      const int in = is_first ? (to_next + 2) % 4 : side_of(face, face - 1);
      const int out = is_last ? (in + 2) % 4 : to_next;
      // Counter-clockwise from the way in to the way out lies the right, from there on the left.
      for (int i = (in + 1) % 4; i != (out + 1) % 4; i = (i + 1) % 4) push_new(right, strip_.node(vertices[i]));
      std::vector<Node> back;
      for (int i = (out + 1) % 4; i != (in + 1) % 4; i = (i + 1) % 4) back.push_back(strip_.node(vertices[i]));
      for (auto node = back.rbegin(); node != back.rend(); ++node) push_new(left, *node);
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    std::vector<Vec2> points;
    for (const Node& node : right) points.push_back(place(node, run, corner));
    return points;
  }

  static void push_new(std::vector<Node>& nodes, const Node& node) {
    if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
  }

  // Of the face at its hinge: the side from corner i to the next.
  int side_of(int face, int hinge) const {
    const std::vector<int>& vertices = strip_.sheet().faces[face];
    int side = 0;
    while (side < 3 && strip_.edge(vertices[side], vertices[side + 1]) != hinge) ++side;
    return side;
  }

  const Strip strip_;
  const RunOptions& options_;
  const double text_;
  Node room_;
  PageLayout layout_;
};

}  // namespace

PageLayout lay_out_runs(const CreasePattern& strip, const RunOptions& options) {
  check(options.page);
  if (!(options.side > 0) || !std::isfinite(options.side))
    throw InvalidOption(fmt::format("side = {} must be above 0 mm", options.side));
  if (!(options.trim >= 0 && options.trim < options.side / 2))
    throw InvalidOption(fmt::format("trim = {} must be in [0, side / 2 = {:g}) mm", options.trim, options.side / 2));
  if (strip.faces.empty()) throw InvalidInput("chain/empty", "a chain without panels has no sheets");
  return RunSheets(strip, options).build();
}

}  // namespace plico
