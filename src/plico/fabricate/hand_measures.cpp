#include "plico/fabricate/hand_measures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/libm.h"
#include "plico/fabricate/net_sides.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

class HandSurvey {
 public:
  HandSurvey(const Unfolding& net, double scale) : net_(net), sides_(net), scale_(scale) {}

  HandMeasures run() {
    measure_areas();
    measure_folds();
    for (int part = 0; part < net_.num_parts(); ++part) bound_weak_folds(part);
    for (int f = 0; f < net_.sheet.num_faces(); ++f) result_.needles += hangs_by_short_side(f);
    for (const auto& part : sides_.outlines())
      for (const auto& loop : part) measure_notches(loop);
    return result_;
  }

  // From the ends of the branches on: what is cut off is carried by no fold any more.
  std::vector<char> weak_folds() const {
    std::vector<char> weak(net_.sheet.num_edges(), 0);
    std::vector<int> holder, held_by, hangs(net_.sheet.num_faces(), 1), left(net_.num_parts(), 0);
    const std::vector<int> order = walk(holder, held_by);
    for (int f : order) ++left[net_.part[f]];
    for (auto at = order.rbegin(); at != order.rend(); ++at) {
      if (holder[*at] < 0) continue;
      int& rest = left[net_.part[*at]];
      const bool carries = std::min(hangs[*at], rest - hangs[*at]) > kLightBranchPanels;
      if (carries && side_length(sides_.side(held_by[*at])) < kShortestFold) {
        weak[held_by[*at]] = 1;
        rest -= hangs[*at];
      } else {
        hangs[holder[*at]] += hangs[*at];
      }
    }
    return weak;
  }

 private:
  double side_length(PanelSide s) const { return scale_ * (sides_.to(s) - sides_.from(s)).norm(); }

  void measure_areas() {
    std::vector<double> covered(net_.num_parts(), 0);
    std::vector<std::vector<Vec2>> points(net_.num_parts());
    for (int f = 0; f < net_.sheet.num_faces(); ++f) {
      const std::vector<Vec2> corners = polygon(net_.sheet, f);
      covered[net_.part[f]] += scale_ * scale_ * signed_area(corners);
      points[net_.part[f]].insert(points[net_.part[f]].end(), corners.begin(), corners.end());
    }
    for (int p = 0; p < net_.num_parts(); ++p) {
      const double hull = scale_ * scale_ * signed_area(convex_hull(std::move(points[p])));
      result_.net_area += covered[p];
      result_.hull_area += hull;
      if (hull <= 0) continue;
      result_.fullest = std::max(result_.fullest, covered[p] / hull);
      result_.emptiest = std::min(result_.emptiest, covered[p] / hull);
    }
  }

  // Panels in an order in which each comes after the one that holds it; empty when folds close loops.
  std::vector<int> walk(std::vector<int>& holder, std::vector<int>& held_by) const {
    const int n = net_.sheet.num_faces();
    holder.assign(n, -1);
    held_by.assign(n, -1);
    std::vector<char> seen(n, 0);
    std::vector<int> order;
    int folds = 0;
    for (int e = 0; e < net_.sheet.num_edges(); ++e) folds += sides_.side(e).panel >= 0 && sides_.is_fold(e);
    if (folds != n - net_.num_parts()) return {};
    for (int root = 0; root < n; ++root) {
      if (seen[root]) continue;
      seen[root] = 1;
      order.push_back(root);
      for (std::size_t i = order.size() - 1; i < order.size(); ++i) {
        for (int e : sides_.edges(order[i])) {
          if (!sides_.is_fold(e)) continue;
          const int a = sides_.side(e).panel, other = a == order[i] ? sides_.second_side(e).panel : a;
          if (seen[other]) continue;
          seen[other] = 1;
          holder[other] = order[i];
          held_by[other] = e;
          order.push_back(other);
        }
      }
    }
    return order;
  }

  void measure_folds() {
    std::vector<int> holder, held_by, hangs(net_.sheet.num_faces(), 1), whole(net_.num_parts(), 0);
    const std::vector<int> order = walk(holder, held_by);
    for (int f : order) ++whole[net_.part[f]];
    for (auto at = order.rbegin(); at != order.rend(); ++at) {
      if (holder[*at] < 0) continue;
      hangs[holder[*at]] += hangs[*at];
      if (std::min(hangs[*at], whole[net_.part[*at]] - hangs[*at]) <= kLightBranchPanels) continue;
      const double fold = side_length(sides_.side(held_by[*at]));
      if (result_.shortest_carrying == 0 || fold < result_.shortest_carrying) result_.shortest_carrying = fold;
      result_.weak += fold < kShortestFold;
    }
  }

  // Panels of the same part that share an edge of the shape with this one, by a fold or a seam.
  template <class Visit>
  void visit_neighbours(int panel, const Visit& visit) const {
    for (int i = 0; i < static_cast<int>(sides_.edges(panel).size()); ++i) {
      const int e = sides_.edge(panel, i);
      const int first = sides_.side(e).panel;
      int other = first == panel ? sides_.second_side(e).panel : first;
      if (!sides_.is_fold(e)) other = net_.mate[e] >= 0 ? sides_.side(net_.mate[e]).panel : -1;
      if (other >= 0 && other != panel && net_.part[other] == net_.part[panel]) visit(other, side_length({panel, i}));
    }
  }

  // Pieces of a part that hang together by edges of kShortestFold and more, numbered.
  std::vector<int> strong_pieces() const {
    std::vector<int> piece(net_.sheet.num_faces(), -1);
    for (int first = 0, count = 0; first < net_.sheet.num_faces(); ++first) {
      if (piece[first] >= 0) continue;
      piece[first] = count;
      for (std::vector<int> open{first}; !open.empty();) {
        const int at = open.back();
        open.pop_back();
        visit_neighbours(at, [&](int other, double length) {
          if (length < kShortestFold || piece[other] >= 0) return;
          piece[other] = count;
          open.push_back(other);
        });
      }
      ++count;
    }
    return piece;
  }

  std::vector<int> pieces_within_light_branch(int panel, const std::vector<int>& piece) const {
    std::vector<int> reached{panel};
    for (int step = 0; step < kLightBranchPanels; ++step)
      for (std::size_t i = 0, n = reached.size(); i < n; ++i)
        visit_neighbours(reached[i], [&](int other, double) { reached.push_back(other); });
    for (int& at : reached) at = piece[at];
    std::sort(reached.begin(), reached.end());
    reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
    return reached;
  }

  // Cut a net at its weak folds, and each of what is left is one strong piece, or some of it, with light branches:
  // every panel is within kLightBranchPanels steps of such a piece. Panels that have none of these pieces in common
  // need one each, and a weak fold between any two.
  void bound_weak_folds(int part) {
    std::vector<int> panels;
    for (int f = 0; f < net_.sheet.num_faces(); ++f)
      if (net_.part[f] == part) panels.push_back(f);
    if (static_cast<int>(panels.size()) < 2 * (kLightBranchPanels + 1)) return;  // no fold carries anything
    if (strong_.empty()) strong_ = strong_pieces();
    std::vector<std::vector<int>> near;
    for (int f : panels) near.push_back(pieces_within_light_branch(f, strong_));
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    std::vector<char> taken(net_.sheet.num_faces(), 0);
    int apart = 0;
    for (const std::vector<int>& pieces : near) {
      if (std::any_of(pieces.begin(), pieces.end(), [&](int p) { return taken[p] != 0; })) continue;
      for (int p : pieces) taken[p] = 1;
      ++apart;
    }
    result_.least_weak += apart - 1;
  }

  bool hangs_by_short_side(int panel) const {
    const int n = static_cast<int>(sides_.edges(panel).size());
    double least = 0, most = 0, joinable = 0, folded = 0;
    for (int i = 0; i < n; ++i) {
      const int e = sides_.edge(panel, i);
      const double length = side_length({panel, i});
      least = i == 0 ? length : std::min(least, length);
      most = std::max(most, length);
      if (sides_.is_fold(e)) folded = std::max(folded, length);
      if (sides_.is_fold(e) || net_.mate[e] >= 0) joinable = std::max(joinable, length);
    }
    return most > 3 * least && folded > 0 && folded < joinable / 2;
  }

  // The part is on the left of its outline, so a notch is where it turns right by nearly a half turn.
  void measure_notches(const std::vector<int>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PanelSide in = sides_.side(loop[i]), out = sides_.side(loop[(i + 1) % loop.size()]);
      const Vec2 back = sides_.from(in) - sides_.to(in), on = sides_.to(out) - sides_.from(out);
      const double open = plico::atan2(cross(back, on), back.dot(on));  // of the notch, where it is one
      if (open < -1e-9 || open >= kTightest || side_length(in) < kLongEnough || side_length(out) < kLongEnough)
        continue;
      result_.tight_seams += (net_.mate[loop[i]] >= 0) + (net_.mate[loop[(i + 1) % loop.size()]] >= 0);
    }
  }

  const Unfolding& net_;
  const NetSides sides_;
  const double scale_;
  std::vector<int> strong_;  // piece of each panel, once it is asked for
  HandMeasures result_;
};

}  // namespace

HandMeasures measure_for_hands(const Unfolding& net, double scale) { return HandSurvey(net, scale).run(); }

std::vector<char> weak_folds(const Unfolding& net, double scale) { return HandSurvey(net, scale).weak_folds(); }

nlohmann::json json_of(const HandMeasures& m) {
  return {{"area_over_hull", m.hull_area > 0 ? m.net_area / m.hull_area : 1},
          {"area_over_hull_worst_part", m.emptiest},
          {"shortest_carrying_fold_mm", m.shortest_carrying},
          {"folds_under_5_mm_that_carry_a_branch", m.weak},
          {"no_net_has_fewer_than", m.least_weak},
          {"needles_by_their_short_side", m.needles},
          {"seams_in_tight_corners", m.tight_seams}};
}

}  // namespace plico
