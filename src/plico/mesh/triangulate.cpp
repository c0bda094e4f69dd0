#include "plico/mesh/triangulate.h"

#include "plico/geom/polygon.h"

namespace plico {

Vec3 twice_vector_area(const PolygonSoup& soup, int face) {
  const auto corners = soup.face(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec3& origin = soup.points[corners[0]];
    const Vec3 a = soup.points[corners[i - 1]] - origin, b = soup.points[corners[i]] - origin;
    sum += a.cross(b);
  }
  return sum;
}

std::vector<Vec2> projected(const PolygonSoup& soup, int face) {
  const Vec3 n = twice_vector_area(soup, face);
  Eigen::Index axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  // The two other axes, in the order that keeps the turn.
  Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (n[axis] < 0) std::swap(u, v);
  std::vector<Vec2> polygon;
  polygon.reserve(soup.face(face).size());
  for (int corner : soup.face(face)) polygon.emplace_back(soup.points[corner][u], soup.points[corner][v]);
  return polygon;
}

std::vector<std::array<int, 3>> triangulate_face(const PolygonSoup& soup, int face) {
  const auto corners = soup.face(face);
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{corners[0], corners[1], corners[2]}};
  std::vector<std::array<int, 3>> triangles = triangulate(projected(soup, face));
  for (auto& triangle : triangles)
    for (int& corner : triangle) corner = corners[corner];
  return triangles;
}

}  // namespace plico
