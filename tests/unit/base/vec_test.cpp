#include "plico/base/vec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plico/base/libm.h"

namespace plico {
namespace {

const Vec3 kAxis = Vec3(1, -2, 3).normalized();
constexpr double kRounding = 1e-15;

TEST(Vec, RotationAndQuaternionTurnAsEigensAngleAxisDoes) {
  for (double angle : {0.0, 1e-9, 0.3, -1.2, 2.0, kPi, -5.0}) {
    const Eigen::AngleAxisd turn(angle, kAxis);
    EXPECT_LT((rotation(kAxis, angle) - turn.toRotationMatrix()).norm(), kRounding);
    EXPECT_LT((quaternion(kAxis, angle).coeffs() - Eigen::Quaterniond(turn).coeffs()).norm(), kRounding);
    EXPECT_LT((rotation(angle) - Eigen::Rotation2Dd(angle).toRotationMatrix()).norm(), kRounding);
  }
}

TEST(Vec, ATurnAboutALineKeepsItsPoints) {
  const Vec3 from(4, 5, 6);
  const Pose pose = rotation_about(from, kAxis, 0.7);
  EXPECT_LT((pose * from - from).norm(), 1e-14);
  EXPECT_LT((pose * Vec3(from + 2 * kAxis) - (from + 2 * kAxis)).norm(), 1e-14);
}

TEST(Vec, SlerpGoesTheShorterArcAtConstantSpeed) {
  const Eigen::Quaterniond a = quaternion(kAxis, 0.2), b = quaternion(kAxis, 1.4);
  EXPECT_LT((slerp(a, b, 0.25).coeffs() - quaternion(kAxis, 0.5).coeffs()).norm(), kRounding);
  const Eigen::Quaterniond other_sign(Eigen::Vector4d(-b.coeffs()));
  EXPECT_LT((slerp(a, other_sign, 0.25).coeffs() - quaternion(kAxis, 0.5).coeffs()).norm(), kRounding);
  EXPECT_LT((slerp(a, a, 0.3).coeffs() - a.coeffs()).norm(), kRounding);
}

// Both round to within a unit in the last place, so they are at most two apart.
void expect_near(double ours, double theirs) {
  EXPECT_LE(std::abs(ours - theirs), 4.5e-16 * std::abs(theirs)) << ours << " and " << theirs;
}

TEST(Libm, IsTheStandardLibrarysButForTheLastBits) {
  for (int i = 1; i < 2000; ++i) {
    const double x = 0.01 * i, inside = i / 2000.0;
    expect_near(plico::sin(x), std::sin(x));
    expect_near(plico::cos(-x), std::cos(-x));
    expect_near(plico::tan(x), std::tan(x));
    expect_near(plico::asin(inside), std::asin(inside));
    expect_near(plico::acos(-inside), std::acos(-inside));
    expect_near(plico::atan2(inside, -x), std::atan2(inside, -x));
    expect_near(plico::hypot(x, inside), std::hypot(x, inside));
    expect_near(plico::log(x), std::log(x));
    expect_near(plico::pow(x, inside), std::pow(x, inside));
  }
  EXPECT_TRUE(std::isnan(plico::acos(2)));
  expect_near(plico::hypot(3e200, 4e200), 5e200);
}

}  // namespace
}  // namespace plico
