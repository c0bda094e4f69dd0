// How the parts of an unfolding stand on the sheet.
#include "plico/fold/unfolding.h"

#include <gtest/gtest.h>

#include "plico/shapes/shapes.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

Eigen::AlignedBox2d box_of_part(const Unfolding& net, int part) {
  Eigen::AlignedBox2d box;
  for (std::size_t f = 0; f < net.part.size(); ++f)
    if (net.part[f] == part)
      for (int v : net.sheet.faces[f]) box.extend(net.sheet.vertices[v]);
  return box;
}

// In one row 5,120 parts would reach so far that their coordinates lose three digits.
TEST(LayFlat, ManyPartsStandInRowsOfAHundred) {
  const Mesh ball(geodesic_sphere(16));
  const Unfolding net = lay_flat(ball, FoldForest{std::vector<char>(ball.num_edges(), 0)});
  ASSERT_EQ(net.num_parts(), ball.num_faces());
  const Eigen::AlignedBox2d first = box_of_part(net, 0), last_of_row = box_of_part(net, 99),
                            next = box_of_part(net, 100);
  EXPECT_GT(last_of_row.min().x(), 50 * first.sizes().x());
  EXPECT_EQ(next.min().x(), 0);
  EXPECT_GT(next.min().y(), last_of_row.max().y());
  EXPECT_LT(box_of_part(net, 5119).max().norm(), 200 * first.diagonal().norm());
  EXPECT_TRUE(verify_net(net, ball).valid());
}

}  // namespace
}  // namespace plico
