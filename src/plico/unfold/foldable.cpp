#include "plico/unfold/foldable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/base/rng.h"
#include "plico/unfold/dual_tree.h"
#include "plico/unfold/overlap.h"

namespace plico {
namespace {

constexpr int kFarthestWalk = 6;       // faces from a conflict to a branch cut close to it
constexpr int kFarthestSeam = 8;       // faces from a panel in conflict to where its branch is hung close to it
constexpr int kBranchesTried = 3;      // on the path between two panels; the smallest is cut off
constexpr long kStepsPerRound = 4000;  // of a lane, before the one that has done least goes on

// One annealing search from one start.
class Lane {
 public:
  Lane(const FlatFaces& faces, const FoldForest& start, std::unique_ptr<MotionCost> cost,
       const FoldableOptions& options, Rng rng)
      : mesh_(faces.mesh()), tree_(faces, start), motion_(std::move(cost)), options_(options), rng_(rng) {
    motion_->reset(start);
    keep_best();
  }

  void go(const Run& run) {
    for (long end = steps_ + kStepsPerRound; steps_ < end && !found_ && !run.over();) {
      if (energy() == 0) {
        look_closer(run);
        continue;
      }
      ++steps_;
      step();
    }
    tree_.balance();
  }

  bool found() const { return found_; }
  bool done() const { return found_ || steps_ >= options_.max_steps; }
  long steps() const { return steps_; }
  long work() const { return steps_ + motion_->work(); }
  // Smaller is better. Any net is better than a tree that overlaps, which nobody can cut out.
  using Rank = std::pair<bool, long>;
  Rank best_rank() const { return best_rank_; }
  FoldableResult result() const { return {Ending::Exhausted, best_, best_overlaps_, best_collisions_, steps_}; }

 private:
  long energy() const { return options_.overlap_weight * static_cast<long>(tree_.num_overlaps()) + motion_->cost(); }

  void keep_best() {
    const Rank rank{tree_.num_overlaps() > 0, energy()};
    if (rank >= best_rank_) return;
    best_rank_ = rank;
    best_ = tree_.forest();
    best_overlaps_ = tree_.num_overlaps();
    best_collisions_ = motion_->cost();
  }

  void look_closer(const Run& run) {
    const MotionCost::Closer closer = motion_->look_closer(tree_.forest(), run);
    if (closer == MotionCost::Closer::Free) {
      best_ = tree_.forest();
      best_overlaps_ = best_collisions_ = 0;
      found_ = true;
      return;
    }
    best_rank_ = kWorst;  // the measure has changed
    keep_best();
    if (closer == MotionCost::Closer::Unclear) shake();
  }

  // Hangs some branches anywhere without overlap.
  void shake() {
    ++steps_;
    for (int i = 0; i < 8; ++i) {
      const int panel = rng_.below(mesh_.num_faces());
      if (tree_.parent_side(panel) < 0) continue;
      const auto branch = tree_.gather(panel);
      const int side = pick_side(branch, tree_.parent_side(panel));
      if (side >= 0) hang(branch, side);
    }
  }

  // The cold end is not where the last conflicts go, so it is not waited for; what was reached once takes less time
  // to come back to.
  double temperature() const {
    const double rounds = static_cast<double>(steps_) / mesh_.num_faces(), first = options_.steps_per_cooling,
                 later = options_.steps_per_recooling;
    const double cooled = rounds < first ? rounds / first : std::fmod(rounds - first, later) / later;
    const double root = std::lerp(std::sqrt(options_.temperature), std::sqrt(options_.coldest), cooled);
    return root * root;
  }

  void step() {
    const auto [a, b] = pick_conflict();
    const int panel = rng_.uniform() < options_.nearby ? walk_from(rng_.below(2) ? a : b) : pick_branch(a, b);
    if (tree_.parent_side(panel) < 0) return;
    const auto branch = tree_.gather(panel);
    const int hangs_by = tree_.parent_side(panel);
    int side = rng_.uniform() < options_.seams ? pick_seam(a, b, hangs_by) : -1;
    if (side < 0) side = pick_side(branch, hangs_by);
    if (side < 0) return;
    const long across =
        options_.overlap_weight * static_cast<long>(tree_.overlaps_with_rest()) + motion_->cost_across(branch);
    // The worst that would be accepted, drawn before anything is counted.
    const long bound = across + static_cast<long>(-plico::log(1 - rng_.uniform()) * temperature());
    const int most_overlaps = static_cast<int>(bound / options_.overlap_weight);
    const long overlaps = tree_.overlaps_if_hung(side, most_overlaps + 1, looked_);
    if (overlaps > most_overlaps) return;
    const long left = bound - options_.overlap_weight * overlaps;
    if (motion_->cost_if_hung(branch, side, left) > left) return;
    hang(branch, side);
    keep_best();
  }

  void hang(std::span<const int> branch, int side) {
    motion_->hang(branch, side);
    tree_.hang(side);
  }

  std::pair<int, int> pick_conflict() {
    const long overlaps = options_.overlap_weight * static_cast<long>(tree_.overlapping_panels().size());
    const long i = rng_.below(static_cast<int>(overlaps + motion_->cost()));
    if (i >= overlaps) return motion_->conflict(i - overlaps);
    const int a = tree_.overlapping_panels()[i / options_.overlap_weight];
    const auto partners = tree_.overlapping(a);
    return {a, partners[rng_.below(static_cast<int>(partners.size()))]};
  }

  // A panel on the tree path between a and b, below their common ancestor: its subtree holds just one of them. Small
  // subtrees, which disturb less and are quicker to judge, are preferred.
  int pick_branch(int a, int b) {
    between_.clear();
    while (a != b) {
      int& lower = tree_.depth(a) >= tree_.depth(b) ? a : b;
      between_.push_back(lower);
      lower = tree_.parent(lower);
    }
    int smallest = between_[rng_.below(static_cast<int>(between_.size()))];
    for (int i = 1; i < kBranchesTried; ++i) {
      const int other = between_[rng_.below(static_cast<int>(between_.size()))];
      if (tree_.subtree_size(other) < tree_.subtree_size(smallest)) smallest = other;
    }
    return smallest;
  }

  // A panel a few sides of the mesh away.
  int walk_from(int panel) {
    for (int left = 1 + rng_.below(kFarthestWalk); left > 0; --left) {
      list_sides(panel, -1);
      panel = mesh_.face(mesh_.twin(HalfedgeId(random_side())));
    }
    return panel;
  }

  // The sides of a panel with another panel across, but for one.
  void list_sides(int panel, int but) {
    sides_.clear();
    for (HalfedgeId h : mesh_.halfedges(FaceId(panel)))
      if (mesh_.twin(h).valid() && h != but) sides_.push_back(h);
  }

  int random_side() { return sides_[rng_.below(static_cast<int>(sides_.size()))]; }

  // Where a walk from the conflict's panel in the branch leaves the branch: two flaps that close a seam from the wrong
  // side stay together once they hang by it. -1: it does not leave, or no panel of the two is in the branch.
  int pick_seam(int a, int b, int hangs_by) {
    int panel = tree_.gathered(a) ? a : b;
    if (!tree_.gathered(panel)) return -1;
    for (int left = kFarthestSeam; left > 0; --left) {
      list_sides(panel, hangs_by);
      if (sides_.empty()) return -1;
      const int side = random_side();
      panel = mesh_.face(mesh_.twin(HalfedgeId(side)));
      if (!tree_.gathered(panel)) return side;
    }
    return -1;
  }

  int pick_side(std::span<const int> branch, int hangs_by) {
    sides_.clear();
    for (int f : branch) {
      for (HalfedgeId h : mesh_.halfedges(FaceId(f))) {
        const HalfedgeId g = mesh_.twin(h);
        if (g.valid() && h != hangs_by && !tree_.gathered(mesh_.face(g))) sides_.push_back(h);
      }
    }
    return sides_.empty() ? -1 : random_side();
  }

  const Mesh& mesh_;
  DualTree tree_;
  std::unique_ptr<MotionCost> motion_;
  const FoldableOptions& options_;
  Rng rng_;
  std::vector<int> between_, sides_;
  FoldForest best_;
  static constexpr Rank kWorst{true, std::numeric_limits<long>::max()};
  Rank best_rank_ = kWorst;
  long best_overlaps_ = 0, best_collisions_ = 0;
  long steps_ = 0, looked_ = 0;
  bool found_ = false;
};

// Lanes side by side on some threads. The lane that has done least goes on, and of those that find a net the one with
// least work wins, so that no thread waits for another and the winner is the same for any number of threads.
class Race {
 public:
  Race(std::vector<std::unique_ptr<Lane>> lanes, const Run& run)
      : lanes_(std::move(lanes)), standings_(lanes_.size()), run_(run) {
    for (int i = 0; i < num_lanes(); ++i) note(i);
  }

  FoldableResult go() {
    parallel_for(run_, num_lanes(), [this](int) {
      for (int lane = take(); lane >= 0; lane = take()) {
        lanes_[lane]->go(run_);
        give_back(lane);
      }
    });
    FoldableResult result = lanes_[leader()]->result();
    result.ending = winner_ >= 0 ? Ending::Found : run_.over() ? run_.ending() : Ending::Exhausted;
    return result;
  }

 private:
  // How a lane stood when it was last given back.
  struct Standing {
    long work = 0, steps = 0, overlaps = 0, collisions = 0;
    Lane::Rank rank = {};
    bool busy = false, done = false;
  };

  int num_lanes() const { return static_cast<int>(lanes_.size()); }
  bool less_work(int a, int b) const { return std::pair(standings_[a].work, a) < std::pair(standings_[b].work, b); }

  // The lane to go on with; -1: none.
  int take() {
    const std::scoped_lock lock(mutex_);
    int least = -1;
    for (int i = 0; i < num_lanes(); ++i) {
      const bool late = winner_ >= 0 && less_work(winner_, i);
      if (!standings_[i].busy && !standings_[i].done && !late && (least < 0 || less_work(i, least))) least = i;
    }
    if (run_.over()) least = -1;
    if (least >= 0) standings_[least].busy = true;
    return least;
  }

  void give_back(int lane) {
    const std::scoped_lock lock(mutex_);
    note(lane);
    if (lanes_[lane]->found() && (winner_ < 0 || less_work(lane, winner_))) winner_ = lane;
    const Standing& best = standings_[leader()];
    run_.report("searching a net that folds", best.steps, 0,
                fmt::format("{} overlaps, {} collisions", best.overlaps, best.collisions));
  }

  void note(int i) {
    const Lane& lane = *lanes_[i];
    const FoldableResult best = lane.result();
    standings_[i] = {lane.work(), lane.steps(), best.overlaps, best.collisions, lane.best_rank(), false, lane.done()};
  }

  int leader() const {
    if (winner_ >= 0) return winner_;
    const auto better = [](const Standing& a, const Standing& b) { return a.rank < b.rank; };
    return static_cast<int>(std::min_element(standings_.begin(), standings_.end(), better) - standings_.begin());
  }

  std::vector<std::unique_ptr<Lane>> lanes_;
  std::vector<Standing> standings_;
  const Run& run_;
  std::mutex mutex_;  // for the standings
  int winner_ = -1;
};

// Where the time was over before the first step: counting collisions takes a second on large meshes.
FoldableResult not_begun(const FlatFaces& faces, const FoldForest& start, const Run& run) {
  const auto overlaps = overlapping_pairs(faces, lay_panels(faces, start)).size();
  return {run.ending(), start, static_cast<int>(overlaps), 0, 0};
}

}  // namespace

void check(const FoldableOptions& options) {
  require(options.lanes >= 1, "lanes", options.lanes, "at least 1");
  require(options.overlap_weight >= 1, "overlap-weight", options.overlap_weight, "at least 1");
  require(options.temperature > 0, "temperature", options.temperature, "above 0");
  require(options.nearby >= 0 && options.nearby <= 1, "nearby", options.nearby, "in [0, 1]");
  require(options.coldest >= 0 && options.coldest <= options.temperature, "coldest", options.coldest,
          "in [0, temperature]");
  require(options.seams >= 0 && options.seams <= 1, "seams", options.seams, "in [0, 1]");
  require(options.steps_per_recooling >= 1, "steps-per-recooling", options.steps_per_recooling, "at least 1");
  require(options.steps_per_cooling >= 1, "steps-per-cooling", options.steps_per_cooling, "at least 1");
  require(options.max_steps >= 0, "max-steps", options.max_steps, "at least 0");
}

FoldableResult anneal_foldable_net(const Mesh& mesh, const std::function<FoldForest(int lane)>& start,
                                   const std::function<std::unique_ptr<MotionCost>()>& new_cost,
                                   const FoldableOptions& options, const Run& run) {
  check(options);
  const FlatFaces faces(mesh);
  const Rng rng(options.seed);
  std::vector<std::unique_ptr<Lane>> lanes(options.lanes);
  std::vector<FoldForest> starts(options.lanes);
  parallel_for(run, options.lanes, [&](int i) {
    starts[i] = start(i);
    if (!run.over()) lanes[i] = std::make_unique<Lane>(faces, starts[i], new_cost(), options, rng.stream(i));
  });
  if (std::any_of(lanes.begin(), lanes.end(), [](const auto& lane) { return !lane; }))
    return not_begun(faces, starts[0], run);
  return Race(std::move(lanes), run).go();
}

}  // namespace plico
