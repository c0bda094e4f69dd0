#include "plico/verify/panel_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "linkage_samples.h"

namespace plico {
namespace {

// Poses at evenly spaced moments of an interval.
std::vector<std::vector<Pose>> watch(const LinkageMotion& motion, int num_panels, double start, double end) {
  std::vector<std::vector<Pose>> moments(17, std::vector<Pose>(num_panels));
  for (std::size_t i = 0; i < moments.size(); ++i)
    motion.place(start + static_cast<double>(i) / 16.0 * (end - start), {}, moments[i]);
  return moments;
}

// The largest distance of a panel's corners, seen from a frame, from their chords.
double strays(const Linkage& linkage, const std::vector<std::vector<Pose>>& moments, int panel, int frame) {
  const auto seen = [&](const std::vector<Pose>& poses) {
    return frame < 0 ? poses[panel] : Pose(poses[frame].inverse() * poses[panel]);
  };
  const Pose first = seen(moments.front()), last = seen(moments.back());
  double most = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double share = static_cast<double>(i) / 16.0;
    const Pose now = seen(moments[i]);
    for (const Vec3& x : linkage.panels[panel])
      most = std::max(most, (now * x - (1 - share) * (first * x) - share * (last * x)).norm());
  }
  return most;
}

// Long enough that panels are seen past several anchors, with a waypoint inside some intervals.
TEST(LinkageMotion, PointsOfALongStripStayWithinBendOfTheirChords) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-0.6, 0.6);
  std::vector<double> goal(70), detour(70);
  for (double& a : goal) a = angle(random);
  for (double& a : detour) a = angle(random);
  const Linkage linkage = make_linkage(square_strip(goal));
  const FoldingPath path = path_through({{0, std::vector<double>(70, 0.0)}, {0.4, detour}, {1, goal}});
  LinkageMotion motion(linkage, path);
  std::vector<Pose> at_start(linkage.panels.size());
  double tightest = 0;
  for (const auto& [start, end] : std::vector<std::pair<double, double>>{{0.38, 0.42}, {0.1, 0.11}, {0.6, 0.605}}) {
    motion.place(start, {}, at_start);
    motion.look_at(start, end, at_start);
    const auto moments = watch(motion, linkage.num_panels(), start, end);
    for (int panel = 0; panel < linkage.num_panels(); panel += 3) {
      for (int frame = linkage.parent_panel[panel]; frame >= 0; frame = linkage.parent_panel[frame])
        EXPECT_LE(strays(linkage, moments, panel, frame), motion.bend(panel, frame) + 1e-12)
            << panel << " from " << frame;
      const double seen = strays(linkage, moments, panel, -1);
      EXPECT_LE(seen, motion.bend(panel, -1) + 1e-12) << panel;
      if (motion.bend(panel, -1) > 1e-9) tightest = std::max(tightest, seen / motion.bend(panel, -1));
    }
  }
  EXPECT_GT(tightest, 0.2);  // a bound that is never near would make proofs slow
}

}  // namespace
}  // namespace plico
