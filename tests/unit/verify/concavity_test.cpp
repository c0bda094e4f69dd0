#include "plico/verify/concavity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plico/segment/given.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

// Two cubes with a gap between them.
Mesh two_cubes() {
  PolygonSoup soup = cube();
  const int n = soup.num_points(), faces = soup.num_faces();
  for (int v = 0; v < n; ++v) soup.points.push_back(soup.points[v] + Vec3(2, 0, 0));
  for (int f = 0; f < faces; ++f) {
    std::vector<int> corners(soup.face(f).begin(), soup.face(f).end());
    for (int& v : corners) v += n;
    soup.add_face(corners);
  }
  return Mesh(std::move(soup));
}

TEST(ConcavityBound, OfConvexPartsIsZero) {
  const Mesh mesh = two_cubes();
  EXPECT_NEAR(concavity_bound(mesh, by_components(mesh)), 0, 1e-15);
}

TEST(ConcavityBound, OfAPartInsideTheHullOfItsFacesIsTheDistanceToTheHull) {
  PolygonSoup soup = cube();
  const double half = std::abs(soup.points[0].x());
  soup.points.emplace_back(0.1, 0.2, -0.3);
  const int inside = soup.num_points() - 1;
  soup.points.emplace_back(0.1, 0.2, -0.29);
  soup.points.emplace_back(0.1, 0.21, -0.29);
  soup.add_face({inside, inside + 1, inside + 2});
  const Mesh mesh(std::move(soup));
  const Segmentation whole = segmentation_by_labels(mesh, std::vector<int>(mesh.num_faces(), 0));
  EXPECT_NEAR(concavity_bound(mesh, whole), half - 0.29, 1e-15);
}

}  // namespace
}  // namespace plico
