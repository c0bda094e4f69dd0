#include "plico/workflow/stack_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plico/base/error.h"
#include "plico/stack/chain.h"

namespace plico {
namespace {

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

class Unpacker {
 public:
  Unpacker(const VoxelMesh& voxels, const StackMeshOptions& stacking, const StackMotionOptions& options, const Run& run)
      : voxels_(voxels),
        stacking_(stacking),
        options_(options),
        run_(run),
        chains_(options.chains > 0 ? options.chains : std::clamp(20000 / voxels.shell.size(), 5, 40)) {}

  StackMotion run(const StackedChain& first) {
    CompactResult found = first.found;
    do {
      try_chain(found);
      ++tries_;
      if (whole() || run_.over() || !options_.to_shape || tries_ == chains_) break;
      found = another();
    } while (true);
    return result();
  }

 private:
  bool whole() const { return !best_.squares.empty() && best_.peeled.whole; }

  void try_chain(const CompactResult& found) {
    const CompactResult back = from_the_end(voxels_, found);
    for (const CompactResult& way : {found, back, mirrored(found), mirrored(back)}) {
      run_.report("unpacking", tries_, chains_);
      if (pile_sign(way.best.folds) == 0) continue;
      const StackedChain chain = stacked_chain(voxels_, way, stacking_.thickness);
      if (!chain.verdict.valid()) continue;
      const Linkage linkage = chain_linkage_of(chain.claim);
      Peel peeled;
      if (options_.to_shape) peeled = peel(linkage, pile_sign(way.best.folds), options_.peel, run_);
      if (best_.squares.empty() || peeled.opened > best_.peeled.opened)
        best_ = {way.best.path, chain, std::move(peeled)};
      if (whole() || run_.over() || !options_.to_shape) return;
    }
  }

  // Another cycle, cut where it stacks well, without the exchanges that take the time.
  CompactResult another() {
    const std::uint64_t seed = options_.seed + static_cast<std::uint64_t>(tries_);
    const JudgedCycle cycle = judged_cycle(voxels_, {.seed = seed}, run_);
    StackMeshOptions quick = stacking_;
    quick.seed = seed;
    quick.exchanges = 0;
    if (cycle.found.ending != Ending::Found) return best_.chain.found;
    return stack_voxels(voxels_, cycle.found.cycle, quick, run_).found;
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
  int tries_ = 0;
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
  set_path(file, chain_linkage_of(motion.chain.claim), motion.path);
  return file;
}

}  // namespace plico
