#include "plico/origami/layers.h"

#include <gtest/gtest.h>

#include "plico/origami/bases.h"

namespace plico {
namespace {

struct Letter {
  Linkage linkage = make_linkage(letter());
  Layers layers{linkage, default_clearance(linkage)};
  // Both outer thirds turned by these angles, then the bend across, all in degrees.
  Configuration at(double first, double last, double bend = 0) const {
    Configuration config(7);
    config << first, first, last, last, bend, -bend, bend;
    return config * (kPi / 180);
  }
};

TEST(Layers, OnlyPanelsWithoutACommonHingeAreListed) {
  const Letter letter;
  EXPECT_TRUE(letter.layers.stacked(letter.at(0, 0)).empty());
  EXPECT_TRUE(letter.layers.stacked(letter.at(180, 90)).empty());
  const std::vector<LayerPair> pairs = letter.layers.stacked(letter.at(180, 180));
  ASSERT_EQ(pairs.size(), 2u);  // the outer thirds of both halves
  const std::vector<Pose> poses = folding_map(letter.linkage, letter.at(180, 180));
  for (const LayerPair& pair : pairs) {
    EXPECT_LT(pair.a, pair.b);
    const Vec3 middle = poses[pair.b] * pair.point;  // over the middle third, by plates as large as panels
    EXPECT_NEAR(middle.x(), 1.5, 1e-3);
    EXPECT_NEAR(std::abs(middle.y() - 1), 0.5, 1e-3);
    EXPECT_NEAR(middle.z(), 0, 1e-12);
  }
}

TEST(Layers, TheThirdThatFoldsLastLiesOnTheOther) {
  const Letter letter;
  const std::vector<LayerPair> pairs = letter.layers.stacked(letter.at(180, 180));
  const std::vector<signed char> last_later = letter.layers.sides(pairs, letter.at(180, 150));
  const std::vector<signed char> first_later = letter.layers.sides(pairs, letter.at(150, 180));
  ASSERT_EQ(last_later.size(), 2u);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NE(last_later[i], 0);
    EXPECT_EQ(first_later[i], -last_later[i]);
  }
}

TEST(Layers, AStackThatTurnsKeepsItsSides) {
  const Letter letter;
  const std::vector<LayerPair> pairs = letter.layers.stacked(letter.at(180, 180));
  for (const signed char side : letter.layers.sides(pairs, letter.at(180, 180, 60))) EXPECT_EQ(side, 0);
}

}  // namespace
}  // namespace plico
