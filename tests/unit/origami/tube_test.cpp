// The uniform waterbomb sheet rolls up: at one angle its left and right edges meet. Free just below, contact at,
// crossing just above.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/motion/collision.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

constexpr int kRows = 6;

struct Tube {
  int columns;
  double degree;  // of the diagonals, where the tube closes
};
class WaterbombTube : public testing::TestWithParam<Tube> {
 protected:
  static CreasePattern sheet(double beyond) {
    return waterbomb(
        {.columns = GetParam().columns, .rows = kRows, .diagonal_angle = radians(GetParam().degree + beyond)});
  }
  static std::size_t num_collisions(double beyond) {
    const Linkage linkage = make_linkage(sheet(beyond));
    return CollisionChecker(linkage).collisions(goal(linkage)).size();
  }
};

TEST_P(WaterbombTube, IsFreeBelowTheClosingAngle) { EXPECT_EQ(num_collisions(-0.02), 0u); }

TEST_P(WaterbombTube, TouchesAtTheClosingAngle) {
  const std::vector<Vec3> folded = folded_vertices(sheet(0));
  const int row = GetParam().columns + 1;
  for (int y = 0; y <= kRows; ++y)
    EXPECT_LT((folded[y * row] - folded[y * row + GetParam().columns]).norm(), 1e-6) << y;
  EXPECT_EQ(num_collisions(0), 0u);
}

TEST_P(WaterbombTube, CrossesBeyondTheClosingAngle) { EXPECT_GT(num_collisions(0.03), 0u); }

INSTANTIATE_TEST_SUITE_P(TabulatedAngles, WaterbombTube,
                         testing::Values(Tube{10, 66.782022}, Tube{12, 49.277198}, Tube{16, 34.236430},
                                         Tube{22, 23.995596}),
                         [](const auto& about) { return fmt::format("columns_{}", about.param.columns); });

}  // namespace
}  // namespace plico
