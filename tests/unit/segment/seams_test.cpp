#include "plico/segment/seams.h"

#include <gmock/gmock.h>

#include "plico/shapes/shapes.h"

namespace plico {
namespace {

TEST(Seams, NumbersRunAlongTheSeam) {
  const Mesh mesh{quad_cube(3)};
  std::vector<int> labels(mesh.num_faces(), 0);
  for (int f = 0; f < 9; ++f) labels[f] = 1;
  const Segmentation parts = segmentation_by_labels(mesh, labels);
  const std::vector<int> number = seam_numbers(mesh, parts);
  std::vector<EdgeId> by_number(13);
  int numbered = 0;
  for (EdgeId e : mesh.edges())
    if (number[e] > 0) by_number.at(number[e]) = e, ++numbered;
  ASSERT_EQ(numbered, 12);
  for (int i = 1; i < 12; ++i) {
    const HalfedgeId g = mesh.halfedge(by_number[i]), h = mesh.halfedge(by_number[i + 1]);
    const bool meet = mesh.from(g) == mesh.from(h) || mesh.from(g) == mesh.to(h) || mesh.to(g) == mesh.from(h) ||
                      mesh.to(g) == mesh.to(h);
    EXPECT_TRUE(meet) << i;
  }
}

TEST(Seams, LengthsAreThoseBetweenTwoParts) {
  const Mesh row{open_grid(3, 1)};
  const std::vector<SeamLength> seams = seam_lengths(row, segmentation_by_labels(row, {0, 1, 2}));
  ASSERT_EQ(seams.size(), 2u);
  for (const SeamLength& seam : seams) EXPECT_NEAR(seam.length, 1, 1e-15);
}

}  // namespace
}  // namespace plico
