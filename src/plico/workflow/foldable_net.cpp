#include "plico/workflow/foldable_net.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/mesh/measures.h"
#include "plico/motion/clear_trees.h"
#include "plico/motion/collision.h"
#include "plico/unfold/count_cuts.h"
#include "plico/unfold/foldable.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/search.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

constexpr double kGoldenRatio = 0.6180339887498949;  // of the smaller part: its multiples spread evenly
// Planners that find a motion of such a net find it early; plico fold tries harder.
constexpr double kPlanningEffort = 0.25;
constexpr int kMostPlannedLate = 10'000;        // faces: no motion of more is planned when the run is over
constexpr long kStepsBeforeAllTrees = 100'000;  // well below a second

long steps_for(const Mesh& mesh) { return 20'000 + std::min(300L * mesh.num_faces(), 1'500'000L); }

PanelKit kit_of(const Mesh& mesh) {
  PanelKit kit;
  for (FaceId f : mesh.faces()) {
    const Vec3 up = normal(mesh, f);
    const HalfedgeId first = *mesh.halfedges(f).begin();
    const Vec3& origin = mesh.point(mesh.from(first));
    const Vec3 x = (mesh.point(mesh.to(first)) - origin).normalized();
    const Vec3 y = up.cross(x);
    std::vector<Vec2>& outline = kit.outlines.emplace_back();
    for (HalfedgeId h : mesh.halfedges(f)) {
      const Vec3 d = mesh.point(mesh.from(h)) - origin;
      outline.emplace_back(d.dot(x), d.dot(y));
      kit.twin.push_back(mesh.twin(h));
      kit.fold_angle.push_back(mesh.twin(h).valid() ? fold_angle(mesh, mesh.edge(h)) : 0);
    }
    kit.first_side.push_back(static_cast<int>(kit.twin.size()));
  }
  return kit;
}

// The nets that searches side by side have proven free, so that the one they hand out is not proven a second time.
class FreeNets {
 public:
  void add(const FoldForest& tree, const PathProof& proof) {
    const std::lock_guard lock(mutex_);
    proofs_.emplace_back(tree, proof);
  }

  std::optional<PathProof> proof_of(const FoldForest& tree) const {
    const auto at =
        std::find_if(proofs_.begin(), proofs_.end(), [&](const auto& known) { return known.first == tree; });
    return at == proofs_.end() ? std::nullopt : std::optional(at->second);
  }

 private:
  std::mutex mutex_;
  std::vector<std::pair<FoldForest, PathProof>> proofs_;
};

// Counts collisions at samples of the motion; looks closer by more samples and in the end by the proof.
class SampledCost : public MotionCost {
 public:
  SampledCost(const Mesh& mesh, const PanelKit& kit, const FoldableNetOptions& options, double clearance,
              FreeNets* free_nets = nullptr)
      : mesh_(mesh),
        options_(options),
        clearance_(clearance),
        free_nets_(free_nets),
        sampler_(kit, options.law, clearance, 1e-3 * clearance) {
    for (int i = 0; i < options.samples; ++i) sampler_.add_sample((i + 0.5) / options.samples);
  }

  void reset(const FoldForest& tree) override {
    std::vector<char> joined(mesh_.num_halfedges());
    for (int h = 0; h < mesh_.num_halfedges(); ++h) joined[h] = tree.is_fold[mesh_.edge(HalfedgeId(h))];
    sampler_.reset(joined);
  }
  long cost() const override { return static_cast<long>(sampler_.conflicts().size()); }
  std::pair<int, int> conflict(long i) const override {
    const BranchSampler::Conflict& c = sampler_.conflicts()[i];
    return {c.panel_a, c.panel_b};
  }
  long cost_across(std::span<const int> branch) override { return sampler_.conflicts_across(branch); }
  long cost_if_hung(std::span<const int> branch, int side, long limit) override {
    return sampler_.conflicts_if_hung(branch, side, limit);
  }
  void hang(std::span<const int> branch, int side) override { sampler_.hang(branch, side); }
  long work() const override { return sampler_.work() + looked_at_; }

  Closer look_closer(const FoldForest& tree, const Run& run) override {
    const Linkage linkage = linkage_of(lay_flat(mesh_, tree));
    const FoldingPath path = path_by(options_.law, linkage);
    CollisionChecker checker(linkage, {.clearance = clearance_});
    sampler_.keep_samples(std::max(options_.samples, scaled(24, 64)));
    // Other moments at every look: the same ones would let through what the last net already had between them.
    const double shift = std::fmod(0.25 + kGoldenRatio * looks_++, 1);
    const int checks = 8 * options_.samples;
    for (int i = 0, seen = 0; i < checks && seen < scaled(4, 12) && !run.over(); ++i) {
      const double time = (i + shift) / checks;
      looked_at_ += 2L * mesh_.num_faces();
      if (!checker.collides(path.at(time))) continue;
      sampler_.add_sample(time);
      ++seen;
    }
    if (cost() > 0) return Closer::Seen;
    const PathProof proof = prove_path(linkage, path, {.clearance = clearance_}, run);
    looked_at_ += proof.pair_intervals;
    if (proof.verdict == PathVerdict::Free) {
      if (free_nets_) free_nets_->add(tree, proof);
      return Closer::Free;
    }
    if (proof.verdict == PathVerdict::Undecided) return Closer::Unclear;
    sampler_.add_sample(proof.to);
    return cost() > 0 ? Closer::Seen : Closer::Unclear;
  }

 private:
  // Larger meshes need more moments: from `few` for 2,000 faces and less to `many` for 5,000 and more.
  int scaled(int few, int many) const {
    const double share = std::clamp((mesh_.num_faces() - 2000) / 3000.0, 0.0, 1.0);
    return few + static_cast<int>(share * (many - few));
  }

  const Mesh& mesh_;
  const FoldableNetOptions& options_;
  double clearance_;
  FreeNets* free_nets_;  // not owned; null: nobody asks
  BranchSampler sampler_;
  long looks_ = 0;
  long looked_at_ = 0;  // panels by checks, pairs by proofs; each takes about as long as the sampler for one unit
};

// Replaces `found` by a net that folds if there is one. False when there is certainly none.
bool look_at_all_trees(const Mesh& mesh, const PanelKit& kit, FoldingLaw law, double clearance, const Run& run,
                       FoldableResult& found) {
  run.report("looking at every spanning tree", 0);
  bool any_clear = false;
  const auto proves_free = [&](const std::vector<char>& joined) {
    FoldForest tree{std::vector<char>(mesh.num_edges(), 0)};
    for (int h = 0; h < mesh.num_halfedges(); ++h)
      if (joined[h]) tree.is_fold[mesh.edge(HalfedgeId(h))] = 1;
    const Unfolding net = lay_flat(mesh, tree);
    // Motions are judged with panels drawn in by the clearance, so a tree whose flat panels overlap by less is clear.
    if (!verify_net(net, mesh).valid()) return false;
    any_clear = true;
    const Linkage linkage = linkage_of(net);
    if (prove_path(linkage, path_by(law, linkage), {.clearance = clearance}, run).verdict != PathVerdict::Free)
      return false;
    found.tree = std::move(tree);
    found.overlaps = found.collisions = 0;
    return true;
  };
  const ClearTreesOptions options{.law = law, .clearance = clearance, .touch = 1e-3 * clearance};
  const ClearTrees trees = find_clear_trees(kit, options, proves_free, run);
  if (trees.ending != Ending::Exhausted) found.ending = trees.ending;
  return any_clear || !trees.complete;
}

// The best motion of one piece, proven or not; none for several.
std::optional<Motion> planned_motion(const Mesh& mesh, const FoldForest& tree, const FoldableNetOptions& options,
                                     const Run& run) {
  const Linkage linkage = linkage_of(lay_flat(mesh, tree));
  if (linkage.num_hinges() + 1 < static_cast<int>(linkage.panels.size())) return {};
  const MotionOptions planning{.seed = options.seed, .clearance = options.clearance, .effort = kPlanningEffort};
  return plan(linkage, planning, run).motions.front();
}

// Where no time is left: a search would take some seconds on a large mesh before it looks at the clock.
FoldableNet net_without_search(const Mesh& mesh, const FoldableNetOptions& options, const Run& run) {
  FoldableNet result;
  result.tree = find_net(mesh, {.seed = options.seed}, run).forest;
  result.path = path_by(options.law, linkage_of(lay_flat(mesh, result.tree)));
  result.ending = run.ending();
  return result;
}

// The planner gets the rest of the time.
Run leaving_a_quarter(const Run& run) {
  const std::chrono::duration<double> left = *run.deadline - Run::Clock::now();
  return limited(run, 0.75 * std::max(0.0, left.count()));
}

}  // namespace

std::vector<std::pair<int, int>> crossing_faces(const Mesh& mesh, double clearance) {
  const FoldForest any = lightest_forest(mesh, std::vector<double>(mesh.num_edges(), 1));
  const Linkage linkage = linkage_of(lay_flat(mesh, any));
  std::vector<std::pair<int, int>> pairs;
  for (const PanelPair& pair : CollisionChecker(linkage, {.clearance = clearance}).collisions(goal(linkage))) {
    bool neighbours = false;
    for (HalfedgeId h : mesh.halfedges(FaceId(pair.a)))
      neighbours = neighbours || (mesh.twin(h).valid() && mesh.face(mesh.twin(h)) == FaceId(pair.b));
    if (!neighbours) pairs.emplace_back(pair.a, pair.b);
  }
  return pairs;
}

Linkage linkage_of(const Unfolding& net) { return make_linkage(net.sheet, net.mate); }

FoldingPath path_by(FoldingLaw law, const Linkage& linkage) {
  return law == FoldingLaw::Linear ? linear_path(linkage) : uniform_path(linkage);
}

FoldableNet find_foldable_net(const Mesh& mesh, const FoldableNetOptions& options, const Run& run) {
  if (components(mesh).count != 1)
    throw InvalidInput("unfold/components",
                       fmt::format("the mesh has {} components, a foldable net needs one", components(mesh).count), {},
                       "plico unfold --foldable none");
  const PanelKit kit = kit_of(mesh);
  const double clearance = options.clearance > 0 ? options.clearance : default_clearance(loose_panels(kit));
  FoldableNet result;
  if (run.over()) return net_without_search(mesh, options, run);
  result.crossing = crossing_faces(mesh, clearance);
  if (!result.crossing.empty() || count_cuts(mesh).refutes()) {
    result.tree = find_net(mesh, {.seed = options.seed}, run).forest;
    result.proven_impossible = true;
    result.path = path_by(options.law, linkage_of(lay_flat(mesh, result.tree)));
    return result;
  }
  if (run.over()) return net_without_search(mesh, options, run);
  const Rng rng(options.seed);
  // A net to start from, or at least a spanning tree.
  const auto start = [&](int lane) {
    Rng own = rng.stream(lane);
    const SearchResult net = find_net(mesh, {.seed = own.next()}, run);
    if (net.parts == 1) return net.forest;
    return lightest_forest(mesh, dual_weights(mesh, Heuristic::MinimumPerimeter, random_direction(own), own));
  };
  FreeNets free_nets;
  const auto new_cost = [&] { return std::make_unique<SampledCost>(mesh, kit, options, clearance, &free_nets); };
  const auto search = [&](long steps) {
    return anneal_foldable_net(mesh, start, new_cost, {.seed = options.seed, .max_steps = steps}, run);
  };
  const bool is_small = mesh.num_edges() <= kMostJoints;
  const long most = options.max_steps > 0 ? options.max_steps : steps_for(mesh);
  FoldableResult found = search(is_small ? std::min(most, kStepsBeforeAllTrees) : most);
  if (is_small && found.ending == Ending::Exhausted) {
    result.proven_impossible = !look_at_all_trees(mesh, kit, options.law, clearance, run, found);
    if (!result.proven_impossible && found.ending == Ending::Exhausted && most > kStepsBeforeAllTrees)
      found = search(most);
  }
  result.ending = found.ending;
  result.tree = found.overlaps > 0 ? find_net(mesh, {.seed = options.seed}, run).forest : found.tree;
  result.collisions = found.collisions;
  result.steps = found.steps;
  const Linkage linkage = linkage_of(lay_flat(mesh, result.tree));
  result.path = path_by(options.law, linkage);
  if (found.ending == Ending::Found) {
    const std::optional<PathProof> known = free_nets.proof_of(result.tree);
    result.proof = known ? *known : prove_path(linkage, result.path, {.clearance = clearance});
  }
  return result;
}

BetterNet better_foldable_net(const Mesh& mesh, const FoldForest& tree, const FoldableNetOptions& options,
                              const OptimizeOptions& wish, const Run& run) {
  const PanelKit kit = kit_of(mesh);
  const double clearance = options.clearance > 0 ? options.clearance : default_clearance(loose_panels(kit));
  // A search that runs on for long without a collision at its samples needs more of them than one that ends at the
  // first.
  FoldableNetOptions close = options;
  close.samples = 2 * options.samples;
  const auto new_cost = [&] { return std::make_unique<SampledCost>(mesh, kit, close, clearance); };
  OptimizeResult found = optimize_foldable_net(mesh, tree, new_cost, wish, run);
  BetterNet better{std::move(found.forest), {}, {}, found.before, found.after};
  const Linkage linkage = linkage_of(lay_flat(mesh, better.tree));
  better.path = path_by(options.law, linkage);
  better.proof = prove_path(linkage, better.path, {.clearance = clearance});
  return better;
}

NetAndMotion fold_or_plan(const Mesh& mesh, const FoldableNetOptions& options, const Run& run) {
  NetAndMotion result{find_foldable_net(mesh, options, run.deadline ? leaving_a_quarter(run) : run), {}};
  if (mesh.num_faces() == 1 || !result.net.crossing.empty()) return result;
  if (result.net.ending == Ending::Found) {
    const MotionMethod method = options.law == FoldingLaw::Linear ? MotionMethod::Linear : MotionMethod::Uniform;
    result.motion = Motion{method, result.net.path, result.net.proof};
    return result;
  }
  if (run.over() && mesh.num_faces() > kMostPlannedLate) return result;
  run.report("planning a motion", 0);
  // Nets that nearly fold by the law are seldom those that a planner can fold.
  const SearchResult plain = find_net(mesh, {.seed = options.seed}, run);
  if (plain.parts == 1 && !(plain.forest == result.net.tree)) {
    std::optional<Motion> motion = planned_motion(mesh, plain.forest, options, run);
    if (motion && motion->proof.verdict == PathVerdict::Free) {
      result.net.tree = plain.forest;
      result.net.path = path_by(options.law, linkage_of(lay_flat(mesh, plain.forest)));
      result.motion = std::move(motion);
      return result;
    }
  }
  result.motion = planned_motion(mesh, result.net.tree, options, run);
  return result;
}

}  // namespace plico
