#include "plico/unfold/by_component.h"

#include <algorithm>

namespace plico {

FoldForest by_component(const Mesh& mesh, const std::function<FoldForest(const Submesh&, int)>& unfold) {
  const Components parts = components(mesh);
  FoldForest whole{std::vector<char>(mesh.num_edges(), 0)};
  for (int c = 0; c < parts.count; ++c) {
    const Submesh part = component(mesh, parts, c);
    const FoldForest own = unfold(part, c);
    for (EdgeId e : part.mesh.edges()) whole.is_fold[part.edge[e]] = own.is_fold[e];
  }
  return whole;
}

int count_parts(const Mesh& mesh, const FoldForest& forest) {
  return mesh.num_faces() - static_cast<int>(std::count(forest.is_fold.begin(), forest.is_fold.end(), 1));
}

}  // namespace plico
