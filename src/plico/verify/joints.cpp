#include "plico/verify/joints.h"

#include <fmt/format.h>

#include <algorithm>

#include "plico/mesh/measures.h"

namespace plico {
namespace {

Vec3 area_vector(const std::vector<Vec3>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]) / 2;
  return sum;
}

double distance_to_side(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 side = b - a;
  const double t = side.squaredNorm() > 0 ? std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - a - t * side).norm();
}

// A point of the plane lies in the face when the sides turn around it once, or it lies on a side.
bool in_face(const Mesh& mesh, FaceId face, const Vec3& p, double tolerance) {
  const Vec3 n = normal(mesh, face);
  if (std::abs(n.dot(p - center(mesh, face))) > tolerance) return false;
  bool inside = false;
  const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
  for (HalfedgeId h : mesh.halfedges(face)) {
    const Vec3 &from = mesh.point(mesh.from(h)), &to = mesh.point(mesh.to(h));
    if (distance_to_side(p, from, to) <= tolerance) return true;
    const Vec2 a(x.dot(from - p), y.dot(from - p)), b(x.dot(to - p), y.dot(to - p));
    if ((a.y() > 0) != (b.y() > 0) && a.x() + (b.x() - a.x()) * a.y() / (a.y() - b.y()) > 0) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<Defect> verify_joints(const Mesh& mesh, const std::vector<JointClaim>& joints, double tolerance) {
  constexpr double kTurned = 1e-3;  // of the angle between a polygon and its faces
  std::vector<Defect> defects;
  const double slack = tolerance * diagonal(mesh);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointClaim& joint = joints[i];
    const FaceId first(joint.first_face), second(joint.second_face);
    const Vec3 area = area_vector(joint.polygon);
    if (area.norm() <= slack * slack) {
      defects.push_back({"joint/empty", fmt::format("the facets of joint {} touch in no area", i + 1)});
      continue;
    }
    if (area.normalized().dot(normal(mesh, first)) < 1 - kTurned ||
        area.normalized().dot(normal(mesh, second)) > kTurned - 1)
      defects.push_back({"joint/turned", fmt::format("the facets of joint {} do not face each other", i + 1)});
    for (FaceId face : {first, second})
      if (!std::all_of(joint.polygon.begin(), joint.polygon.end(),
                       [&](const Vec3& p) { return in_face(mesh, face, p, slack); }))
        defects.push_back({"joint/outside", fmt::format("joint {} reaches beyond face {}", i + 1, int(face))});
  }
  return defects;
}

}  // namespace plico
