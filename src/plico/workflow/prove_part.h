// Some faces of a mesh as a part of their own: its verified net and its proven motion.
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/submesh.h"
#include "plico/verify/net.h"
#include "plico/workflow/foldable_net.h"
#include "plico/workflow/plan_motion.h"

namespace plico {

// What every part must have besides a net in one piece.
enum class PartMotion { Linear, Uniform, Any, None };  // Any: linear or else planned

struct ProvePartOptions {
  std::uint64_t seed = 1;
  PartMotion motion = PartMotion::Linear;
  // Of each of two searches side by side, for parts of up to 300 faces; fewer for larger ones. At least 1. A search
  // that ends with kNearMiss collisions or fewer is given ten times as many.
  long steps = 20'000;
};

inline constexpr int kNearMiss = 3;

struct ProvenPart {
  Submesh shape;                      // the part as a mesh of its own
  Ending ending = Ending::Exhausted;  // Found: net and motion are as asked for
  FoldForest forest;                  // of shape.mesh
  Unfolding net;                      // lay_flat(shape.mesh, forest): one piece, or the fewest found
  NetVerdict verdict;
  std::optional<Motion> motion;    // the best found, of linkage_of(net); none when none is asked for or nothing moves
  bool proven_impossible = false;  // no net of this part is as asked for: every spanning tree was looked at
  std::vector<std::pair<int, int>> crossing;  // faces of shape.mesh that run through each other: no motion can end well
  long steps = 0;                             // of the search

  // A verified net in one piece whose motion, if one is asked for, is free of collision at every moment.
  bool proven() const { return ending == Ending::Found; }
};

// Searches a net and a motion of some faces of a mesh, which must be connected, and judges both.
ProvenPart prove_part(const Mesh& mesh, const std::vector<FaceId>& faces, const ProvePartOptions& options = {},
                      const Run& run = {});

}  // namespace plico
