// The slowest ways in which heat would even out over some faces: functions that change only where a shape is narrow.
#pragma once
#include <vector>

#include "plico/segment/dual_graph.h"

namespace plico {

// Eigenvectors of the Laplace operator of the dual graph (arcs weigh cost over distance, nodes their area), those of
// the smallest eigenvalues but the constant one; one entry for each of `faces`, which must be connected. At most
// `count`, and fewer than there are faces. By inverse subspace iteration on one sparse factorization: nearly linear.
std::vector<std::vector<double>> low_eigenvectors(const DualGraph& graph, const std::vector<int>& faces, int count);

}  // namespace plico
