// What a mesh becomes: named parts, each with its net and its motion, and how they are put together. A net in one piece
// is a kit of one.
#pragma once
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/segmentation.h"
#include "plico/verify/net.h"
#include "plico/workflow/prove_part.h"

namespace plico {

struct Kit {
  Ending ending = Ending::Exhausted;  // Found: every part is proven
  Segmentation parts;
  std::vector<ProvenPart> part;  // in the order of `parts`
  Unfolding net;                 // of the whole mesh, all parts side by side
  NetVerdict verdict;            // of `net`
  std::vector<std::vector<int>>
      pieces;                      // of every part: its numbers in net.part, one unless it has no net in one piece
  std::vector<int> mirror;         // the part that is the mirror image of each, or itself, -1 for none; may be empty
  std::vector<std::string> notes;  // what was decided on the way, or could not be done; sentences

  int num_proven() const;
};

// Nets and motions for parts that are given. Parts are proven one by one on run.threads threads.
Kit make_kit(const Mesh& mesh, Segmentation parts, const ProvePartOptions& options = {}, const Run& run = {});

// The same from proofs that are there, in the order of `parts`.
Kit put_together(const Mesh& mesh, Segmentation parts, std::vector<ProvenPart> proven, const Run& run = {});

// The order to build in: the largest part first, then always the one with the longest seam to what stands; parts that
// touch nothing that stands begin anew. The step of every part, from 1.
std::vector<int> assembly_steps(const Mesh& mesh, const Segmentation& parts);

}  // namespace plico
