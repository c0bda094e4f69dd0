// A random side by which a random panel of a tree can be hung anew.
#pragma once
#include <vector>

#include "plico/base/rng.h"
#include "plico/mesh/mesh.h"
#include "plico/unfold/dual_tree.h"

namespace plico {

// -1 when the panel drawn is the root, or has no other side to hang by. Draws one or two numbers.
inline int random_hanging(DualTree& tree, const Mesh& mesh, Rng& rng) {
  const int panel = rng.below(mesh.num_faces());
  if (tree.parent(panel) < 0) return -1;
  std::vector<int> sides;
  for (int f : tree.gather(panel))
    for (HalfedgeId h : mesh.halfedges(FaceId(f)))
      if (!tree.gathered(mesh.face(mesh.twin(h))) && h != tree.parent_side(panel)) sides.push_back(h);
  return sides.empty() ? -1 : sides[rng.below(static_cast<int>(sides.size()))];
}

}  // namespace plico
