// A disconnected mesh is unfolded component by component.
#pragma once
#include <functional>

#include "plico/fold/unfolding.h"
#include "plico/mesh/submesh.h"

namespace plico {

// Calls `unfold` with every component of the mesh, numbered from 0, and puts the forests together. O(n) and the calls.
FoldForest by_component(const Mesh& mesh, const std::function<FoldForest(const Submesh&, int)>& unfold);

// Connected pieces of a forest.
int count_parts(const Mesh& mesh, const FoldForest& forest);

}  // namespace plico
