#include "plico/motion/clear_trees.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "plico/base/error.h"
#include "plico/geom/convex2.h"
#include "plico/motion/penetration.h"
#include "plico/motion/plates.h"

namespace plico {
namespace {

using Path = std::uint64_t;  // a set of joints; in a tree it says which panels it connects

// A plate in the plane z = 0 as its polygon.
struct Outline {
  const std::vector<Vec3>& corners;
  std::size_t size() const { return corners.size(); }
  Vec2 operator[](int i) const { return corners[i].head<2>(); }
};

// Do coplanar convex plates share a disc wider than `touch`?
bool overlap(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double touch) {
  const auto depth = [touch](const Vec2& side) { return touch * side.norm(); };
  return !side_separates(Outline{a}, Outline{b}, depth) && !side_separates(Outline{b}, Outline{a}, depth);
}

class Enumeration {
 public:
  Enumeration(const PanelKit& kit, const ClearTreesOptions& options,
              const std::function<bool(const std::vector<char>&)>& visit, const Run& run)
      : kit_(kit), options_(options), visit_(visit), run_(run), group_(kit.num_panels()), members_(kit.num_panels()) {
    for (int p = 0; p < kit.num_panels(); ++p) {
      group_[p] = p;
      members_[p] = {p};
      panel_of_side_.insert(panel_of_side_.end(), kit.outlines[p].size(), p);
    }
    joint_of_side_.assign(kit.twin.size(), -1);
    for (int side = 0; side < static_cast<int>(kit.twin.size()); ++side) {
      if (kit.twin[side] < side) continue;
      joint_of_side_[side] = joint_of_side_[kit.twin[side]] = static_cast<int>(side_of_joint_.size());
      side_of_joint_.push_back(side);
    }
    if (side_of_joint_.size() > kMostJoints)
      throw InvalidOption(fmt::format("the panels have {} joints, at most {} can be looked at one by one",
                                      side_of_joint_.size(), kMostJoints));
    state_.assign(side_of_joint_.size(), Open);
    path_.assign(static_cast<std::size_t>(kit.num_panels()) * kit.num_panels(), 0);
    shape_panels();
    place_neighbours();
  }

  ClearTrees run() {
    choose(0);
    result_.complete = !cut_short_ && !found_;
    result_.ending = found_ ? Ending::Found : cut_short_ && run_.over() ? run_.ending() : Ending::Exhausted;
    return result_;
  }

 private:
  enum State : char { Open, Joined, Barred };

  void shape_panels() {
    const Plates plates = make_plates(loose_panels(kit_), options_.clearance);
    plates_.resize(kit_.num_panels());
    for (int i = 0; i < plates.size(); ++i)
      plates_[plates.panel[i]].emplace_back(plates.corners.begin() + plates.first[i],
                                            plates.corners.begin() + plates.first[i + 1]);
  }

  // The panel over each side, flat first and then at every sample.
  void place_neighbours() {
    const BranchSampler sampler(kit_, options_.law, options_.clearance, options_.touch);
    over_.resize(kit_.twin.size());
    for (std::size_t side = 0; side < over_.size(); ++side) {
      if (kit_.twin[side] < 0) continue;
      for (int k = 0; k <= options_.samples; ++k)
        over_[side].push_back(sampler.across(static_cast<int>(side), static_cast<double>(k) / options_.samples));
    }
  }

  Path& path(int a, int b) { return path_[static_cast<std::size_t>(a) * kit_.num_panels() + b]; }
  int panel(int side) const { return panel_of_side_[side]; }
  int across(int side) const { return panel_of_side_[kit_.twin[side]]; }

  std::vector<int> sides_along(int from, int to, Path path) const {
    std::vector<int> sides;
    while (from != to) {
      for (int side = kit_.first_side[from]; side < kit_.first_side[from + 1]; ++side) {
        if (const int joint = joint_of_side_[side]; joint >= 0 && (path >> joint & 1) != 0) {
          path &= ~(Path{1} << joint);
          sides.push_back(side);
          from = across(side);
          break;
        }
      }
    }
    return sides;
  }

  // Do the ends of the path overlap in the flat state or collide at a sample?
  bool clash(int a, int b, Path path) {
    if (std::popcount(path) < 2) return false;
    const auto [at, is_new] = clashes_.try_emplace(path, false);
    if (!is_new) return at->second;
    const std::vector<int> sides = sides_along(a, b, path);
    for (int k = 0; k <= options_.samples && !at->second; ++k) {
      Pose pose = Pose::Identity();
      for (int side : sides) pose = pose * over_[side][k];
      at->second = meet(a, b, pose, k == 0);
    }
    return at->second;
  }

  bool meet(int a, int b, const Pose& pose, bool flat) const {
    for (std::vector<Vec3> moved : plates_[b]) {
      for (Vec3& corner : moved) corner = pose * corner;
      for (const std::vector<Vec3>& plate : plates_[a]) {
        const PlacedPlate first{plate.data(), static_cast<int>(plate.size()), Vec3::UnitZ()};
        const PlacedPlate second{moved.data(), static_cast<int>(moved.size()), pose.linear().col(2)};
        if (flat ? overlap(plate, moved, options_.touch) : penetrate(first, second, options_.touch)) return true;
      }
    }
    return false;
  }

  bool refuted(int joint) {
    const int side = side_of_joint_[joint], p = panel(side), q = across(side);
    for (int a : members_[group_[p]])
      for (int b : members_[group_[q]])
        if (clash(a, b, path(a, p) | path(q, b) | Path{1} << joint)) return true;
    return false;
  }

  bool connected() const {
    std::vector<char> reached(kit_.num_panels(), 0);
    std::vector<int> queue{0};
    reached[0] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (int side = kit_.first_side[queue[i]]; side < kit_.first_side[queue[i] + 1]; ++side) {
        if (joint_of_side_[side] < 0 || state_[joint_of_side_[side]] == Barred || reached[across(side)]) continue;
        reached[across(side)] = 1;
        queue.push_back(across(side));
      }
    }
    return static_cast<int>(queue.size()) == kit_.num_panels();
  }

  // Bars what would close a loop or a path that clashes; the joint of the group with fewest ways out comes next.
  int bar_and_pick(std::vector<int>& barred) {
    std::vector<int> ways(kit_.num_panels(), 0);
    for (int joint = 0; joint < static_cast<int>(state_.size()); ++joint) {
      if (state_[joint] != Open) continue;
      const int a = group_[panel(side_of_joint_[joint])], b = group_[across(side_of_joint_[joint])];
      if (a == b || refuted(joint)) {
        state_[joint] = Barred;
        barred.push_back(joint);
      } else {
        ++ways[a], ++ways[b];
      }
    }
    int best = -1, fewest = std::numeric_limits<int>::max();
    for (int joint = 0; joint < static_cast<int>(state_.size()); ++joint) {
      if (state_[joint] != Open) continue;
      const int a = group_[panel(side_of_joint_[joint])], b = group_[across(side_of_joint_[joint])];
      const int rank = 100 * std::min(ways[a], ways[b]) - static_cast<int>(members_[a].size() + members_[b].size());
      if (rank < fewest) fewest = rank, best = joint;
    }
    return best;
  }

  void choose(int joined) {
    if (found_ || cut_short_) return;
    if (++result_.states > options_.max_states || (result_.states % 1024 == 0 && run_.over())) {
      cut_short_ = true;
      return;
    }
    if (joined == kit_.num_panels() - 1) return show();
    std::vector<int> barred;
    const int joint = bar_and_pick(barred);
    if (joint >= 0 && connected()) {
      join(joint, joined);
      state_[joint] = Barred;
      if (connected()) choose(joined);
      state_[joint] = Open;
    }
    for (int b : barred) state_[b] = Open;
  }

  void join(int joint, int joined) {
    const int side = side_of_joint_[joint], p = panel(side), q = across(side), into = group_[p], from = group_[q];
    const std::vector<int> kept = members_[into], moved = members_[from];
    for (int a : kept)
      for (int b : moved) path(a, b) = path(b, a) = path(a, p) | path(q, b) | Path{1} << joint;
    for (int b : moved) group_[b] = into;
    members_[into].insert(members_[into].end(), moved.begin(), moved.end());
    members_[from].clear();
    state_[joint] = Joined;
    choose(joined + 1);
    members_[into] = kept;
    members_[from] = moved;
    for (int b : moved) group_[b] = from;
  }

  void show() {
    std::vector<char> joined(kit_.twin.size(), 0);
    for (std::size_t side = 0; side < joined.size(); ++side)
      joined[side] = joint_of_side_[side] >= 0 && state_[joint_of_side_[side]] == Joined ? 1 : 0;
    found_ = visit_(joined);
  }

  const PanelKit& kit_;
  const ClearTreesOptions& options_;
  const std::function<bool(const std::vector<char>&)>& visit_;
  const Run& run_;
  std::vector<int> panel_of_side_, joint_of_side_, side_of_joint_;
  std::vector<std::vector<std::vector<Vec3>>> plates_;  // [panel][plate]: corners
  std::vector<std::vector<Pose>> over_;                 // [side][moment]
  std::vector<State> state_;                            // by joint
  std::vector<int> group_;                              // by panel: joined panels share one
  std::vector<std::vector<int>> members_;               // by group
  std::vector<Path> path_;                              // between joined panels
  std::unordered_map<Path, bool> clashes_;
  bool found_ = false, cut_short_ = false;
  ClearTrees result_;
};

}  // namespace

ClearTrees find_clear_trees(const PanelKit& kit, const ClearTreesOptions& options,
                            const std::function<bool(const std::vector<char>& joined)>& visit, const Run& run) {
  require(options.samples >= 1, "samples", options.samples, "at least 1");
  return Enumeration(kit, options, visit, run).run();
}

}  // namespace plico
