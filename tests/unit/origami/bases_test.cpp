#include "plico/origami/bases.h"

#include <gtest/gtest.h>

#include "plico/origami/closure.h"

namespace plico {
namespace {

struct Base {
  const char* name;
  CreasePattern sheet;
  int real_vertices, creases, panels;
};

std::vector<Base> bases() {
  return {{"l", l(), 0, 2, 3},
          {"l2", l2(), 1, 4, 4},
          {"waterbomb", waterbomb_base(), 1, 8, 8},
          {"diamond", diamond(), 1, 6, 6},
          {"box1", box1(), 1, 5, 5},
          {"box2", box2(), 2, 9, 8},
          {"fly1", fly1(), 1, 8, 8},
          {"fly2", fly2(), 2, 11, 10},
          {"sailboat", sailboat(), 13, 32, 20}};
}

TEST(Bases, HaveTheCountsOfTable31) {
  for (const Base& base : bases()) {
    EXPECT_EQ(real_vertices(base.sheet).size(), base.real_vertices) << base.name;
    EXPECT_EQ(make_linkage(base.sheet).num_hinges(), base.creases) << base.name;
    EXPECT_EQ(base.sheet.num_faces(), base.panels) << base.name;
  }
}

TEST(Bases, GoalsClose) {
  for (const Base& base : bases())
    EXPECT_LT(closure(real_vertices(base.sheet), goal(make_linkage(base.sheet))).worst, 1e-12) << base.name;
}

}  // namespace
}  // namespace plico
