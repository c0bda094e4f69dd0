#include "plico/verify/joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

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

// Every corner turns left, seen against `normal`, or is straight.
bool is_convex(const std::vector<Vec3>& polygon, const Vec3& normal, double slack) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 side = polygon[(i + 1) % n] - polygon[i];
    for (const Vec3& p : polygon)
      if (normal.cross(side).dot(p - polygon[i]) < -slack * side.norm()) return false;
  }
  return true;
}

// Does a side of the face run through the inside of a convex polygon, deeper than `slack`? Where all corners of the
// polygon are in the face, that is how it can still reach beyond it.
bool side_runs_through(const Vec3& from, const Vec3& to, const std::vector<Vec3>& polygon, const Vec3& normal,
                       double slack) {
  double begin = 0, end = 1;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n && begin < end; ++i) {
    const Vec3 side = polygon[(i + 1) % n] - polygon[i];
    if (side.norm() <= slack) continue;
    const Vec3 inward = normal.cross(side).normalized();
    const double at_from = inward.dot(from - polygon[i]) - slack, at_to = inward.dot(to - polygon[i]) - slack;
    if (at_from <= 0 && at_to <= 0) return false;
    if (at_from < 0) begin = std::max(begin, at_from / (at_from - at_to));
    if (at_to < 0) end = std::min(end, at_from / (at_from - at_to));
  }
  return (end - begin) * (to - from).norm() > slack;
}

bool lies_in(const Mesh& mesh, FaceId face, const std::vector<Vec3>& polygon, const Vec3& normal, double slack) {
  for (const Vec3& p : polygon)
    if (!in_face(mesh, face, p, slack)) return false;
  for (HalfedgeId h : mesh.halfedges(face))
    if (side_runs_through(mesh.point(mesh.from(h)), mesh.point(mesh.to(h)), polygon, normal, slack)) return false;
  return true;
}

// `number` counts joints from 1.
void judge_joint(const Mesh& mesh, const JointClaim& joint, std::size_t number, double slack,
                 std::vector<Defect>& defects) {
  constexpr double kTurned = 1e-3;  // of the angle between a polygon and its faces
  const auto defect = [&](const char* code, std::string message) { defects.push_back({code, std::move(message)}); };
  for (int face : {joint.first_face, joint.second_face})
    if (face < 0 || face >= mesh.num_faces())
      return defect("joint/face",
                    fmt::format("joint {} is of face {}, the mesh has {}", number, face, mesh.num_faces()));
  const Vec3 area = area_vector(joint.polygon);
  if (!(area.norm() > slack * slack))
    return defect("joint/empty", fmt::format("the facets of joint {} touch in no area", number));
  const FaceId first(joint.first_face), second(joint.second_face);
  const Vec3 up = area.normalized();
  if (up.dot(normal(mesh, first)) < 1 - kTurned || up.dot(normal(mesh, second)) > kTurned - 1)
    defect("joint/turned", fmt::format("the facets of joint {} do not face each other", number));
  if (!is_convex(joint.polygon, up, slack))
    defect("joint/convex", fmt::format("the outline of joint {} is not convex", number));
  for (FaceId face : {first, second})
    if (!lies_in(mesh, face, joint.polygon, up, slack))
      defect("joint/outside", fmt::format("joint {} reaches beyond face {}", number, int(face)));
}

}  // namespace

std::vector<Defect> verify_joints(const Mesh& mesh, const std::vector<JointClaim>& joints, double tolerance) {
  std::vector<Defect> defects;
  const double slack = tolerance * diagonal(mesh);
  std::map<std::pair<int, int>, std::size_t> number_of;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    judge_joint(mesh, joints[i], i + 1, slack, defects);
    const auto [at, is_new] = number_of.insert({std::minmax(joints[i].first_face, joints[i].second_face), i + 1});
    if (!is_new)
      defects.push_back({"joint/twice", fmt::format("joints {} and {} glue the same faces", at->second, i + 1)});
  }
  return defects;
}

}  // namespace plico
