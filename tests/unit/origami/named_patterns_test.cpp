#include "plico/origami/named_patterns.h"

#include <gtest/gtest.h>

#include <set>

#include "plico/base/error.h"
#include "plico/motion/collision.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

TEST(NamedPatterns, EveryOneIsMadeAndItsGoalClosesWithoutCollision) {
  std::set<std::string> names;
  for (const NamedPattern& pattern : named_patterns()) {
    const CreasePattern sheet = make_pattern(pattern.name);
    const Linkage linkage = make_linkage(sheet);
    EXPECT_LT(closure(real_vertices(sheet), goal(linkage)).worst, 1e-12) << pattern.name;
    EXPECT_FALSE(CollisionChecker(linkage).collides(goal(linkage))) << pattern.name;
    EXPECT_TRUE(names.insert(pattern.name).second) << pattern.name;
    EXPECT_FALSE(pattern.description.empty()) << pattern.name;
  }
}

// Without an angle, no tessellation rolls so far that it meets itself.
TEST(NamedPatterns, UsualGoalsOfWideSheetsAreFree) {
  for (const char* name : {"waterbomb", "yoshimura"})
    for (const int columns : {2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 30, 48, 100}) {
      const Linkage linkage = make_linkage(make_pattern(name, {.columns = columns, .rows = 4}));
      EXPECT_FALSE(CollisionChecker(linkage).collides(goal(linkage))) << name << " " << columns;
    }
}

TEST(NamedPatterns, OptionsReachThePattern) {
  EXPECT_EQ(make_pattern("miura", {.columns = 3, .rows = 4}).num_faces(), 12);
  EXPECT_EQ(make_pattern("miura", {.columns = 3, .rows = 4, .diagonals = true}).num_faces(), 24);
  const Configuration folded = goal(make_linkage(make_pattern("waterbomb", {.angle = 0.25})));
  EXPECT_EQ(folded.minCoeff(), -0.25);
  const CreasePattern steep = make_pattern("yoshimura", {.sector = 1.25});
  EXPECT_NEAR(steep.vertices.back().y(), 4 * std::tan(1.25) / 2, 1e-12);
}

TEST(NamedPatterns, WhatAPatternDoesNotHaveIsRefused) {
  EXPECT_THROW(make_pattern("unicorn"), InvalidOption);
  EXPECT_THROW(make_pattern("diamond", {.columns = 2, .rows = 2}), InvalidOption);
  EXPECT_THROW(make_pattern("sailboat", {.angle = 1}), InvalidOption);
  EXPECT_THROW(make_pattern("waterbomb", {.sector = 1}), InvalidOption);
  EXPECT_THROW(make_pattern("yoshimura", {.diagonals = true}), InvalidOption);
  EXPECT_THROW(make_pattern("miura", {.columns = 3}), InvalidOption);
  EXPECT_THROW(make_pattern("miura", {.columns = 3, .rows = 2000}), InvalidOption);
}

}  // namespace
}  // namespace plico
