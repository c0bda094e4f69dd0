// Judges the motion of a chain of thick squares from scratch: does it begin in the stack, end in the shape, and keep
// all panels apart at every moment in between? Knows nothing of the search. Panels that do not move against each other
// are taken together: hinges that rest between two waypoints cut the chain into rigid groups, and a pile within a group
// is one box. Two boxes are apart for as long as their distance lasts at the most speed they can have (conservative
// advancement, as Mirtich 1996), and from all that a sphere holds for as long as they are from the sphere; so what is
// proven is every moment, not samples. Of the search it shares only the folding map and the gap of two boxes, which a
// test holds against the separation of prisms.
#pragma once
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/folding_path.h"
#include "plico/verify/chain.h"
#include "plico/verify/path.h"

namespace plico {

struct ChainMotionOptions {
  double air = 0.01;  // each face of a panel moves inwards by this share of its thickness, in (0, 0.5)
};

struct ChainMotionVerdict {
  PathVerdict verdict = PathVerdict::Undecided;
  double from = 0, to = 0;         // Collides, Undecided: where; times of the path
  int panel_a = -1, panel_b = -1;  // and between which panels, or the piles that begin with them
  int opened = 0;                  // hinges, from the first on, that stand as in the shape at the end
  long steps = 0;                  // distances of two boxes
  bool interrupted = false;        // the run was over: Undecided from `from` on
  std::vector<Defect> defects;     // the motion is not one from this stack to this shape

  bool free() const { return verdict == PathVerdict::Free && defects.empty(); }
};

// The path is one of the claim's chain (chain_linkage_of). Its first state must be the stack (1e-9 radians); its last
// is the shape, or as far from it as the claim says (ChainClaim::opened). Panels at a common hinge are kept apart by it
// while it stays within
// +-180 degrees (checked; the section of two such panels is the same at every place along the hinge). The stack itself
// is for verify_chain(). Throws InvalidInput when the path does not fit. O(waypoints * panels) and what is near.
ChainMotionVerdict judge_chain_motion(const ChainClaim& claim, const FoldingPath& path,
                                      const ChainMotionOptions& options = {}, const Run& run = {});

// The same of a chain told as a linkage (hinge i between the panels i and i + 1), wherever it begins: panels must be
// apart then. Says nothing about start and end.
ChainMotionVerdict judge_chain_motion(const Linkage& chain, const FoldingPath& path,
                                      const ChainMotionOptions& options = {}, const Run& run = {});

}  // namespace plico
