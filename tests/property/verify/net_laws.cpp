// The sweep against brute force, and lay_flat against the judge, on random unfoldings of random bumpy shapes.
#include <gtest/gtest.h>

#include "plico/geom/predicates.h"
#include "plico/verify/net.h"
#include "random_nets.h"

namespace plico {
namespace {

// Two triangles share an interior point when no side of either separates them; every pair is tried.
std::vector<std::pair<int, int>> brute_force(const CreasePattern& sheet, double shrink) {
  std::vector<std::array<Vec2, 3>> triangles;
  for (int f = 0; f < sheet.num_faces(); ++f) {
    const std::vector<Vec2> p = polygon(sheet, f);
    const Vec2 middle = (p[0] + p[1] + p[2]) / 3;
    triangles.push_back({});
    for (int i = 0; i < 3; ++i) triangles.back()[i] = p[i] + (middle - p[i]) * shrink;
  }
  const auto separated = [&](int f, int g) {
    for (int i = 0; i < 3; ++i) {
      int outside = 0;
      for (const Vec2& p : triangles[g]) outside += orient2d(triangles[f][i], triangles[f][(i + 1) % 3], p) <= 0;
      if (outside == 3) return true;
    }
    return false;
  };
  std::vector<std::pair<int, int>> pairs;
  for (int f = 0; f < sheet.num_faces(); ++f)
    for (int g = f + 1; g < sheet.num_faces(); ++g)
      if (!separated(f, g) && !separated(g, f)) pairs.emplace_back(f, g);
  return pairs;
}

TEST(NetLaw, SweepFindsThePairsThatBruteForceFinds) {
  long found = 0;
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Mesh mesh = bumpy_torus(rng, 3 + rng.below(8), 3 + rng.below(6));
    const Unfolding net = lay_flat(mesh, random_tree(mesh, rng));
    const Overlaps overlaps = find_overlaps(net.sheet);
    std::vector<std::pair<int, int>> pairs;
    for (const OverlappingPair& pair : overlaps.listed) pairs.emplace_back(pair.a, pair.b);
    EXPECT_EQ(pairs, brute_force(net.sheet, OverlapOptions().shrink));
    found += overlaps.count;
  }
  EXPECT_GT(found, 100) << "random trees overlap, so the law was tried";
}

TEST(NetLaw, LaidFlatFoldsBackWhateverTheTree) {
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Mesh mesh = bumpy_torus(rng, 3 + rng.below(8), 3 + rng.below(6));
    const NetVerdict verdict = verify_net(lay_flat(mesh, random_tree(mesh, rng)), mesh);
    for (const Defect& defect : verdict.defects) EXPECT_EQ(defect.code, "net/overlap") << defect.message;
    EXPECT_LT(verdict.closing_error, 1e-13);
    EXPECT_LT(verdict.congruence_error, 1e-14);
    EXPECT_LT(verdict.angle_error, 1e-11);
  }
}

TEST(NetLaw, MovingTheWholeSheetChangesNoVerdict) {
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Mesh mesh = bumpy_torus(rng, 6, 5);
    Unfolding net = lay_flat(mesh, random_tree(mesh, rng));
    const long before = verify_net(net, mesh).overlaps.count;
    const Eigen::Rotation2Dd turn(rng.uniform(0, 2 * kPi));
    const Vec2 shift(rng.uniform(-10, 10), rng.uniform(-10, 10));
    for (Vec2& p : net.sheet.vertices) p = turn * p + shift;
    EXPECT_EQ(verify_net(net, mesh).overlaps.count, before);
  }
}

TEST(NetLaw, LongChainsStillClose) {
  // A spiral of 20,000 triangles around a tube: one chain, so rounding adds up the most.
  Rng rng(3);
  const Mesh mesh = bumpy_torus(rng, 100, 100);
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges()) {
    const int f = mesh.face(mesh.halfedge(e)), g = mesh.face(mesh.twin(mesh.halfedge(e)));
    // Around each ring, then on to the next ring at its end.
    const int a = std::min(f, g), b = std::max(f, g);
    const bool same_ring = a / 200 == b / 200 && b - a < 199;
    const bool next_ring = b / 200 - a / 200 == 1 && a % 200 == 0;
    forest.is_fold[e] = same_ring || next_ring;
  }
  const NetVerdict verdict = verify_net(lay_flat(mesh, forest), mesh);
  for (const Defect& defect : verdict.defects) EXPECT_EQ(defect.code, "net/overlap") << defect.message;
  EXPECT_EQ(verdict.parts, 1);
  EXPECT_LT(verdict.closing_error, 1e-11);
}

}  // namespace
}  // namespace plico
