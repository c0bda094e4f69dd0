#include "plico/workflow/stand.h"

#include <algorithm>
#include <cmath>

#include "plico/base/libm.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/upright.h"

namespace plico {
namespace {

// Columns: along the first side, across it, the front.
Eigen::Matrix3d frame(const Vec3& side, const Vec3& front) {
  Eigen::Matrix3d axes;
  axes.col(0) = side.normalized();
  axes.col(2) = front;
  axes.col(1) = front.cross(axes.col(0));
  return axes;
}

Stand stand_by(const Eigen::Matrix3d& turn) {
  const Vec3 twice(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
  const double angle = plico::atan2(twice.norm(), turn.trace() - 1);
  if (angle < 1e-12) return {};
  if (twice.norm() > 1e-6) return {twice.normalized(), angle};
  int k = 0;  // half a turn: the axis is a column of turn + 1
  for (int i = 1; i < 3; ++i)
    if (turn(i, i) > turn(k, k)) k = i;
  return {(turn.col(k) + Vec3::Unit(k)).normalized(), angle};
}

}  // namespace

Stand stand_of(const Unfolding& net, const Linkage& linkage, const Mesh& mesh, char up) {
  if (net.num_parts() != 1 || linkage.order.empty() || net.mesh_face.empty() || net.mesh_vertex.empty()) return {};
  const int root = linkage.order.front();
  const auto& corners = net.sheet.faces[root];  // a file may begin a face at another corner than the mesh does
  const Vec2 flat = net.sheet.vertices[corners[1]] - net.sheet.vertices[corners[0]];
  const Vec3 side =
      mesh.point(VertexId(net.mesh_vertex[corners[1]])) - mesh.point(VertexId(net.mesh_vertex[corners[0]]));
  const Eigen::Matrix3d as_mesh = frame(side, normal(mesh, FaceId(net.mesh_face[root]))) *
                                  frame(Vec3(flat.x(), flat.y(), 0), Vec3::UnitZ()).transpose();
  return stand_by(z_up_from(up) * as_mesh);
}

std::vector<Pose> standing(std::vector<Pose> poses, char up) {
  if (up != 'y') return poses;
  const Pose upright = rotation_about(Vec3::Zero(), Vec3::UnitX(), kPi / 2);
  for (Pose& pose : poses) pose = upright * pose;
  return poses;
}

}  // namespace plico
