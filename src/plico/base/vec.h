// Vectors and rigid motions: Eigen's, under the names the library uses.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace plico {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Pose = Eigen::Isometry3d;  // a rigid motion of space

constexpr double kPi = 3.14159265358979323846;

constexpr double radians(double degrees) { return degrees * (kPi / 180); }
constexpr double degrees(double radians) { return radians * (180 / kPi); }

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
inline Vec2 perpendicular(const Vec2& a) { return {-a.y(), a.x()}; }  // turned left by 90 degrees

// The rigid motion that turns by `angle` radians, right-handed, about the line through `from` and `to`.
Pose rotation_about(const Vec3& from, const Vec3& to, double angle);

}  // namespace plico
