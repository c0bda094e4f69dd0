#include "plico/unfold/optimize.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/base/rng.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/geom/rectangle_fit.h"
#include "plico/mesh/measures.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/dual_tree.h"
#include "plico/unfold/handy_folds.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/hull_tracker.h"
#include "plico/unfold/overlap.h"
#include "plico/unfold/search.h"

namespace plico {
namespace {

// Temperatures at the start and at the end, times the number of panels: about what one panel changes in f.
struct Temperatures {
  double hot, cold;
};
constexpr Temperatures kForHull{3, 0.03}, kForLengths{1, 0.01};
constexpr long kStepsAPanel = 2000, kMostSteps = 600'000;
// Share of the steps that start from a panel on the hull, when hull or box count; and how far they climb.
constexpr double kFromHull = 0.7, kClimb = 0.9;
// What one weak fold or needle weighs, against all that the hull weighs at the start.
constexpr double kFault = 0.06;
// How often on the way a net that folds is looked at closely: twice as often takes a third more time and gains nothing.
constexpr int kLooks = 8;
constexpr int kMostProofs = 3;  // of one look

double interior_length(const Mesh& mesh) {
  double sum = 0;
  for (EdgeId e : mesh.edges()) sum += mesh.is_boundary(e) ? 0 : length(mesh, e);
  return sum;
}

double fold_length(const Mesh& mesh, const FoldForest& forest) {
  double sum = 0;
  for (EdgeId e : mesh.edges()) sum += forest.is_fold[e] ? length(mesh, e) : 0;
  return sum;
}

double box_area(const std::vector<Vec2>& hull) {
  const Vec2 size = least_area_rectangle(hull).size;
  return size.x() * size.y();
}

// The smallest sheet of office paper, in any size, upright along some side of the hull.
double sheet_area(const std::vector<Vec2>& hull) {
  constexpr double kSqrt2 = 1.4142135623730951;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 along = (hull[(i + 1) % hull.size()] - hull[i]).normalized(), up = perpendicular(along);
    double low = 0, high = 0, height = 0;
    for (const Vec2& p : hull) {
      const double x = along.dot(p - hull[i]);
      low = std::min(low, x);
      high = std::max(high, x);
      height = std::max(height, up.dot(p - hull[i]));
    }
    const double width = high - low;
    least = std::min({least, std::max(width, height / kSqrt2), std::max(height, width / kSqrt2)});
  }
  return hull.empty() ? 0 : kSqrt2 * least * least;
}

int deepest(const DualTree& tree) {
  int depth = 0;
  for (int f = 0; f < tree.mesh().num_faces(); ++f) depth = std::max(depth, tree.depth(f));
  return depth;
}

NetFeatures features_of(const DualTree& tree, const HullTracker& hulls, const HandyFolds& handy, double cut_length) {
  const HandFaults faults = handy.all();
  NetFeatures features{.cut_length = cut_length,
                       .longest_branch = static_cast<double>(deepest(tree)),
                       .weak_folds = faults.weak_folds,
                       .needles = faults.needles};
  for (const Hull2& hull : hulls.hulls()) {
    features.hull_area += signed_area(hull);
    features.box_area += box_area(hull);
    features.sheet_area += sheet_area(hull);
  }
  return features;
}

// f of [Xi17] 5.5, with weights divided by the features of the net to be improved.
struct Objective {
  NetFeatures weight;

  Objective(const NetFeatures& w, const NetFeatures& start) {
    const double sum = w.cut_length + w.hull_area + w.box_area + w.longest_branch + w.sheet_area;
    const auto scaled = [&](double one, double value) { return value > 0 ? one / (std::max(sum, 1e-9) * value) : 0; };
    weight = {scaled(w.cut_length, start.cut_length),
              scaled(w.hull_area, start.hull_area),
              scaled(w.box_area, start.box_area),
              scaled(w.longest_branch, start.longest_branch),
              scaled(w.sheet_area, start.sheet_area),
              kFault * w.weak_folds,
              kFault * w.needles};
  }
  double operator()(const NetFeatures& x) const {
    return weight.cut_length * x.cut_length + weight.hull_area * x.hull_area + weight.box_area * x.box_area +
           weight.longest_branch * x.longest_branch + weight.sheet_area * x.sheet_area +
           weight.weak_folds * x.weak_folds + weight.needles * x.needles;
  }
  bool needs_hull() const { return weight.hull_area > 0 || weight.box_area > 0 || weight.sheet_area > 0; }
  bool needs_hands() const { return weight.weak_folds > 0 || weight.needles > 0; }
};

struct Candidate {
  FoldForest net;
  double value = 0;
};

bool is_clean(const FlatFaces& faces, const FoldForest& tree) {
  return overlapping_pairs(faces, lay_panels(faces, tree)).empty();
}

// One lane: simulated annealing from one net. The best net is looked for once in as many steps as there are panels,
// where its fresh layout can be checked for the price of a few steps.
class Annealing {
 public:
  // With a motion cost the best net is one that folds, as the start is.
  Annealing(const FlatFaces& faces, const Objective& objective, const OptimizeOptions& options, Candidate start,
            Rng rng, std::unique_ptr<MotionCost> motion = nullptr)
      : faces_(faces),
        mesh_(faces.mesh()),
        objective_(objective),
        options_(options),
        best_(std::move(start)),
        rng_(rng),
        motion_(std::move(motion)) {
    if (motion_) folds_ = best_;
    for (EdgeId e : mesh_.edges()) edge_length_.push_back(length(mesh_, e));
    whole_length_ = interior_length(mesh_);
  }

  Candidate go(long steps, const Run& run) {
    const int n = mesh_.num_faces();
    if (n < 2) return std::move(best_);
    const auto [hot, cold] = objective_.needs_hull() ? kForHull : kForLengths;
    const long block = std::max(n, 256);
    long next_look = steps / kLooks;
    for (long done = 0; done < steps; done += block) {
      if (run.over()) break;
      if (motion_ && done >= next_look) {
        look_closer(run);
        next_look += steps / kLooks;
      }
      if (!tree_) set_out();
      for (long step = done; step < std::min(steps, done + block); ++step) {
        const double cooling = static_cast<double>(step) / static_cast<double>(steps);
        try_one(hot * plico::pow(cold / hot, cooling) / n);
      }
      keep_if_best();
    }
    if (!motion_) return std::move(best_);
    look_closer(run);
    return std::move(folds_);
  }

 private:
  void set_out() {
    tree_ = std::make_unique<DualTree>(faces_, best_.net);
    hull_ = std::make_unique<HullTracker>(*tree_, options_.cuts);
    handy_ = std::make_unique<HandyFolds>(*tree_, options_.shortest_fold);
    now_ = features_of(*tree_, *hull_, *handy_, whole_length_ - fold_length(mesh_, best_.net));
    value_ = objective_(now_);
    if (motion_) motion_->reset(best_.net);
  }

  // Of the nets found since the last look, the best that folds for certain: one that does not is known better then, and
  // so are those that share its fault. The search sets out again from there.
  void look_closer(const Run& run) {
    int looks = 0;
    for (auto at = better_.rbegin(); at != better_.rend() && looks < kMostProofs && !run.over(); ++at) {
      motion_->reset(at->net);
      if (motion_->cost() > 0) continue;
      ++looks;
      if (motion_->look_closer(at->net, run) != MotionCost::Closer::Free) continue;
      folds_ = *at;
      break;
    }
    better_.clear();
    best_ = folds_;
    tree_.reset();
  }

  void keep_if_best() {
    if (value_ < best_.value) {
      FoldForest net = tree_->forest();
      if (is_clean(faces_, net)) {
        best_ = {std::move(net), value_};
        if (motion_) better_.push_back(best_);
      } else {
        tree_.reset();  // rounding of many moves: set out again from the best
      }
    }
    if (!tree_) return;
    const int root = tree_->root();
    tree_->balance();
    if (tree_->root() == root || objective_.weight.longest_branch == 0) return;
    now_.longest_branch = deepest(*tree_);
    value_ = objective_(now_);
  }

  // Hangs a branch elsewhere if that overlaps nothing and f grows by no more than chance allows at this temperature.
  void try_one(double temperature) {
    const int panel = pick_branch();
    if (!may_move(panel)) return;
    tree_->gather(panel);
    const int hangs_by = tree_->parent_side(panel), side = pick_side(hangs_by);
    if (side < 0) return;
    const double bound = value_ - temperature * plico::log(1 - rng_.uniform());
    NetFeatures next = now_;
    next.cut_length += edge_length_[mesh_.edge(HalfedgeId(hangs_by))] - edge_length_[mesh_.edge(HalfedgeId(side))];
    if (objective_.weight.longest_branch > 0) next.longest_branch = deepest_if_hung(side);
    if (objective_.needs_hands()) {
      const HandFaults change = handy_->change_if_hung(side);
      next.weak_folds += change.weak_folds;
      next.needles += change.needles;
    }
    if (objective_.needs_hull()) measure(hull_->least_if_hung(side), next);
    if (objective_(next) > bound) return;
    long looked = 0;
    if (tree_->overlaps_if_hung(side, 1, looked) > 0) return;
    if (objective_.needs_hull()) {
      const HullTracker::Change& change = hull_->all_if_hung(side);
      measure(change, next);
      if (objective_(next) > bound || !fits(change.gained)) return;
    }
    if (motion_) {
      if (motion_->cost_if_hung(tree_->branch(), side, 0) > 0) return;
      motion_->hang(tree_->branch(), side);
    }
    tree_->hang(side);
    if (objective_.needs_hull()) hull_->accept();
    now_ = next;
    value_ = objective_(now_);
  }

  bool is_cut(int side) const { return !options_.cuts.empty() && options_.cuts[mesh_.edge(HalfedgeId(side))]; }

  bool fits(const Hull2& hull) const { return options_.cuts.empty() || angle_that_fits(hull, options_.room); }

  void measure(const HullTracker::Change& change, NetFeatures& features) const {
    const auto changed = [&](double now, auto&& size) {
      double sum = now + size(change.gained) - size(hull_->hulls()[change.to]);
      if (change.from != change.to) sum += size(change.left) - size(hull_->hulls()[change.from]);
      return sum;
    };
    features.hull_area = changed(now_.hull_area, [](const Hull2& hull) { return signed_area(hull); });
    if (objective_.weight.box_area > 0) features.box_area = changed(now_.box_area, box_area);
    if (objective_.weight.sheet_area > 0) features.sheet_area = changed(now_.sheet_area, sheet_area);
  }

  int pick_branch() {
    int panel = rng_.below(mesh_.num_faces());
    if (!objective_.needs_hull() || rng_.uniform() >= kFromHull) return panel;
    panel = hull_->panels()[rng_.below(static_cast<int>(hull_->panels().size()))];
    for (int above = tree_->parent(panel); above >= 0 && may_move(above) && rng_.uniform() < kClimb;
         above = tree_->parent(panel))
      panel = above;
    return panel;
  }

  // The root and what hangs by a cut stay where they are.
  bool may_move(int panel) const { return tree_->parent_side(panel) >= 0 && !is_cut(tree_->parent_side(panel)); }

  // One of the sides by which the gathered branch could hang, all equally likely; -1 when there is none.
  int pick_side(int hangs_by) {
    int chosen = -1, seen = 0;
    const int piece = hull_->piece(tree_->branch().front());
    for (int f : tree_->branch()) {
      if (hull_->piece(f) != piece) continue;  // it hangs by a cut
      for (HalfedgeId h : mesh_.halfedges(FaceId(f))) {
        const HalfedgeId g = mesh_.twin(h);
        if (!g.valid() || h == hangs_by || tree_->gathered(mesh_.face(g))) continue;
        if (rng_.below(++seen) == 0) chosen = h;
      }
    }
    return chosen;
  }

  // The greatest depth if the gathered branch were hung by `side`; the root stays.
  int deepest_if_hung(int side) {
    const FaceId beside = mesh_.face(mesh_.twin(HalfedgeId(side)));
    int depth = 0;
    for (int f = 0; f < mesh_.num_faces(); ++f)
      if (!tree_->gathered(f)) depth = std::max(depth, tree_->depth(f));
    order_.assign(1, {mesh_.face(HalfedgeId(side)), -1, tree_->depth(beside) + 1});
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Placed at = order_[i];
      depth = std::max(depth, at.depth);
      for (HalfedgeId h : mesh_.halfedges(FaceId(at.panel))) {
        const HalfedgeId g = mesh_.twin(h);
        if (!g.valid()) continue;
        const int other = mesh_.face(g);
        if (other == at.from || !tree_->gathered(other)) continue;
        if (tree_->parent_side(other) == g || tree_->parent_side(at.panel) == h)
          order_.push_back({other, at.panel, at.depth + 1});
      }
    }
    return depth;
  }

  struct Placed {
    int panel, from, depth;
  };

  const FlatFaces& faces_;
  const Mesh& mesh_;
  const Objective& objective_;
  const OptimizeOptions& options_;
  Candidate best_, folds_;
  std::vector<Candidate> better_;  // since the last look, the best last
  Rng rng_;
  std::unique_ptr<MotionCost> motion_;
  std::vector<double> edge_length_;
  double whole_length_ = 0;
  std::unique_ptr<DualTree> tree_;
  std::unique_ptr<HullTracker> hull_;
  std::unique_ptr<HandyFolds> handy_;
  NetFeatures now_;
  double value_ = 0;
  std::vector<Placed> order_;
};

NetFeatures features(const FlatFaces& faces, const FoldForest& tree, double shortest_fold,
                     const std::vector<char>& cuts = {}) {
  const DualTree laid(faces, tree);
  return features_of(laid, HullTracker(laid, cuts), HandyFolds(laid, shortest_fold),
                     interior_length(faces.mesh()) - fold_length(faces.mesh(), tree));
}

// The given net and those grown afresh, best first. A net grown from long folds is often much better than one bent into
// shape from a poor one.
std::vector<Candidate> starts(const FlatFaces& faces, const FoldForest& net, const Objective& objective,
                              const OptimizeOptions& options, const Run& run) {
  std::vector<Candidate> all(options.starts + 1,
                             {net, objective(features(faces, net, options.shortest_fold, options.cuts))});
  parallel_for(run, options.starts, [&](int i) {
    if (run.over()) return;
    const SearchOptions search{
        .seed = Rng(options.seed).stream(i).next(), .starts = 1, .grow_by = Heuristic::MinimumPerimeter};
    SearchResult found = find_net(faces.mesh(), search, run);
    if (found.ending != Ending::Found) return;
    const double value = objective(features(faces, found.forest, options.shortest_fold));
    all[i + 1] = {std::move(found.forest), value};
  });
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
  return all;
}

OptimizeResult improve(const Mesh& mesh, const FoldForest& net,
                       const std::function<std::unique_ptr<MotionCost>()>& new_cost, const OptimizeOptions& options,
                       const Run& run) {
  check(options);
  if (!options.cuts.empty() && (options.starts > 0 || static_cast<int>(options.cuts.size()) != mesh.num_edges()))
    throw InvalidOption(fmt::format("cuts: {} for {} edges, and {} starts, must be one an edge and no start",
                                    options.cuts.size(), mesh.num_edges(), options.starts));
  if (count_parts(mesh, net) != 1) throw InvalidInput("optimize/not-a-net", "the forest is not one spanning tree");
  const FlatFaces faces(mesh);
  if (!is_clean(faces, net)) throw InvalidInput("optimize/overlap", "the unfolding to be optimized overlaps itself");

  OptimizeResult result;
  result.before = features(faces, net, options.shortest_fold, options.cuts);
  const Objective objective(options.weights, result.before);
  const std::vector<Candidate> from = starts(faces, net, objective, options, run);
  const long steps = options.steps >= 0 ? options.steps : std::min(kStepsAPanel * mesh.num_faces(), kMostSteps);
  std::vector<Candidate> lanes(options.lanes);
  parallel_for(run, options.lanes, [&](int i) {
    const Candidate& start = from[std::min<std::size_t>(i, from.size() - 1)];
    lanes[i] = Annealing(faces, objective, options, start, Rng(options.seed).stream(options.starts + i),
                         new_cost ? new_cost() : nullptr)
                   .go(steps, run);
  });
  const auto best = std::min_element(lanes.begin(), lanes.end(),
                                     [](const Candidate& a, const Candidate& b) { return a.value < b.value; });
  result.forest = std::move(best->net);
  result.after = features(faces, result.forest, options.shortest_fold, options.cuts);
  if (run.over()) result.ending = run.ending();
  return result;
}

}  // namespace

NetFeatures net_features(const Mesh& mesh, const FoldForest& tree, double shortest_fold) {
  return features(FlatFaces(mesh), tree, shortest_fold);
}

double least_cut_length(const Mesh& mesh) {
  std::vector<double> weights;
  for (EdgeId e : mesh.edges()) weights.push_back(-length(mesh, e));
  return interior_length(mesh) - fold_length(mesh, lightest_forest(mesh, weights));
}

void check(const OptimizeOptions& options) {
  const NetFeatures& w = options.weights;
  const double lengths_and_areas = w.cut_length + w.hull_area + w.box_area + w.longest_branch + w.sheet_area;
  for (double weight : {w.cut_length, w.hull_area, w.box_area, w.longest_branch, w.sheet_area, w.weak_folds, w.needles})
    if (!(weight >= 0)) throw InvalidOption(fmt::format("weight = {} must be at least 0", weight));
  if (!(lengths_and_areas + w.weak_folds + w.needles > 0)) throw InvalidOption("weights: at least one must be above 0");
  if (options.steps < -1) throw InvalidOption(fmt::format("steps = {} must be at least -1", options.steps));
  if (options.lanes < 1) throw InvalidOption(fmt::format("lanes = {} must be at least 1", options.lanes));
  if (options.starts < 0) throw InvalidOption(fmt::format("starts = {} must be at least 0", options.starts));
  if (!(options.shortest_fold >= 0))
    throw InvalidOption(fmt::format("shortest_fold = {} must be at least 0", options.shortest_fold));
}

NetFeatures weights_for(std::string_view wish) {
  if (wish == "cut-length") return {.cut_length = 1};
  if (wish == "hull-area") return {.hull_area = 1};
  if (wish == "page") return {.box_area = 1};
  if (wish == "hands") return {.hull_area = 1, .sheet_area = 1, .weak_folds = 1, .needles = 1};
  throw InvalidOption(fmt::format("optimize {} is not known: cut-length, hull-area, page or hands", wish));
}

OptimizeResult optimize_net(const Mesh& mesh, const FoldForest& net, const OptimizeOptions& options, const Run& run) {
  return improve(mesh, net, nullptr, options, run);
}

OptimizeResult optimize_foldable_net(const Mesh& mesh, const FoldForest& net,
                                     const std::function<std::unique_ptr<MotionCost>()>& new_cost,
                                     const OptimizeOptions& options, const Run& run) {
  OptimizeOptions own = options;
  own.starts = 0;
  return improve(mesh, net, new_cost, own, run);
}

}  // namespace plico
