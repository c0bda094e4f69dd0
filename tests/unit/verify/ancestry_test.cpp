#include "plico/verify/ancestry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "plico/base/rng.h"

namespace plico {
namespace {

int common_by_climbing(const std::vector<int>& parent, int a, int b) {
  for (; a >= 0; a = parent[a])
    for (int c = b; c >= 0; c = parent[c])
      if (c == a) return a;
  return -1;
}

TEST(Ancestry, NodesOfDifferentTreesShareNothing) {
  const Ancestry two({-1, 0, -1, 2}, {0, 2, 1, 3});
  EXPECT_EQ(two.common(1, 3), -1);
  EXPECT_EQ(two.common(0, 2), -1);
  EXPECT_EQ(two.common(0, 1), 0);
  EXPECT_EQ(two.common(3, 3), 3);
}

TEST(Ancestry, AgreesWithClimbingOnRandomForests) {
  for (int seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int n = 1 + rng.below(40);
    std::vector<int> parent(n, -1), order(n);
    for (int i = 1; i < n; ++i) parent[i] = rng.below(i + 1) - 1;
    std::iota(order.begin(), order.end(), 0);
    const Ancestry ancestry(parent, order);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) ASSERT_EQ(ancestry.common(a, b), common_by_climbing(parent, a, b)) << a << " " << b;
  }
}

}  // namespace
}  // namespace plico
