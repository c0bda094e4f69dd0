// The collision check on whole sheets against brute force: no crossing is hidden by what it leaves out, be it the
// clearance, panels at a common hinge or panels around a common vertex.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plico/base/rng.h"
#include "plico/motion/collision.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"
#include "plico/origami/projector.h"

namespace plico {
namespace {

struct Placed {
  std::vector<Vec3> corners;
  Vec3 normal;
};

// How far inside its convex outline a point of the panel's plane lies.
double depth_inside(const Placed& panel, const Vec3& point) {
  double depth = 1e300;
  for (std::size_t i = 0; i < panel.corners.size(); ++i) {
    const Vec3 side = panel.corners[(i + 1) % panel.corners.size()] - panel.corners[i];
    depth = std::min(depth, panel.normal.cross(side).normalized().dot(point - panel.corners[i]));
  }
  return depth;
}

// Does a side of `a`, moved inward by `margin`, pierce `b` farther than that from the rims of both?
bool pierces(const Placed& a, const Placed& b, double margin) {
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    const Vec3 &corner = a.corners[i], &next = a.corners[(i + 1) % a.corners.size()];
    const Vec3 inward = a.normal.cross(next - corner).normalized() * margin;
    const Vec3 p = corner + inward, q = next + inward;
    const double from = b.normal.dot(p - b.corners[0]), to = b.normal.dot(q - b.corners[0]);
    if (std::min(from, to) > -margin || std::max(from, to) < margin) continue;
    const Vec3 point = p + from / (from - to) * (q - p);
    if (depth_inside(b, point) > margin && depth_inside(a, point) > 0.9 * margin) return true;
  }
  return false;
}

std::set<PanelPair> crossings(const Linkage& linkage, const Configuration& config, double margin) {
  const std::vector<Pose> poses = folding_map(linkage, config);
  std::vector<Placed> placed(linkage.panels.size());
  for (int p = 0; p < linkage.num_panels(); ++p) {
    for (const Vec3& corner : linkage.panels[p]) placed[p].corners.push_back(poses[p] * corner);
    placed[p].normal = poses[p].linear().col(2);
  }
  std::set<PanelPair> result;
  for (int a = 0; a < linkage.num_panels(); ++a)
    for (int b = a + 1; b < linkage.num_panels(); ++b)
      if (pierces(placed[a], placed[b], margin) || pierces(placed[b], placed[a], margin)) result.insert({a, b});
  return result;
}

int num_shared_corners(const CreasePattern& sheet, const PanelPair& pair) {
  const auto& b = sheet.faces[pair.b];
  return static_cast<int>(std::count_if(sheet.faces[pair.a].begin(), sheet.faces[pair.a].end(),
                                        [&](int v) { return std::count(b.begin(), b.end(), v) > 0; }));
}

// Every crossing that brute force sees is reported; counts those between panels with a common corner.
struct Seen {
  std::size_t crossings = 0, at_a_vertex = 0;
};
Seen expect_all_reported(const CreasePattern& sheet, const Configuration& config) {
  const Linkage linkage = make_linkage(sheet);
  CollisionChecker checker(linkage);
  const std::vector<PanelPair> reported = checker.collisions(config);
  Seen seen;
  for (const PanelPair& pair : crossings(linkage, config, 4 * checker.clearance())) {
    ++seen.crossings;
    seen.at_a_vertex += num_shared_corners(sheet, pair) == 1 ? 1 : 0;
    EXPECT_TRUE(std::binary_search(reported.begin(), reported.end(), pair)) << pair.a << ", " << pair.b;
  }
  EXPECT_EQ(checker.collides(config), !reported.empty());
  return seen;
}

TEST(Crossing, WaterbombPushedPastItsTube) {
  for (double degree : {52.0, 60.0, 75.0, 90.0, 120.0}) {
    const CreasePattern sheet = waterbomb({.columns = 12, .rows = 12, .diagonal_angle = radians(degree)});
    EXPECT_GT(expect_all_reported(sheet, goal(make_linkage(sheet))).crossings, 10u) << degree;
  }
}

TEST(Crossing, PlantedInAMiuraSheet) {
  const CreasePattern sheet = miura({.columns = 24, .rows = 24, .zigzag_angle = radians(110)});
  const Linkage linkage = make_linkage(sheet);
  CollisionChecker checker(linkage);
  EXPECT_FALSE(checker.collides(goal(linkage)));
  std::size_t planted = 0;
  for (int p : {40, 150, 300, 420, 570}) {
    const int h = linkage.parent_hinge[p];
    if (h < 0) continue;
    Configuration config = goal(linkage);
    config[h] = config[h] > 0 ? -radians(170) : radians(170);  // what hangs on the panel swings into the rest
    planted += expect_all_reported(sheet, config).crossings;
  }
  EXPECT_GT(planted, 10u);
}

TEST(Crossing, MiuraBeyondItsLimitIsReported) {
  const CreasePattern sheet = miura({.columns = 24, .rows = 24});
  const Linkage linkage = make_linkage(sheet);
  CollisionChecker checker(linkage);
  EXPECT_FALSE(checker.collides(goal(linkage)));  // all layers lie on each other
  EXPECT_TRUE(checker.collides(1.001 * goal(linkage)));
}

TEST(Crossing, OfPanelsAroundOneVertex) {
  const CreasePattern sheet = waterbomb_base();
  Projector projector(sheet);
  Seen seen;
  for (int seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Configuration config(8);
    for (double& angle : config) angle = 3 * (2 * rng.uniform() - 1);
    const Projection closed = projector.project(config);
    if (!closed.closed) continue;
    const Seen here = expect_all_reported(sheet, closed.config);
    seen.crossings += here.crossings;
    seen.at_a_vertex += here.at_a_vertex;
  }
  EXPECT_GT(seen.at_a_vertex, 200u);
}

TEST(Crossing, TheTubeAngleIsMetToATenThousandthOfADegree) {
  const std::pair<int, double> tubes[] = {{10, 66.782022}, {12, 49.277198}, {16, 34.236430}, {22, 23.995596}};
  for (const auto& [columns, degree] : tubes)
    for (double beyond : {-1e-4, 1e-4}) {
      const Linkage linkage =
          make_linkage(waterbomb({.columns = columns, .rows = 12, .diagonal_angle = radians(degree + beyond)}));
      CollisionChecker checker(linkage, {.clearance = 1e-7, .touch = 1e-10});
      EXPECT_EQ(checker.collides(goal(linkage)), beyond > 0) << columns << " columns, " << beyond;
    }
}

}  // namespace
}  // namespace plico
