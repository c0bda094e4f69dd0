#include "limbs.h"

#include <algorithm>
#include <map>
#include <utility>

#include "plico/mesh/measures.h"

namespace plico::bench {

double rand_index(const Mesh& mesh, const std::vector<int>& a, const std::vector<int>& b) {
  std::map<int, double> in_a, in_b;
  std::map<std::pair<int, int>, double> in_both;
  double total = 0;
  for (FaceId f : mesh.faces()) {
    const double w = area(mesh, f);
    in_a[a[f]] += w, in_b[b[f]] += w, in_both[{a[f], b[f]}] += w, total += w;
  }
  const auto squares = [](const auto& sums) {
    double sum = 0;
    for (const auto& [key, w] : sums) sum += w * w;
    return sum;
  };
  return 1 - (squares(in_a) + squares(in_b) - 2 * squares(in_both)) / (total * total);
}

namespace {

// The part of the animal that each of creature_limbs() belongs to.
const std::vector<int>& parts_of_limbs(Animal animal) {
  static const std::map<Animal, std::vector<int>> parts{
      {Animal::Bird, {0, 1, 1, 1, 2, 3, 4, 3, 4}},
      {Animal::Dog, {0, 1, 1, 1, 2, 3, 4, 5, 4, 5, 6, 7, 6, 7, 6, 7, 8}},
      {Animal::Fish, {0, 0, 1, 2, 3, 4, 5, 6}},
      {Animal::Dinosaur, {0, 1, 1, 1, 2, 2, 3, 4, 3, 4, 3, 4, 5, 6, 5, 6}}};
  return parts.at(animal);
}

}  // namespace

std::vector<int> true_parts(const Mesh& mesh, const CreatureOptions& options) {
  std::vector<SmoothBody> limbs;
  for (const Limb& limb : creature_limbs(options)) limbs.emplace_back(std::vector<Limb>{limb});
  std::vector<int> part;
  for (FaceId f : mesh.faces()) {
    const Vec3 at = center(mesh, f);
    const auto nearest = std::min_element(limbs.begin(), limbs.end(), [&](const SmoothBody& a, const SmoothBody& b) {
      return a.value(at) < b.value(at);
    });
    part.push_back(parts_of_limbs(options.animal)[nearest - limbs.begin()]);
  }
  return part;
}

}  // namespace plico::bench
