#include "plico/convex/pair_cut.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "controlled_pairs.h"
#include "plico/convex/svm.h"

namespace plico {
namespace {

ConvexPolyhedron random_hull(Rng& rng, const Vec3& center) {
  std::vector<Vec3> points;
  for (int i = 0; i < 30; ++i) {
    const double x = rng.normal(), y = rng.normal();
    points.push_back(center + Vec3(x, y, rng.normal()));
  }
  return convex_hull(points);
}

// Percent of the union, eq. 5.8.
double percent_lost(const ControlledPair& pair, const Plane& plane) {
  const std::array<ConvexPolyhedron, 2> both = {pair.first, pair.second};
  const double all = union_volume(both);
  return 100 * (1 - (volume(clip(pair.first, plane, 0)) + volume(clip(pair.second, plane.flipped(), 0))) / all);
}

TEST(CutLoss, IsTheVolumeThatClippingTakes) {
  Rng rng(1);
  for (int i = 0; i < 20; ++i) {
    const ConvexPolyhedron a = random_hull(rng, {0, 0, 0}), b = random_hull(rng, {1, 0.5, 0});
    const double x = rng.normal(), y = rng.normal();
    const Plane plane{Vec3(x, y, rng.normal()).normalized(), rng.uniform(-0.5, 1)};
    const CutLoss loss = cut_loss({a, b, 2, 3}, frame_of(plane, {1, 2, 3}));
    EXPECT_NEAR(loss.value, 2 * volume(clip(a, plane.flipped(), 0)) + 3 * volume(clip(b, plane, 0)), 1e-12);
    EXPECT_NEAR(loss.flipped, 2 * volume(clip(a, plane, 0)) + 3 * volume(clip(b, plane.flipped(), 0)), 1e-12);
  }
}

// The plane z = t + a x + b y of a frame.
PlaneFrame tilted(const PlaneFrame& frame, const Vec3& tab) {
  const Vec3 normal = (frame.axes * Vec3(-tab[1], -tab[2], 1)).normalized();
  return frame_of({normal, normal.dot(frame.origin + tab[0] * frame.axes.col(2))}, frame.origin);
}

TEST(CutLoss, DerivativesAreThoseOfDifferences) {
  Rng rng(2);
  for (int i = 0; i < 10; ++i) {
    const ConvexPolyhedron a = random_hull(rng, {0, 0, 0}), b = random_hull(rng, {1, 0.5, 0});
    const CutPair pair{a, b, 1, 2};
    const double x = rng.normal(), y = rng.normal();
    const PlaneFrame frame = frame_of({Vec3(x, y, rng.normal()).normalized(), 0.2}, {0.3, 0.1, 0});
    const CutLoss here = cut_loss(pair, frame);
    const auto value = [&](const Vec3& step) { return cut_loss(pair, tilted(frame, step)).value; };
    for (int k = 0; k < 3; ++k) {
      const Vec3 dk = 1e-4 * Vec3::Unit(k);
      EXPECT_NEAR((value(dk) - value(-dk)) / 2e-4, here.gradient[k], 1e-5);
      for (int l = 0; l < 3; ++l) {
        const Vec3 dl = 1e-4 * Vec3::Unit(l);
        const double second = (value(dk + dl) - value(dk - dl) - value(dl - dk) + value(-dk - dl)) / 4e-8;
        EXPECT_NEAR(second, here.hessian(k, l), 2e-3 * (1 + here.hessian.norm()));
      }
    }
  }
}

TEST(FullCut, FindsTheBestKnownPlaneOfAll53PairsOfBars) {
  for (const ControlledPair& pair : controlled_pairs()) {
    const Plane plane = full_cut({pair.first, pair.second});
    // The values are rounded to 5e-4 of a percent, so this is 1e-5 of the volume.
    EXPECT_NEAR(percent_lost(pair, plane), pair.least_loss, 6e-4) << pair.family << " " << pair.name;
  }
}

TEST(FullCut, LosesNoMoreThanAnyOtherMethod) {
  for (const ControlledPair& pair : controlled_pairs()) {
    const double full = percent_lost(pair, full_cut({pair.first, pair.second}));
    for (CutMethod method : {CutMethod::Lsf, CutMethod::Svm, CutMethod::SvmOffset}) {
      Rng rng(1);
      const double other = percent_lost(pair, cut_plane({pair.first, pair.second}, method, rng, {.samples = 300}));
      EXPECT_LE(full, other + 1e-6) << pair.family << " " << pair.name << " " << name(method);
    }
  }
}

TEST(FullCut, LeavesBothBodiesWhatTheirFloorsAskFor) {
  const ConvexPolyhedron large = bar({5, 1, 1}, 2.5);
  const ConvexPolyhedron small = bar({0.4, 0.4, 0.4}, 0.2, turned(20, {1, 2, 3}), {0, 0, 0.4});
  const Plane free = full_cut({large, small});
  EXPECT_LT(volume(clip(small, free.flipped(), 0)), 0.5 * volume(small));
  const Plane bound = full_cut({large, small}, {0, 0.5 * volume(small)});
  EXPECT_GE(volume(clip(small, bound.flipped(), 0)), 0.499999 * volume(small));
}

TEST(BestOffset, IsAsGoodAsManySamples) {
  Rng rng(3);
  for (int i = 0; i < 10; ++i) {
    const ConvexPolyhedron a = random_hull(rng, {0, 0, 0}), b = random_hull(rng, {1.5, 0.5, 0});
    const Vec3 normal = Vec3(1, rng.uniform(-0.3, 0.3), 0).normalized();
    const auto loss = [&](const Plane& plane) { return cut_loss({a, b}, frame_of(plane, {0, 0, 0})).value; };
    const double best = loss(best_offset({a, b}, normal));
    for (int k = 0; k <= 400; ++k) EXPECT_LE(best, loss({normal, -4 + 0.02 * k}) + 1e-12);
  }
}

TEST(Svm, DividesInTheMiddleOfTheWidestMargin) {
  const std::vector<Vec3> below = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, -1}};
  const std::vector<Vec3> above = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 5}};
  const auto plane = svm_plane(below, above, 100);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->normal.z(), 1, 1e-4);
  EXPECT_NEAR(plane->offset, 1, 1e-3);
}

TEST(Svm, FindsNoPlaneBetweenEqualSets) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_FALSE(svm_plane(points, points, 100));
}

}  // namespace
}  // namespace plico
