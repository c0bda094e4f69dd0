#include "plico/unfold/search.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/count_cuts.h"
#include "plico/unfold/dual_tree.h"
#include "plico/unfold/exhaust.h"
#include "plico/unfold/grow.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/overlap.h"
#include "plico/unfold/parts.h"

namespace plico {
namespace {

// Weights by which trees are grown, best first (measured over the meshes of bench/unfold).
constexpr std::array kGrowBy = {Heuristic::MinimumPerimeter, Heuristic::UnsteepestEdge, Heuristic::SteepestEdge,
                                Heuristic::FlatTree, Heuristic::Random};

// A way to hang a subtree: cut it off above `panel`, hang it by `side`.
struct Hanging {
  int panel = -1, side = -1;
  int change = 0;  // of the weighted number of overlaps, never positive
};

// A step gives up when this many times `effort` panels were looked at and no hanging was found.
constexpr int kPatience = 3;
// A pair that resists weighs this much more each time: enough to be traded for several new overlaps, which are easier.
constexpr int kWeightStep = 20;
// Sides tried at least, however large the subtree.
constexpr int kFewestSides = 8;
// On large meshes a few big branches come to lie on each other, and small steps go round them for a long time. From
// this many faces on every so many-th step tries to hang a branch of at least kBigBranch panels by one of kBigSides
// sides; the other steps do with a part of the effort and leave branches of more than a kBigPart-th of the mesh alone,
// and of what is gathered kGatheredALook panels count as a look.
constexpr int kLargeMesh = 2000, kBigStepEvery = 5, kBigBranch = 32, kBigSides = 16, kPartOfEffort = 4, kBigPart = 50,
              kGatheredALook = 8;

// The search within one connected mesh.
class Search {
 public:
  Search(const FlatFaces& faces, DualTree& tree, const SearchOptions& options, Rng rng, const Run& run)
      : mesh_(faces.mesh()),
        tree_(tree),
        options_(options),
        rng_(rng),
        run_(run),
        tabu_until_(mesh_.num_edges(), -1),
        large_(mesh_.num_faces() >= kLargeMesh),
        effort_(large_ ? std::max(options.effort / kPartOfEffort, 1) : options.effort),
        most_(large_ ? mesh_.num_faces() / kBigPart : mesh_.num_faces()) {}

  Ending go(long& steps, long max_steps) {
    while (tree_.num_overlaps() > 0) {
      if (steps >= max_steps) return Ending::Exhausted;
      if (steps % 64 == 0 && run_.over()) return run_.ending();
      if (steps % 4096 == 0) {
        tree_.balance();
        run_.report("untangling panels", steps, 0, fmt::format("{} overlaps left", tree_.num_overlaps()));
      }
      step_ = steps++;
      const auto [a, b] = pick_pair();
      if (!large_ || step_ % kBigStepEvery != 0 || !hang_big_branch(a, b)) resolve(a, b);
    }
    return Ending::Found;
  }

 private:
  std::pair<int, int> pick_pair() {
    const auto panels = tree_.overlapping_panels();
    const int a = panels[rng_.below(static_cast<int>(panels.size()))];
    const auto partners = tree_.overlapping(a);
    return {a, partners[rng_.below(static_cast<int>(partners.size()))]};
  }

  // Tries the folds on the tree path between the two panels, those with the smallest subtrees first. A step never makes
  // the weighted overlaps worse; when none makes them better, this pair weighs more from now on (breakout).
  void resolve(int a, int b) {
    Hanging best;
    long looked = 0;
    for (int panel : subtrees_between(a, b)) {
      const long enough = best.panel < 0 ? kPatience * effort_ : best.change < 0 ? effort_ / 4 : effort_;
      if (looked > 0 && tree_.subtree_size(panel) > most_) break;
      if (looked > enough || try_hangings(panel, best, looked, kFewestSides)) break;
    }
    if (best.change == 0) tree_.aggravate(a, b, kWeightStep);
    if (best.panel >= 0) hang(best);
  }

  // Cuts at one fold between the two panels that carries a big branch, rather a smaller one of them. False when no
  // better place is found.
  bool hang_big_branch(int a, int b) {
    const std::vector<int>& between = subtrees_between(a, b);
    const auto big =
        std::find_if(between.begin(), between.end(), [&](int p) { return tree_.subtree_size(p) >= kBigBranch; });
    if (big == between.end()) return false;
    Hanging best;
    long looked = 0;
    const int at_most = rng_.below(static_cast<int>(between.end() - big));
    try_hangings(big[rng_.below(at_most + 1)], best, looked, kBigSides);
    if (best.change < 0) hang(best);
    return best.change < 0;
  }

  void hang(const Hanging& best) {
    tree_.gather(best.panel);
    tabu_until_[mesh_.edge(HalfedgeId(tree_.parent_side(best.panel)))] =
        step_ + options_.tabu_tenure + rng_.below(std::max(options_.tabu_tenure, 1));
    tree_.hang(best.side);
  }

  const std::vector<int>& subtrees_between(int a, int b) {
    between_.clear();
    while (a != b) {
      int& lower = tree_.depth(a) >= tree_.depth(b) ? a : b;
      between_.push_back(lower);
      lower = tree_.parent(lower);
    }
    std::sort(between_.begin(), between_.end(),
              [&](int p, int q) { return std::pair(tree_.subtree_size(p), p) < std::pair(tree_.subtree_size(q), q); });
    return between_;
  }

  // All sides by which the subtree could hang, a random few when it is large; ties are broken evenly. True as soon as
  // one is free of overlaps: looking for a second such side would more than double the time of a step.
  bool try_hangings(int panel, Hanging& best, long& looked, int fewest_sides) {
    const auto subtree = tree_.gather(panel);
    if (large_) looked += static_cast<long>(subtree.size()) / kGatheredALook;
    const int before = tree_.overlaps_with_rest();
    collect_sides(subtree, tree_.parent_side(panel));
    choose_some(std::max(fewest_sides, effort_ / static_cast<int>(subtree.size())));
    for (int side : sides_) {
      if (before + best.change < 0) return false;
      const int limit = before + best.change + 1;
      const int change =
          (large_ ? tree_.overlaps_if_hung_sampled(side, limit, looked) : tree_.overlaps_if_hung(side, limit, looked)) -
          before;
      if (change > best.change) continue;
      ties_ = change < best.change || best.panel < 0 ? 1 : ties_ + 1;
      if (rng_.below(ties_) == 0) best = {panel, side, change};
      if (change == -before) return true;
    }
    return false;
  }

  void collect_sides(std::span<const int> subtree, int hangs_by) {
    sides_.clear();
    for (int f : subtree) {
      for (HalfedgeId h : mesh_.halfedges(FaceId(f))) {
        const HalfedgeId g = mesh_.twin(h);
        if (!g.valid() || tree_.gathered(mesh_.face(g)) || h == hangs_by) continue;
        if (tabu_until_[mesh_.edge(h)] <= step_) sides_.push_back(h);
      }
    }
  }

  void choose_some(int most) {
    const int n = static_cast<int>(sides_.size());
    if (n <= most) return;
    for (int i = 0; i < most; ++i) std::swap(sides_[i], sides_[i + rng_.below(n - i)]);
    sides_.resize(most);
  }

  const Mesh& mesh_;
  DualTree& tree_;
  const SearchOptions& options_;
  Rng rng_;
  const Run& run_;
  std::vector<long> tabu_until_;  // by edge: the step from which it may become a fold again
  const bool large_;
  const int effort_;  // panels looked at in a step
  const int most_;    // panels of a branch that resolve() moves
  std::vector<int> between_, sides_;
  long step_ = 0;
  int ties_ = 1;
};

struct Start {
  FoldForest tree;
  int overlaps = std::numeric_limits<int>::max();
};

Start best_start(const FlatFaces& faces, const SearchOptions& options, const Rng& rng, const Run& run) {
  std::vector<Start> starts(options.starts);
  parallel_for(run, options.starts, [&](int i) {
    if (i > 0 && run.over()) return;
    Rng own = rng.stream(i);
    const Heuristic heuristic = options.grow_by.value_or(kGrowBy[i % kGrowBy.size()]);
    const Vec3 direction = random_direction(own);
    const auto weights = dual_weights(faces.mesh(), heuristic, direction, own);
    starts[i].tree = grow_tree(faces, weights, own.below(faces.mesh().num_faces()));
    starts[i].overlaps = static_cast<int>(overlapping_pairs(faces, lay_panels(faces, starts[i].tree)).size());
  });
  return *std::min_element(starts.begin(), starts.end(),
                           [](const Start& a, const Start& b) { return a.overlaps < b.overlaps; });
}

std::vector<std::pair<int, int>> overlaps_of(const DualTree& tree) {
  std::vector<std::pair<int, int>> pairs;
  for (int a : tree.overlapping_panels())
    for (int b : tree.overlapping(a))
      if (a < b) pairs.emplace_back(a, b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Meshes up to this size are decided by trying all nets, should the search fail in its first steps.
constexpr int kFewFaces = 40;
// The same steps are what parts of a mesh without a net are worth.
constexpr long kFirstSteps = 2000, kMostPartialNets = 300'000;

// One connected mesh; face and edge numbers are its own.
class ConnectedSearch {
 public:
  ConnectedSearch(const Mesh& mesh, const SearchOptions& options, const Rng& rng, const Run& run)
      : faces_(mesh), options_(options), rng_(rng), run_(run) {
    most_ = options.max_steps >= 0 ? options.max_steps : 10'000 + 100L * mesh.num_faces();
  }

  SearchResult go() {
    Start start = best_start(faces_, options_, rng_, run_);
    result_.start_overlaps = start.overlaps;
    const bool few = faces_.mesh().num_faces() <= kFewFaces;
    result_.proven_impossible = count_cuts(faces_.mesh()).refutes();
    result_.ending = untangle(start, few || result_.proven_impossible ? std::min(kFirstSteps, most_) : most_);
    if (few && !result_.proven_impossible && result_.ending == Ending::Exhausted) {
      try_all(start);
      if (result_.ending == Ending::Exhausted && !result_.proven_impossible) result_.ending = untangle(start, most_);
    }
    result_.forest = part_overlaps(faces_, start.tree);
    return std::move(result_);
  }

 private:
  Ending untangle(Start& start, long max_steps) {
    while (start.overlaps > 0) {
      DualTree tree(faces_, start.tree);
      const Ending ending = Search(faces_, tree, options_, rng_.stream(options_.starts + result_.steps), run_)
                                .go(result_.steps, max_steps);
      if (ending != Ending::Found) result_.in_the_way = overlaps_of(tree);
      start.tree = tree.forest();
      if (ending != Ending::Found) return ending;
      // Laid out afresh, without the rounding of many moves.
      start.overlaps = static_cast<int>(overlapping_pairs(faces_, lay_panels(faces_, start.tree)).size());
    }
    result_.in_the_way.clear();
    return Ending::Found;
  }

  void try_all(Start& start) {
    ExhaustResult all = try_all_nets(faces_, kMostPartialNets, run_);
    result_.proven_impossible = all.decided && all.ending == Ending::Exhausted;
    if (all.ending == Ending::Found) {
      start.tree = std::move(all.net);
      result_.in_the_way.clear();
    }
    result_.ending = all.ending;
  }

  const FlatFaces faces_;
  const SearchOptions& options_;
  const Rng& rng_;
  const Run& run_;
  long most_ = 0;
  SearchResult result_;
};

}  // namespace

void check(const SearchOptions& options) {
  if (options.starts < 1) throw InvalidOption(fmt::format("starts = {} must be at least 1", options.starts));
  if (options.tabu_tenure < 0)
    throw InvalidOption(fmt::format("tabu-tenure = {} must be at least 0", options.tabu_tenure));
  if (options.effort < 1) throw InvalidOption(fmt::format("effort = {} must be at least 1", options.effort));
  if (options.max_steps < -1) throw InvalidOption(fmt::format("max-steps = {} must be at least -1", options.max_steps));
}

SearchResult find_net(const Mesh& mesh, const SearchOptions& options, const Run& run) {
  check(options);
  SearchResult whole;
  whole.ending = Ending::Found;
  whole.forest = by_component(mesh, [&](const Submesh& part, int c) {
    const Rng rng = Rng(options.seed).stream(c);
    SearchResult own = ConnectedSearch(part.mesh, options, rng, run).go();
    if (own.ending != Ending::Found) whole.ending = own.ending;
    whole.start_overlaps += own.start_overlaps;
    whole.steps += own.steps;
    whole.proven_impossible |= own.proven_impossible;
    for (const auto& [a, b] : own.in_the_way) whole.in_the_way.emplace_back(part.face[a], part.face[b]);
    return std::move(own.forest);
  });
  whole.parts = count_parts(mesh, whole.forest);
  return whole;
}

}  // namespace plico
