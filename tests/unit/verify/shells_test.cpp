#include "plico/verify/shells.h"

#include <gtest/gtest.h>

namespace plico {
namespace {

std::vector<Vec3> block(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return points;
}

PolygonSoup surface_of(const std::vector<Vec3>& points) {
  const ConvexPolyhedron hull = convex_hull(points);
  PolygonSoup soup;
  soup.points = hull.points;
  for (const auto& facet : hull.facets) soup.add_face(facet.corners);
  return soup;
}

// Two blocks that overlap in [1, 2], cut at x = 1.5 with a hair between them.
ShellsClaim two_blocks() {
  const std::vector<Vec3> left = block({0, 0, 0}, {2, 1, 1}), right = block({1, 0, 0}, {3, 1, 1});
  const double hair = 1e-12;
  ShellsClaim claim;
  claim.parts = {left, right};
  claim.shells = {{surface_of(block({0, 0, 0}, {1.5 - hair, 1, 1})), left},
                  {surface_of(block({1.5 + hair, 0, 0}, {3, 1, 1})), right}};
  claim.contacts = {{0, 1, {Vec3::UnitX(), 1.5}, {{1.5, 0, 0}, {1.5, 1, 0}, {1.5, 1, 1}, {1.5, 0, 1}}}};
  return claim;
}

std::string first_defect(const ShellsClaim& claim) {
  const ShellsVerdict verdict = verify_shells(claim, {.samples = 5000});
  return verdict.defects.empty() ? "none" : verdict.defects.front().code;
}

TEST(VerifyShells, LetsGoodOnesPass) {
  const ShellsVerdict verdict = verify_shells(two_blocks());
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.pairs, 1);
  EXPECT_NEAR(verdict.loss, 0, verdict.loss_error);
  EXPECT_LT(verdict.loss_error, 1e-3);
}

TEST(VerifyShells, SeesADentHoweverSmall) {
  ShellsClaim claim = two_blocks();
  PolygonSoup& soup = claim.shells[0].surface;
  // One corner of four in a plane, moved by one part in 10^15: the diagonal is a ridge or a dent.
  int dents = 0;
  for (Vec3& p : soup.points) {
    const Vec3 before = p;
    p.x() += p.x() < 1 ? 1e-15 : 0;
    dents += first_defect(claim) == "shells/reflex";
    p = before;
  }
  EXPECT_GT(dents, 0);
}

TEST(VerifyShells, SeesAHole) {
  ShellsClaim claim = two_blocks();
  claim.shells[0].surface.offsets.pop_back();
  claim.shells[0].surface.corners.resize(claim.shells[0].surface.corners.size() - 3);
  EXPECT_EQ(first_defect(claim), "shells/not-closed");
}

TEST(VerifyShells, SeesATouchOfThePlane) {
  ShellsClaim claim = two_blocks();
  claim.contacts[0].plane.offset = 1.5 + 1e-12;  // the right shell touches it
  EXPECT_EQ(first_defect(claim), "shells/overlap");
}

TEST(VerifyShells, SeesAShellBeyondItsHull) {
  ShellsClaim claim = two_blocks();
  claim.shells[0].in_hull_of = block({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(first_defect(claim), "shells/outside");
}

TEST(VerifyShells, SeesAContactOffTheSurface) {
  ShellsClaim claim = two_blocks();
  claim.contacts[0].polygon[2].y() = 1.1;
  EXPECT_EQ(first_defect(claim), "shells/not-touching");
}

TEST(VerifyShells, SeesAWrongLoss) {
  ShellsClaim claim = two_blocks();
  claim.loss = 0.02;
  EXPECT_EQ(first_defect(claim), "shells/loss");
  claim = two_blocks();
  claim.shells[1].surface = surface_of(block({2, 0, 0}, {3, 1, 1}));
  claim.contacts[0].polygon.clear();
  EXPECT_EQ(first_defect(claim), "shells/loss");
  claim.loss = 1.0 / 6;
  EXPECT_EQ(first_defect(claim), "none");
}

TEST(VerifyShells, SeesAContactOfNobody) {
  ShellsClaim claim = two_blocks();
  claim.contacts.push_back({0, 7, {}, {}});
  EXPECT_EQ(first_defect(claim), "shells/contact");
}

}  // namespace
}  // namespace plico
