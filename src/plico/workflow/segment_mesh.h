// From a mesh to named parts, each with a verified net and a proven motion.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/segmentation.h"
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
  long steps = 60'000;           // of the search for parts of up to 300 faces, fewer for larger ones; at least 1
  double planning_seconds = 10;  // for PartMotion::Any, where no linear motion was found
};

struct ProvenPart {
  Submesh shape;                      // the part as a mesh of its own
  Ending ending = Ending::Exhausted;  // Found: net and motion are as asked for
  FoldForest forest;                  // of shape.mesh
  Unfolding net;                      // lay_flat(shape.mesh, forest): one piece, or the fewest found
  NetVerdict verdict;
  std::optional<Motion> motion;    // the best found, of linkage_of(net); none when none is asked for or nothing moves
  bool proven_impossible = false;  // no net of this part is as asked for: every spanning tree was looked at
  long steps = 0;                  // of the search

  // A verified net in one piece whose motion, if one is asked for, is free of collision at every moment.
  bool proven() const { return ending == Ending::Found; }
};

// Searches a net and a motion of some faces of a mesh, which must be connected, and judges both.
ProvenPart prove_part(const Mesh& mesh, const std::vector<FaceId>& faces, const ProvePartOptions& options = {},
                      const Run& run = {});

struct SegmentResult {
  Ending ending = Ending::Exhausted;  // Found: every part is proven
  Segmentation parts;
  std::vector<ProvenPart> part;  // in the order of `parts`
  Unfolding net;                 // of the whole mesh, all parts side by side
  NetVerdict verdict;            // of `net`
  std::vector<std::vector<int>>
      pieces;                      // of every part: its numbers in net.part, one unless it has no net in one piece
  std::vector<std::string> notes;  // what was decided on the way, or could not be done; sentences

  int num_proven() const;
};

// Nets and motions for parts that are given. Parts are proven one by one on run.threads threads.
SegmentResult prove_parts(const Mesh& mesh, Segmentation parts, const ProvePartOptions& options = {},
                          const Run& run = {});

// The order to build in: the largest part first, then always the one with the longest seam to what stands; parts that
// touch nothing that stands begin anew. The step of every part, from 1.
std::vector<int> assembly_steps(const Mesh& mesh, const Segmentation& parts);

}  // namespace plico
