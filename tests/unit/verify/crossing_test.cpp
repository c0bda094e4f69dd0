// Plates that stay parallel while one passes through the other never penetrate each other at any one moment.
#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

// The panels of a strip, all lying over the first one; the last one sinks from above it to below it, reaching its
// plane at the time `crossing`.
class Sinking : public PanelMotion {
 public:
  Sinking(int panels, double crossing) : last_(panels - 1), crossing_(crossing) {}

  void place(double time, const std::vector<char>&, std::vector<Pose>& poses) const override {
    for (int p = 0; p <= last_; ++p) {
      poses[p] = Pose::Identity();
      const double height = p == last_ ? crossing_ - time : p == 0 ? 0.0 : 10.0 * p;
      poses[p].translation() = Vec3(-p, 0, height);
    }
  }
  void look_at(double, double, const std::vector<Pose>&) override {}
  double bend(int, int) const override { return 0; }
  int frame_of(int, int) const override { return -1; }
  void want(int, std::vector<char>&) const override {}
  double rounding() const override { return 1e-14; }

 private:
  int last_;
  double crossing_;
};

TEST(CrossingProof, ParallelPlatesMayNotPassThroughEachOther) {
  const Linkage linkage = make_linkage(square_strip({1, 1}));
  for (int i = 1; i < 100; ++i) {
    const double crossing = 0.01 * i + 1e-3 / 3;
    Sinking motion(linkage.num_panels(), crossing);
    EXPECT_NE(prove_motion(linkage, motion).verdict, PathVerdict::Free) << crossing;
  }
}

}  // namespace
}  // namespace plico
