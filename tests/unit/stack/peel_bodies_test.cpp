#include "plico/stack/peel_bodies.h"

#include <gtest/gtest.h>

#include "plico/base/rng.h"

namespace plico {
namespace {

OrientedBox random_box(Rng& rng) {
  OrientedBox box;
  const double x = rng.uniform(), y = rng.uniform(), z = rng.uniform();
  box.center = 5 * Vec3(x, y, z);
  const double a = rng.uniform(), b = rng.uniform(), c = rng.uniform();
  box.half = Vec3(0.1 + a, 0.1 + b, 0.1 + c);
  return box;
}

constexpr int kBoxes = 2 * StandingTrees::kBlock + 30;

TEST(StandingTrees, AsksEveryBoxThatIsNearAndHasALowNumber) {
  Rng rng(5);
  std::vector<OrientedBox> boxes;
  for (int i = 0; i < kBoxes; ++i) boxes.push_back(random_box(rng));
  const StandingTrees trees(boxes);
  for (int i = 0; i < 100; ++i) {
    OrientedBox box = random_box(rng);
    box.axes = rotation(Vec3(1, 2, 2) / 3, rng.uniform());
    const double slack = rng.uniform();
    const int last = rng.below(kBoxes);
    std::vector<int> asked(boxes.size(), 0);
    trees.any_near(box, slack, last, [&](int b) {
      ++asked[b];
      return false;
    });
    for (int b = 0; b < kBoxes; ++b) {
      EXPECT_LE(asked[b], b <= last);
      for (const Vec3& corner : corners_of(box))
        EXPECT_TRUE(asked[b] || b > last || distance(boxes[b], corner) >= slack);
    }
    EXPECT_EQ(trees.any_near(box, slack, last, [](int) { return true; }), asked != std::vector<int>(kBoxes, 0));
  }
}

}  // namespace
}  // namespace plico
