#include "plico/verify/joints.h"

#include <gtest/gtest.h>

#include "plico/mesh/measures.h"

namespace plico {
namespace {

// Two squares of side 2 back to back, the second one moved by 1 along x: they share a rectangle.
const std::vector<Vec3> kShared{{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}};

Mesh two_squares() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {3, 0, 0}, {3, 2, 0}, {1, 2, 0}};
  soup.add_face({0, 1, 2, 3});
  soup.add_face({7, 6, 5, 4});
  return Mesh(std::move(soup));
}

std::string first_code(const std::vector<Defect>& defects) { return defects.empty() ? "" : defects.front().code; }

TEST(VerifyJoints, AcceptsWhatBothFacesHold) {
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{0, 1, kShared}})), "");
}

TEST(VerifyJoints, FindsAPolygonThatReachesBeyondAFace) {
  std::vector<Vec3> beyond = kShared;
  for (Vec3& p : beyond) p.x() += 0.01;
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{0, 1, beyond}})), "joint/outside");
}

TEST(VerifyJoints, FindsAPolygonAboveItsFaces) {
  std::vector<Vec3> above = kShared;
  for (Vec3& p : above) p.z() += 0.01;
  EXPECT_EQ(verify_joints(two_squares(), {{0, 1, above}}).size(), 2u);
}

TEST(VerifyJoints, FindsFacetsThatDoNotFaceEachOther) {
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{1, 0, kShared}})), "joint/turned");
}

TEST(VerifyJoints, FindsAJointWithoutArea) {
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{0, 1, {{1, 0, 0}, {2, 0, 0}}}})), "joint/empty");
}

TEST(VerifyJoints, FindsAnOutlineWithADent) {
  std::vector<Vec3> dented = kShared;
  dented.insert(dented.begin() + 1, Vec3(1.5, 0.5, 0));
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{0, 1, dented}})), "joint/convex");
}

// The corners of a polygon across the notch of a U lie in the U, but not the polygon.
TEST(VerifyJoints, FindsAPolygonAcrossANotch) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0},
                 {1, 3, 0}, {0, 3, 0}, {0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
  soup.add_face({0, 1, 2, 3, 4, 5, 6, 7});
  soup.add_face({11, 10, 9, 8});
  const Mesh mesh(std::move(soup));
  EXPECT_EQ(first_code(verify_joints(mesh, {{0, 1, {{0.5, 2, 0}, {2.5, 2, 0}, {2.5, 2.5, 0}, {0.5, 2.5, 0}}}})),
            "joint/outside");
  EXPECT_EQ(first_code(verify_joints(mesh, {{0, 1, {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}}})), "");
}

TEST(VerifyJoints, FindsFacesThatThereAreNotAndFacesGluedTwice) {
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{0, 2, kShared}})), "joint/face");
  EXPECT_EQ(first_code(verify_joints(two_squares(), {{0, 1, kShared}, {0, 1, kShared}})), "joint/twice");
}

}  // namespace
}  // namespace plico
