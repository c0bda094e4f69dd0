#include "plico/unfold/overlap.h"

#include <algorithm>

#include "plico/base/error.h"
#include "plico/unfold/panel_grid.h"

namespace plico {

std::vector<Vec2> lay_panels(const FlatFaces& faces, const FoldForest& tree) {
  const Mesh& mesh = faces.mesh();
  std::vector<Vec2> at(mesh.num_halfedges());
  std::vector<char> seen(mesh.num_faces(), 0);
  std::vector<FaceId> queue{FaceId(0)};
  seen[0] = 1;
  faces.place(0, Motion2{}, at.data());
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (HalfedgeId h : mesh.halfedges(queue[i])) {
      const HalfedgeId g = mesh.twin(h);
      if (!tree.is_fold[mesh.edge(h)] || !g.valid() || seen[mesh.face(g)]) continue;
      const FaceId f = mesh.face(g);
      faces.place(f, carry_side(faces, g, at[mesh.next(h)], at[h]), &at[mesh.soup().offsets[f]]);
      seen[f] = 1;
      queue.push_back(f);
    }
  }
  PLICO_ASSERT(static_cast<int>(queue.size()) == mesh.num_faces());
  return at;
}

std::vector<std::pair<int, int>> overlapping_pairs(const FlatFaces& faces, const std::vector<Vec2>& at) {
  const Mesh& mesh = faces.mesh();
  PanelGrid grid(mesh.num_faces(), faces.cell_size());
  std::vector<std::pair<int, int>> pairs;
  for (FaceId f : mesh.faces()) {
    const Vec2* corners = &at[mesh.soup().offsets[f]];
    const Box2 box = box_of(corners, mesh.degree(f));
    const std::size_t before = pairs.size();
    grid.visit_meeting(box, [&](int other) {
      if (faces.overlap(f, corners, other, &at[mesh.soup().offsets[other]])) pairs.emplace_back(other, f);
      return true;
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
    grid.insert(f, box);
  }
  return pairs;
}

}  // namespace plico
