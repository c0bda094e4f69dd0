#include "plico/origami/layer_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plico/base/sat.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/motion/plates.h"

namespace plico {
namespace {

constexpr double kDrawnOff = 1e-4;  // of the mean side: what shorter overlaps, and lines apart by less, are taken for
constexpr double kFlatGoal = 1e-6;  // radians

// The sheet as it lies folded, in the plane.
class FoldedFlat {
 public:
  explicit FoldedFlat(const Linkage& linkage)
      : linkage_(linkage),
        off_(kDrawnOff * mean_side_length(linkage)),
        plates_(make_plates(linkage, off_)),
        poses_(folding_map(linkage, goal(linkage))) {
    for (int i = 0; i < plates_.size(); ++i) {
      std::vector<Vec2>& piece = pieces_.emplace_back();
      for (int c = plates_.first[i]; c < plates_.first[i + 1]; ++c)
        piece.emplace_back((poses_[plates_.panel[i]] * plates_.corners[c]).head<2>());
      if (is_turned(plates_.panel[i])) std::reverse(piece.begin(), piece.end());
    }
  }

  const Linkage& linkage() const { return linkage_; }
  double off() const { return off_; }
  bool is_turned(int panel) const { return poses_[panel].linear()(2, 2) < 0; }

  bool overlap(int f, int g) const {
    return any_pieces(f, g, [](const std::vector<Vec2>&) { return true; });
  }
  bool overlap(int f, int g, int h) const {
    return any_pieces(f, g, [&](const std::vector<Vec2>& both) {
      for (int k = plates_.first_of_panel[h]; k < plates_.first_of_panel[h + 1]; ++k)
        if (has_area(clipped(both, pieces_[k]))) return true;
      return false;
    });
  }

  // The ends of a crease.
  std::pair<Vec2, Vec2> segment(int hinge) const {
    const Hinge& h = linkage_.hinges[hinge];
    return {(poses_[h.left] * h.from).head<2>(), (poses_[h.left] * h.to).head<2>()};
  }

  // Does the crease run through the inside of a panel?
  bool runs_through(int hinge, int panel) const {
    const auto [from, to] = segment(hinge);
    for (int k = plates_.first_of_panel[panel]; k < plates_.first_of_panel[panel + 1]; ++k)
      if (length_within(from, to, pieces_[k]) > off_) return true;
    return false;
  }

  bool lie_on_each_other(int hinge, int other) const {
    const auto [a, b] = segment(hinge);
    const auto [c, d] = segment(other);
    const Vec2 along = (b - a).normalized();
    if (std::abs(cross(along, Vec2(c - a))) > off_ || std::abs(cross(along, Vec2(d - a))) > off_) return false;
    const double s = along.dot(c - a), t = along.dot(d - a);
    return std::min((b - a).norm(), std::max(s, t)) - std::max(0.0, std::min(s, t)) > off_;
  }

  // On which side of the line of `like` a panel of crease `hinge` lies: 1 or -1.
  int side(int hinge, int panel, int like) const {
    const auto [a, b] = segment(hinge);
    const auto [c, d] = segment(like);
    const int own = (linkage_.hinges[hinge].left == panel ? 1 : -1) * (is_turned(panel) ? -1 : 1);
    return (b - a).dot(d - c) < 0 ? -own : own;
  }

 private:
  bool has_area(const std::vector<Vec2>& polygon) const { return std::abs(signed_area(polygon)) > off_ * off_; }

  template <class Wanted>
  bool any_pieces(int f, int g, const Wanted& wanted) const {
    for (int i = plates_.first_of_panel[f]; i < plates_.first_of_panel[f + 1]; ++i)
      for (int j = plates_.first_of_panel[g]; j < plates_.first_of_panel[g + 1]; ++j)
        if (const std::vector<Vec2> both = clipped(pieces_[i], pieces_[j]); has_area(both) && wanted(both)) return true;
    return false;
  }

  static double length_within(const Vec2& from, const Vec2& to, const std::vector<Vec2>& convex) {
    double begin = 0, end = 1;
    for (std::size_t i = 0; i < convex.size(); ++i) {
      const Vec2& corner = convex[i];
      const Vec2 side = convex[(i + 1) % convex.size()] - corner;
      const double at_from = cross(side, Vec2(from - corner)), at_to = cross(side, Vec2(to - corner));
      if (at_from < 0 && at_to < 0) return 0;
      if (at_from < 0) begin = std::max(begin, at_from / (at_from - at_to));
      if (at_to < 0) end = std::min(end, at_from / (at_from - at_to));
    }
    return std::max(0.0, end - begin) * (to - from).norm();
  }

  const Linkage& linkage_;
  double off_;
  Plates plates_;
  std::vector<Pose> poses_;
  std::vector<std::vector<Vec2>> pieces_;  // of each plate, counter-clockwise
};

// One variable for every two panels that overlap: the first is above the second.
class LayerFormula {
 public:
  explicit LayerFormula(const FoldedFlat& flat) : flat_(flat), panels_(flat.linkage().num_panels()) {
    for (int f = 0; f < panels_; ++f)
      for (int g = f + 1; g < panels_; ++g)
        if (flat.overlap(f, g)) variable_[{f, g}] = static_cast<int>(variable_.size()) + 1;
    const int hinges = flat.linkage().num_hinges();
    for (int h = 0; h < hinges; ++h) {
      turn_to_its_side(h);
      for (int d = 0; d < panels_; ++d) keep_out(h, d);
      for (int k = h + 1; k < hinges; ++k)
        if (flat.lie_on_each_other(h, k)) keep_together(h, k);
    }
    stack();
  }

  SatAnswer solve(const Run& run) { return solver_.solve(run); }

  std::vector<FaceOrder> orders() {
    std::vector<FaceOrder> orders;
    for (const auto& [pair, variable] : variable_) {
      const bool is_above = solver_.holds(variable);
      orders.push_back({pair.first, pair.second, is_above != flat_.is_turned(pair.second) ? 1 : -1});
    }
    return orders;
  }

 private:
  bool is_folded(int h) const { return flat_.linkage().hinges[h].target != 0; }

  // The literal of "f is above g"; 0 when they do not overlap.
  int above(int f, int g) const {
    const auto found = variable_.find(std::minmax(f, g));
    return found == variable_.end() ? 0 : f < g ? found->second : -found->second;
  }

  void equal(int p, int q) {
    if (p == 0 || q == 0) return;
    solver_.add({p, -q});
    solver_.add({-p, q});
  }

  void turn_to_its_side(int h) {
    const Hinge& hinge = flat_.linkage().hinges[h];
    const int right_above = above(hinge.right, hinge.left);
    if (!is_folded(h) || right_above == 0) return;
    solver_.add({(hinge.target > 0) != flat_.is_turned(hinge.left) ? right_above : -right_above});
  }

  void keep_out(int h, int panel) {
    const Hinge& hinge = flat_.linkage().hinges[h];
    if (panel == hinge.left || panel == hinge.right || !flat_.runs_through(h, panel)) return;
    equal(above(hinge.left, panel), above(hinge.right, panel));
  }

  // Two creases in one place.
  void keep_together(int h, int k) {
    const Hinge &one = flat_.linkage().hinges[h], &other = flat_.linkage().hinges[k];
    if (one.left == other.left || one.left == other.right || one.right == other.left || one.right == other.right)
      return;
    if (is_folded(h) && is_folded(k)) {
      if (flat_.side(h, one.left, h) == flat_.side(k, other.left, h)) nest(one, other);
    } else if (is_folded(h)) {
      const int beside = flat_.side(k, other.left, h) == flat_.side(h, one.left, h) ? other.left : other.right;
      equal(above(one.left, beside), above(one.right, beside));
    } else if (is_folded(k)) {
      const int beside = flat_.side(h, one.left, h) == flat_.side(k, other.left, h) ? one.left : one.right;
      equal(above(other.left, beside), above(other.right, beside));
    } else {
      const bool same = flat_.side(h, one.left, h) == flat_.side(k, other.left, h);
      equal(above(one.left, same ? other.left : other.right), above(one.right, same ? other.right : other.left));
    }
  }

  // Both panels of the other crease are between those of the one, or neither is: an even number of the four hold.
  void nest(const Hinge& one, const Hinge& other) {
    const int p[] = {above(one.left, other.left), above(one.right, other.left), above(one.left, other.right),
                     above(one.right, other.right)};
    for (int literal : p)
      if (literal == 0) return;
    for (unsigned odd = 0; odd < 16; ++odd) {
      const auto bit = [&](int i) { return (odd >> i & 1U) != 0; };
      if ((bit(0) != bit(1)) != (bit(2) != bit(3)))
        solver_.add({bit(0) ? -p[0] : p[0], bit(1) ? -p[1] : p[1], bit(2) ? -p[2] : p[2], bit(3) ? -p[3] : p[3]});
    }
  }

  // Of three panels with a place in common none is above itself.
  void stack() {
    for (int f = 0; f < panels_; ++f)
      for (int g = f + 1; g < panels_; ++g) {
        const int fg = above(f, g);
        for (int h = g + 1; h < panels_ && fg != 0; ++h) {
          const int gh = above(g, h), hf = above(h, f);
          if (gh == 0 || hf == 0 || !flat_.overlap(f, g, h)) continue;
          solver_.add({-fg, -gh, -hf});
          solver_.add({fg, gh, hf});
        }
      }
  }

  const FoldedFlat& flat_;
  int panels_;
  std::map<std::pair<int, int>, int> variable_;
  SatSolver solver_;
};

}  // namespace

LayerOrder order_layers(const CreasePattern& sheet, const Run& run) {
  const Linkage linkage = make_linkage(sheet);
  LayerOrder result;
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    const double fold = std::abs(linkage.hinges[h].target);
    if (fold < kFlatGoal || std::abs(fold - kPi) < kFlatGoal) continue;
    result.flat_goal = false;
    result.why = fmt::format("the goal is not flat: {} folds by {:.4g} degrees", tell_hinge(linkage, h), degrees(fold));
    return result;
  }
  if (linkage.num_panels() > kMostLayered) {
    result.why = fmt::format("{} panels are more than {}", linkage.num_panels(), kMostLayered);
    return result;
  }
  const FoldedFlat folded(linkage);
  LayerFormula formula(folded);
  const SatAnswer answer = formula.solve(run);
  result.ending = run.ending();
  if (answer == SatAnswer::Satisfiable) {
    result.ending = Ending::Found;
    result.orders = formula.orders();
  } else if (answer == SatAnswer::Unsatisfiable) {
    result.ending = Ending::Exhausted;
    result.why = "no order of the layers keeps paper from passing through paper";
  }
  return result;
}

}  // namespace plico
