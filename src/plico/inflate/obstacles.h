// What must not happen while vertices move: faces that meet, faces that turn over.
#pragma once
#include <utility>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

class Obstacles {
 public:
  explicit Obstacles(const Mesh& start);  // O(n log n)

  // Faces that meet another one which they did not meet at the start, decided exactly, and faces whose normal is at
  // more than 90 degrees to what it was; ascending, empty when `points` are fine. O(n log n + pairs).
  std::vector<int> faces_in_the_way(const std::vector<Vec3>& points) const;

 private:
  PolygonSoup start_;
  std::vector<std::pair<int, int>> meet_;
};

}  // namespace plico
