// What animals are made of, and how well parts agree with it.
#pragma once
#include <vector>

#include "plico/mesh/mesh.h"
#include "plico/shapes/creature.h"

namespace plico::bench {

// Share of pairs of faces, weighed by their areas, on which two labellings agree that they belong together or not.
double rand_index(const Mesh& mesh, const std::vector<int>& a, const std::vector<int>& b);

// The nearest limb of every face, as the part of the animal that it belongs to: head, trunk, a leg, an arm, a wing, a
// fin, the tail.
std::vector<int> true_parts(const Mesh& mesh, const CreatureOptions& options);

}  // namespace plico::bench
