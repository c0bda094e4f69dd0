// From a mesh to named parts, each with a verified net and a proven motion.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/segmentation.h"
#include "plico/verify/net.h"
#include "plico/workflow/prove_part.h"

namespace plico {

enum class SegmentMethod { Necks, Clusters, Random };
enum class PartsWish { Auto, Fewest, Exactly };  // cut at necks; cut only what fails; as many as are asked for

struct SegmentOptions {
  SegmentMethod method = SegmentMethod::Necks;
  PartsWish wish = PartsWish::Auto;
  int parts = 0;            // for Exactly, in [components, faces]
  double neck = 0.8;        // Auto: no cut scores this or more (segment/necks.h); above 0
  int max_parts = 12;       // Auto: of the cuts at necks, more only where parts fail; at least 1
  double min_area = 0.008;  // of a part cut off at a neck, as a share of the mesh; in [0, 0.5]
  ProvePartOptions prove;
};
void check(const SegmentOptions& options);  // throws InvalidOption
// "auto", "fewest" or a number, as users write it. Throws InvalidOption.
void set_wish(SegmentOptions& options, const std::string& word);

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

// The same from proofs that are there, in the order of `parts`.
SegmentResult put_together(const Mesh& mesh, Segmentation parts, std::vector<ProvenPart> proven, const Run& run = {});

// Parts that fold: first what certainly fails is cut (faces that run through each other), then necks, as the wish says;
// every part is proven, parts that fail are joined to a neighbour or split, and split ones joined again while that is
// proven. A run that is over leaves what there is, with parts that are not proven. Throws InvalidOption when there
// cannot be so many parts.
SegmentResult segment_mesh(const Mesh& mesh, const SegmentOptions& options = {}, const Run& run = {});

// The order to build in: the largest part first, then always the one with the longest seam to what stands; parts that
// touch nothing that stands begin anew. The step of every part, from 1.
std::vector<int> assembly_steps(const Mesh& mesh, const Segmentation& parts);

}  // namespace plico
