#include "plico/base/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace plico {
namespace {

TEST(Rng, SameSeedSameNumbers) {
  Rng a(7), b(7), c(8);
  EXPECT_EQ(a.next(), b.next());
  EXPECT_NE(a.next(), c.next());
}

TEST(Rng, AStreamDependsOnSeedAndIndexOnly) {
  const Rng rng(7);
  Rng used(7);
  used.next();
  EXPECT_EQ(Rng(rng.stream(3)).next(), used.stream(3).next());
  std::set<std::uint64_t> firsts;
  for (int i = 0; i < 1000; ++i) firsts.insert(rng.stream(i).next());
  EXPECT_EQ(firsts.size(), 1000u);
}

TEST(Rng, UniformStaysInRangeWithTheRightMoments) {
  Rng rng(1);
  double sum = 0, squares = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = rng.uniform(2, 4);
    ASSERT_GE(x, 2);
    ASSERT_LT(x, 4);
    sum += x;
    squares += (x - 3) * (x - 3);
  }
  EXPECT_NEAR(sum / n, 3, 0.01);             // 5 standard errors
  EXPECT_NEAR(squares / n, 1.0 / 3, 0.005);  // variance of a width of 2
}

TEST(Rng, NormalHasMeanZeroAndVarianceOne) {
  Rng rng(1);
  double sum = 0, squares = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = rng.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0, 0.016);
  EXPECT_NEAR(squares / n, 1, 0.023);
}

TEST(Rng, BelowReachesEveryValueEquallyOften) {
  Rng rng(1);
  int counts[6] = {};
  for (int i = 0; i < 60000; ++i) ++counts[rng.below(6)];
  for (const int count : counts) EXPECT_NEAR(count, 10000, 460);  // 5 standard deviations
  EXPECT_EQ(rng.below(1), 0);
}

}  // namespace
}  // namespace plico
