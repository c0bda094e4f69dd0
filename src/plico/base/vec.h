// Vectors and rigid motions: Eigen's, under the names the library uses.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace plico {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Pose = Eigen::Isometry3d;  // a rigid motion of space

constexpr double kPi = 3.14159265358979323846;
constexpr double kMaxCoordinate = 1e30;  // of files: products of six must stay finite

constexpr double radians(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees(double radians) { return radians * (180 / kPi); }

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
inline Vec2 perpendicular(const Vec2& a) { return {-a.y(), a.x()}; }  // turned left by 90 degrees

// Turns by `angle` radians, right-handed, about a unit vector. In Eigen's own the last bit depends on the processor
// (base/libm.h).
Eigen::Matrix3d rotation(const Vec3& axis, double angle);
Eigen::Matrix2d rotation(double angle);  // of the plane, counterclockwise
Eigen::Quaterniond quaternion(const Vec3& axis, double angle);
// The rotation `share` of the way from `a` to `b` along the shorter arc, at constant speed.
Eigen::Quaterniond slerp(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b, double share);

// The rigid motion that turns by `angle` radians, right-handed, about the line through `from` along a unit vector.
Pose rotation_about(const Vec3& from, const Vec3& axis, double angle);

}  // namespace plico
