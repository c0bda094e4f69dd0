#include "plico/verify/sheet_motion.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "plico/origami/bases.h"
#include "plico/origami/continuation.h"
#include "plico/origami/patterns.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

// Waypoints at equal times whose configurations are the goals of `sheet(share)`, share from `from` to 1.
template <class PageLayout>
FoldingPath closed_form(PageLayout sheet, int steps, double from = 0) {
  FoldingPath path;
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    path.waypoints.push_back({share, goal(make_linkage(sheet(from + (1 - from) * share)))});
  }
  return path;
}

FoldingPath miura_path(int size, double degree, int steps) {
  return closed_form(
      [&](double share) { return miura({.columns = size, .rows = size, .zigzag_angle = radians(share * degree)}); },
      steps);
}

// Samples every hinge between waypoints: how far its ends come apart, and its panels' rotation from a turn about it.
struct Opening {
  double gap = 0, twist = 0;
};
Opening sampled(const Linkage& linkage, const FoldingPath& path, const SheetMotion& motion, int samples) {
  Opening worst;
  std::vector<Pose> poses(linkage.panels.size());
  for (int i = 0; i <= samples; ++i) {
    const double time = static_cast<double>(i) / samples;
    motion.place(time, {}, poses);
    const Configuration config = path.at(time);
    for (int h = 0; h < linkage.num_hinges(); ++h) {
      const Hinge& hinge = linkage.hinges[h];
      const Pose &left = poses[hinge.left], &right = poses[hinge.right];
      for (const Vec3& end : {hinge.from, hinge.to}) worst.gap = std::max(worst.gap, (left * end - right * end).norm());
      const Eigen::AngleAxisd turn(-config[h], (hinge.to - hinge.from).normalized());
      const Eigen::Matrix3d off = (left.linear() * turn.toRotationMatrix()).transpose() * right.linear();
      worst.twist = std::max(worst.twist, Eigen::AngleAxisd(off).angle());
    }
  }
  return worst;
}

TEST(SheetMotion, NoHingeOpensFartherThanTheBoundAndTheBoundIsClose) {
  const Linkage linkage = make_linkage(miura({.columns = 6, .rows = 5}));
  const FoldingPath path = closed_form(
      [](double share) { return miura({.columns = 6, .rows = 5, .zigzag_angle = radians(150 * share)}); }, 12);
  const SheetMotion motion(linkage, path);
  const Opening worst = sampled(linkage, path, motion, 600);
  EXPECT_LE(worst.gap, motion.loops().gap);
  EXPECT_GT(worst.gap, 0.2 * motion.loops().gap);
  EXPECT_LE(worst.twist, motion.loops().twist);
  EXPECT_GT(worst.twist, 0);
}

TEST(SheetMotion, TheGapFallsWithTheSquareOfTheStepAndDoesNotGrowWithTheSheet) {
  const auto gap = [](int size, int steps) {
    return SheetMotion(make_linkage(miura({.columns = size, .rows = size})), miura_path(size, 120, steps)).loops().gap;
  };
  EXPECT_NEAR(gap(4, 20) / gap(4, 40), 4, 0.2);
  EXPECT_LT(gap(16, 20), 1.05 * gap(4, 20));
}

TEST(SheetMotion, PointsStayWithinBendOfTheirChords) {
  const Linkage linkage = make_linkage(waterbomb({.columns = 6, .rows = 4}));
  const FoldingPath path = closed_form(
      [](double share) { return waterbomb({.columns = 6, .rows = 4, .diagonal_angle = radians(60 * share)}); }, 9);
  SheetMotion motion(linkage, path);
  std::vector<Pose> start(linkage.panels.size()), end = start, now = start;
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{{0, 1}, {0.01, 0.05}, {0.3, 0.34}, {0.2, 0.8}}) {
    motion.place(from, {}, start);
    motion.place(to, {}, end);
    motion.look_at(from, to, start);
    for (int i = 0; i <= 50; ++i) {
      const double share = i / 50.0;
      motion.place(from + share * (to - from), {}, now);
      for (int p = 0; p < linkage.num_panels(); ++p)
        for (const Vec3& x : linkage.panels[p])
          EXPECT_LE((now[p] * x - (1 - share) * (start[p] * x) - share * (end[p] * x)).norm(),
                    motion.bend(p, -1) + 1e-12);
    }
  }
}

TEST(SheetMotion, SplitsIntervalsAtWaypoints) {
  const Linkage linkage = make_linkage(miura());
  const FoldingPath path = miura_path(3, 90, 4);
  const SheetMotion motion(linkage, path);
  EXPECT_EQ(motion.split(0, 1), path.waypoints[2].time);
  EXPECT_EQ(motion.split(0, path.waypoints[2].time), path.waypoints[1].time);
  EXPECT_EQ(motion.split(0, path.waypoints[1].time), path.waypoints[1].time / 2);
}

TEST(SheetProof, FlatFoldedSheetsAreFree) {
  for (const auto& [name, sheet] :
       std::vector<std::pair<const char*, CreasePattern>>{{"miura", miura({.columns = 8, .rows = 8})},
                                                          {"l2", l2()},
                                                          {"waterbomb base", waterbomb_base()},
                                                          {"diamond", diamond()}}) {
    const ContinuationResult found =
        continue_to_goal(sheet, {.frames = 400, .max_move = 0.05, .check_collisions = false});
    ASSERT_EQ(found.ending, Ending::Found) << name;
    const PathProof proof = prove_path(make_linkage(sheet), found.path);
    EXPECT_EQ(proof.verdict, PathVerdict::Free) << name << " " << proof.from;
    EXPECT_LT(proof.loops.residual, 1e-11) << name;
    EXPECT_GT(proof.loops.gap, 0) << name;
    EXPECT_LT(proof.loops.gap, proof.clearance) << name;
  }
}

// A third of the letter after the other, then the bend across all layers, in which they lie flat on each other.
TEST(SheetProof, AStackMayTurn) {
  const Linkage linkage = make_linkage(letter());
  constexpr int kSteps = 200;
  FoldingPath path;
  path.waypoints.push_back({0, flat(linkage)});
  for (const auto& hinges : std::vector<std::vector<int>>{{0, 1}, {2, 3}, {4, 5, 6}}) {
    const Waypoint start = path.waypoints.back();
    for (int k = 1; k <= kSteps; ++k) {
      Waypoint next = start;
      next.time += k / (3.0 * kSteps);
      for (int h : hinges) next.config[h] = k * linkage.hinges[h].target / kSteps;
      path.waypoints.push_back(next);
    }
  }
  path.waypoints.back().time = 1;
  const PathProof proof = prove_path(linkage, path);
  EXPECT_EQ(proof.verdict, PathVerdict::Free) << proof.from << ": " << proof.panel_a << " " << proof.panel_b;
}

TEST(SheetProof, AWaypointThatDoesNotCloseIsNamed) {
  const Linkage linkage = make_linkage(miura());
  FoldingPath path = miura_path(3, 90, 60);
  path.waypoints[20].config[linkage.loop_hinges[1]] += 1e-3;
  const PathProof proof = prove_path(linkage, path);
  EXPECT_EQ(proof.verdict, PathVerdict::NotClosed);
  EXPECT_EQ(proof.from, path.waypoints[20].time);
  EXPECT_EQ(proof.loops.waypoint, 20);
  EXPECT_EQ(proof.loops.hinge, linkage.loop_hinges[1]);
  EXPECT_NEAR(proof.loops.residual, 1e-3, 1e-9);
}

TEST(SheetProof, AStepThatTearsTheLoopsBetweenWaypointsIsNoProof) {
  const PathProof proof = prove_path(make_linkage(miura()), miura_path(3, 150, 3));
  EXPECT_EQ(proof.verdict, PathVerdict::Undecided);
  EXPECT_TRUE(proof.too_coarse);
  EXPECT_GE(proof.loops.gap, proof.clearance);
}

// From +170 to -170 degrees is one short turn for the panels, through each other, but a long one for the fold angle.
TEST(SheetProof, AFlapDoesNotJumpThroughItsNeighbour) {
  const Linkage linkage = make_linkage(l2());
  Configuration before = flat(linkage), after = before;
  for (int h = 0; h < linkage.num_hinges(); ++h)
    if (std::abs(linkage.hinges[h].target) > 3) before[h] = radians(179.9), after[h] = -before[h];
  FoldingPath path;
  path.waypoints = {{0, before}, {1, after}};
  EXPECT_NE(prove_path(linkage, path).verdict, PathVerdict::Free);
}

struct Tube {
  int columns;
  double degree;  // of the diagonals, where the tube closes
};
class TubeProof : public testing::TestWithParam<Tube> {
 protected:
  // The last degree before the closing angle and `beyond` degrees more.
  static PathProof proof(double beyond) {
    const auto [columns, degree] = GetParam();
    const double last = degree + beyond;
    const auto sheet = [&](double share) {
      return waterbomb({.columns = columns, .rows = 6, .diagonal_angle = radians(last * share)});
    };
    return prove_path(make_linkage(sheet(1)), closed_form(sheet, 40, (degree - 1) / last));
  }
};

TEST_P(TubeProof, FreeBelowAndAtContactCrossingAbove) {
  EXPECT_EQ(proof(-0.02).verdict, PathVerdict::Free);
  EXPECT_EQ(proof(0).verdict, PathVerdict::Free);
  const PathProof beyond = proof(0.05);
  EXPECT_EQ(beyond.verdict, PathVerdict::Collides);
  EXPECT_GT(beyond.from, 1 / 1.05);  // not before the closing angle
}

INSTANTIATE_TEST_SUITE_P(TabulatedAngles, TubeProof,
                         testing::Values(Tube{10, 66.782022}, Tube{12, 49.277198}, Tube{16, 34.236430},
                                         Tube{22, 23.995596}),
                         [](const auto& about) { return fmt::format("columns_{}", about.param.columns); });

}  // namespace
}  // namespace plico
