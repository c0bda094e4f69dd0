// Classic spanning trees of the dual graph. Source: W. Schlickenrieder, Nets of Polyhedra (1997), as used in
// [Xi17] 4.1.3.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "plico/base/rng.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"

namespace plico {

// The first three, and after them their opposites (weights turned round), are functions of a direction.
enum class Heuristic { SteepestEdge, FlatTree, MinimumPerimeter, UnsteepestEdge, SteepTree, MaximumPerimeter, Random };
inline constexpr std::array kHeuristics = {Heuristic::SteepestEdge,   Heuristic::FlatTree,  Heuristic::MinimumPerimeter,
                                           Heuristic::UnsteepestEdge, Heuristic::SteepTree, Heuristic::MaximumPerimeter,
                                           Heuristic::Random};
std::string_view name(Heuristic heuristic);  // "steepest-edge", ...

// A weight in [0, 1] for every edge of the mesh; the lighter an edge, the sooner it becomes a fold.
//   - steepest-edge: edges along `direction` are cut, so those across it are light: |direction . e| / |e|.
//   - flat-tree: dual edges that run flat across `direction` are light.
//   - minimum-perimeter: long edges are light, so that short ones are cut; `direction` breaks no ties and is not used.
// `rng` serves Random only. O(edges).
std::vector<double> dual_weights(const Mesh& mesh, Heuristic heuristic, const Vec3& direction, Rng& rng);

// The spanning forest of least weight (Kruskal), one tree per component of the mesh; ties by edge number. O(n log n).
FoldForest lightest_forest(const Mesh& mesh, const std::vector<double>& weights);

// A direction spread evenly over the sphere.
Vec3 random_direction(Rng& rng);

}  // namespace plico
