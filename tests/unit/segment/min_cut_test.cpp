#include "plico/segment/min_cut.h"

#include <gtest/gtest.h>

#include <limits>

#include "plico/base/rng.h"

namespace plico {
namespace {

struct Edge {
  int a, b;
  double capacity;
};

// Every way of giving the nodes between to either side.
double cheapest_by_trying_all(int n, const std::vector<Edge>& edges) {
  double least = std::numeric_limits<double>::infinity();
  for (int sides = 0; sides < 1 << (n - 2); ++sides) {
    const auto side = [&](int v) { return v == 0 ? 1 : v == n - 1 ? 0 : sides >> (v - 1) & 1; };
    double cost = 0;
    for (const Edge& e : edges)
      if (side(e.a) != side(e.b)) cost += e.capacity;
    least = std::min(least, cost);
  }
  return least;
}

TEST(MinCut, IsTheCheapestOfAllCutsOfRandomGraphs) {
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int n = 3 + rng.below(10);
    std::vector<Edge> edges;
    const int count = n + rng.below(3 * n);
    for (int i = 0; i < count; ++i) {
      const int a = rng.below(n), b = rng.below(n);
      const double capacity = rng.below(4) == 0 ? 0 : rng.uniform();
      if (a != b) edges.push_back({a, b, capacity});
    }
    MinCut cut(n);
    for (const Edge& e : edges) cut.add_edge(e.a, e.b, e.capacity);
    cut.make_source(0);
    cut.make_sink(n - 1);
    const double cost = cut.solve();
    EXPECT_NEAR(cost, cheapest_by_trying_all(n, edges), 1e-12);
    double across = 0;
    for (const Edge& e : edges)
      if (cut.on_source_side(e.a) != cut.on_source_side(e.b)) across += e.capacity;
    EXPECT_NEAR(cost, across, 1e-12);
  }
}

TEST(MinCut, TakesSeveralSourcesAndSinks) {
  MinCut cut(4);
  cut.add_edge(0, 1, 1);
  cut.add_edge(1, 2, 5);
  cut.add_edge(2, 3, 1);
  cut.make_source(0);
  cut.make_source(3);
  cut.make_sink(1);
  EXPECT_EQ(cut.solve(), 2);
  EXPECT_TRUE(cut.on_source_side(0) && cut.on_source_side(3));
  EXPECT_FALSE(cut.on_source_side(1) || cut.on_source_side(2));
}

}  // namespace
}  // namespace plico
