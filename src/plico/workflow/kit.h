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

// Two facets of different parts that are glued face to face, where they touch.
struct Joint {
  int first = 0, second = 0;            // parts
  int first_face = 0, second_face = 0;  // of the mesh, turned to each other
  std::vector<Vec3> polygon;            // where they touch: convex, counter-clockwise seen from outside the first
};

struct Kit {
  Ending ending = Ending::Exhausted;  // Found: every part is proven
  Segmentation parts;
  std::vector<ProvenPart> part;  // in the order of `parts`
  Unfolding net;                 // of the whole mesh, all parts side by side
  NetVerdict verdict;            // of `net`
  std::vector<std::vector<int>>
      pieces;  // of every part: its numbers in net.part, one unless it has no net in one piece
  std::vector<Joint> joints;
  std::vector<int> mirror;         // the part that is the mirror image of each, or itself, -1 for none; may be empty
  std::vector<std::string> notes;  // what was decided on the way, or could not be done; sentences

  int num_proven() const;
};

// Nets and motions for parts that are given. Parts are proven one by one on run.threads threads.
Kit make_kit(const Mesh& mesh, Segmentation parts, const ProvePartOptions& options = {}, const Run& run = {});

// The same from proofs that are there, in the order of `parts`.
Kit put_together(const Mesh& mesh, Segmentation parts, std::vector<ProvenPart> proven, const Run& run = {});

// The order to build in: the largest part first, then always the one with the longest seam to what stands; parts that
// touch nothing that stands begin anew. A joint counts as a seam around it. The step of every part, from 1.
std::vector<int> assembly_steps(const Mesh& mesh, const Segmentation& parts, const std::vector<Joint>& joints = {});

// Where pieces are when they are put together: the motion that carries each panel of `net`, folded in its place on the
// sheet, to its face of the mesh. Equal for all panels of a piece that folds as it should.
std::vector<Pose> assembled(const Mesh& mesh, const Unfolding& net);
// The same with parts moved apart from the middle of the mesh, by `share` of their distance from it.
std::vector<Pose> exploded(const Mesh& mesh, const Kit& kit, double share = 1);

}  // namespace plico
