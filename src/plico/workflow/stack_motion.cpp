#include "plico/workflow/stack_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "plico/base/error.h"
#include "plico/stack/chain.h"
#include "plico/stack/rising_path.h"

namespace plico {
namespace {

constexpr char kMotionKey[] = "plico:chain_motion";
constexpr int kMostFromAnyCycle = 500;          // panels; longer chains get stuck unless they rise
constexpr long kExchangesOfRising = 3'000'000;  // more would take longer than another chain
constexpr int kLeastReach = 50;                 // places

// The same stack told from the other end of the chain.
CompactResult from_the_end(const VoxelMesh& voxels, CompactResult found) {
  Stack& stack = found.best;
  std::ranges::reverse(stack.path);
  std::ranges::reverse(stack.folds);
  stack.headings = strip_headings(graph_of(voxels.shell), stack.path);
  stack.box = box_of(stack_slots(stack.headings, stack.folds));
  return found;
}

CompactResult mirrored(CompactResult found) {
  found.best.folds = upside_down(std::move(found.best.folds));
  return found;
}

// Hinges, from the first on, that stand as in the shape.
int opened_at_end(const Linkage& chain, const FoldingPath& path) {
  const Configuration& end = path.waypoints.back().config;
  int opened = 0;
  while (opened < chain.num_hinges() && std::abs(end[opened] - chain.hinges[opened].target) < 1e-9) ++opened;
  return opened;
}

// One entry a waypoint: its time, and the hinges that stand otherwise than before with their angles, in turn. The first
// says all hinges.
nlohmann::json told(const FoldingPath& path) {
  nlohmann::json times = nlohmann::json::array(), turns = nlohmann::json::array();
  for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
    const Configuration& now = path.waypoints[i].config;
    nlohmann::json turn = nlohmann::json::array();
    for (int h = 0; h < now.size(); ++h)
      if (i == 0 || now[h] != path.waypoints[i - 1].config[h]) turn.insert(turn.end(), {h, degrees(now[h])});
    times.push_back(path.waypoints[i].time);
    turns.push_back(std::move(turn));
  }
  return {{"times", times}, {"turns_deg", turns}};
}

FoldingPath path_told(const nlohmann::json& motion, const ChainClaim& claim) {
  const nlohmann::json &times = motion.at("times"), &turns = motion.at("turns_deg");
  if (times.size() != turns.size() || times.size() < 2)
    throw InvalidInput("chain/motion", fmt::format("{} times for {} turns", times.size(), turns.size()));
  FoldingPath path;
  Configuration config = Configuration::Zero(static_cast<Eigen::Index>(claim.stack.size()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t k = 0; k < turns[i].size(); k += 2) {
      const long hinge = turns[i][k].get<long>();
      const double angle = radians(turns[i].at(k + 1).get<double>());
      if (hinge < 0 || hinge >= config.size() || !std::isfinite(angle))
        throw InvalidInput("chain/motion", fmt::format("turn {} is of hinge {} of {}", i, hinge, config.size()));
      config[hinge] = angle;
    }
    const double time = times[i].get<double>();
    if (i > 0 ? !(time > path.waypoints.back().time) : time != 0)
      throw InvalidInput("chain/motion", fmt::format("time {} is {}; times must rise from 0 to 1", i, time));
    path.waypoints.push_back({time, config});
  }
  if (path.waypoints.back().time != 1)
    throw InvalidInput("chain/motion", fmt::format("the last time is {}, not 1", path.waypoints.back().time));
  return path;
}

class Unpacker {
 public:
  Unpacker(const VoxelMesh& voxels, const StackMeshOptions& stacking, const StackMotionOptions& options, const Run& run)
      : voxels_(voxels),
        stacking_(stacking),
        options_(options),
        run_(run),
        chains_(options.chains > 0 ? options.chains : std::clamp(20000 / voxels.shell.size(), 6, 40)),
        directions_(directions_to_rise(voxels.shell)) {}

  StackMotion run(const StackedChain& first) {
    const bool is_long = voxels_.shell.size() > kMostFromAnyCycle;
    if (!options_.to_shape || !is_long) try_ways(both_ends(first.found));
    while (options_.to_shape && !is_done()) try_ways(rising(first.found));
    return result();
  }

 private:
  using Ways = std::vector<CompactResult>;

  bool whole() const { return !best_.squares.empty() && best_.peeled.whole; }
  bool is_done() const { return tries_ > 0 && (whole() || run_.over() || tries_ >= chains_); }

  void try_ways(const Ways& ways) {
    for (const CompactResult& way : ways) {
      run_.report("unpacking", tries_, chains_);
      if (pile_sign(way.best.folds) == 0) continue;
      const StackedChain chain = stacked_chain(voxels_, way, stacking_);
      if (!chain.verdict.valid()) continue;
      const Linkage linkage = chain_linkage_of(chain.claim);
      Peel peeled;
      if (options_.to_shape) peeled = peel(linkage, pile_sign(way.best.folds), options_.peel, run_);
      if (best_.squares.empty() || peeled.opened > best_.peeled.opened)
        best_ = {way.best.path, chain, std::move(peeled)};
      if (whole() || run_.over() || !options_.to_shape) break;
    }
    ++tries_;
  }

  Ways both_ends(const CompactResult& found) const {
    const CompactResult back = from_the_end(voxels_, found);
    return {found, back, mirrored(found), mirrored(back)};
  }

  // A chain that is built from the ground up, in one of six directions in turn, stacked by exchanges that leave it so.
  Ways rising(const CompactResult& otherwise) {
    const int panels = voxels_.shell.size();
    const std::uint64_t seed = options_.seed + static_cast<std::uint64_t>(rising_);
    const Upwards upwards = directions_[rising_++ % directions_.size()];
    const JudgedCycle cycle = judged_cycle(voxels_, {.seed = seed}, run_);
    if (cycle.walk().empty()) return both_ends(otherwise);
    const std::vector<int> path =
        rising_path(voxels_.shell, graph_of(voxels_.shell), cycle.walk(), {.seed = seed, .upwards = upwards}, run_);
    StackMeshOptions stacking = stacking_;
    stacking.seed = seed;
    stacking.exchanges = std::min(stacking.exchanges, kExchangesOfRising);
    stacking.reach = std::max(kLeastReach, panels / 10);
    stacking.as_it_runs = true;
    CompactResult found = stack_voxels(voxels_, path, stacking, run_).found;
    const CompactResult back = from_the_end(voxels_, found);
    const auto astray = [&](const CompactResult& way) { return places_astray(voxels_.shell, way.best.path, upwards); };
    if (astray(back) < astray(found)) found = back;
    return {found, mirrored(found)};
  }

  StackMotion result() {
    StackMotion motion;
    motion.chains = tries_;
    motion.chain = std::move(best_.chain);
    const std::vector<StackFold>& folds = motion.chain.found.best.folds;
    motion.path = unpacking(chain_linkage_of(motion.chain.claim), folds, best_.peeled);
    ChainClaim claim = motion.chain.claim;
    claim.opened = opened_at_end(chain_linkage_of(claim), motion.path);
    motion.verdict = judge_chain_motion(claim, motion.path, {.air = options_.peel.air}, run_);
    const bool arrived = best_.peeled.whole || !options_.to_shape;
    motion.ending = arrived && motion.verdict.free() ? Ending::Found : run_.over() ? run_.ending() : Ending::Exhausted;
    return motion;
  }

  struct Best {
    std::vector<int> squares;  // empty before the first
    StackedChain chain;
    Peel peeled;
  };
  const VoxelMesh& voxels_;
  const StackMeshOptions& stacking_;
  const StackMotionOptions& options_;
  const Run& run_;
  const int chains_;
  const std::array<Upwards, 6> directions_;
  int tries_ = 0, rising_ = 0;  // chains tried; those of them that rise
  Best best_;
};

}  // namespace

double StackMotion::share() const {
  const std::size_t hinges = chain.claim.stack.size();
  return hinges == 0 ? 1 : static_cast<double>(verdict.opened) / static_cast<double>(hinges);
}

StackMotion unpack_stack(const VoxelMesh& voxels, const StackedChain& first, const StackMeshOptions& stacking,
                         const StackMotionOptions& options, const Run& run) {
  require(options.chains >= 0, "chains", options.chains, "at least 0");
  return Unpacker(voxels, stacking, options, run).run(first);
}

FoldFile chain_motion_file(const StackMotion& motion) {
  ChainClaim claim = motion.chain.claim;
  if (motion.verdict.opened < static_cast<int>(claim.stack.size())) claim.opened = motion.verdict.opened;
  FoldFile file = chain_file(claim);
  const std::size_t panels = claim.stack.size() + 1;
  if (static_cast<long>(panels * motion.path.waypoints.size()) <= kMostFramedPanels)
    set_path(file, chain_linkage_of(motion.chain.claim), motion.path);
  else
    file.other.emplace_back(kMotionKey, told(motion.path).dump());
  return file;
}

void take_told_motion(FoldFile& file, const ChainClaim& claim) {
  const auto at = std::ranges::find(file.other, kMotionKey, [](const auto& entry) { return entry.first; });
  if (file.path || at == file.other.end()) return;
  try {
    file.path = path_told(nlohmann::json::parse(at->second), claim);
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("chain/motion", "plico:chain_motion does not say times and turns, numbers both");
  }
}

}  // namespace plico
