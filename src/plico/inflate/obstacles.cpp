#include "plico/inflate/obstacles.h"

#include <algorithm>
#include <iterator>

#include "plico/mesh/self_intersections.h"
#include "plico/mesh/triangulate.h"

namespace plico {
namespace {

constexpr std::size_t kMaxPairs = 100000;

}  // namespace

Obstacles::Obstacles(const Mesh& start) : start_(start.soup()), meet_(self_intersections(start_, kMaxPairs)) {}

std::vector<int> Obstacles::faces_in_the_way(const std::vector<Vec3>& points) const {
  PolygonSoup now = start_;
  now.points = points;
  std::vector<std::pair<int, int>> fresh;
  const auto meet = self_intersections(now, kMaxPairs);
  std::set_difference(meet.begin(), meet.end(), meet_.begin(), meet_.end(), std::back_inserter(fresh));
  std::vector<int> faces;
  for (const auto& [f, g] : fresh) {
    faces.push_back(f);
    faces.push_back(g);
  }
  for (int f = 0; f < now.num_faces(); ++f)
    if (!(twice_vector_area(now, f).dot(twice_vector_area(start_, f)) > 0)) faces.push_back(f);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace plico
