#include "plico/workflow/kit_joints.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

// From a face in space to the panel that it became: the plane through three corners far apart.
class FaceToPanel {
 public:
  FaceToPanel(const Mesh& mesh, const Unfolding& net, int panel) {
    const FaceId face(net.mesh_face[panel]);
    const std::span<const int> corners = mesh.corners(face);
    const std::vector<int>& flat = net.sheet.faces[panel];
    std::size_t far = 1;
    origin_ = mesh.point(VertexId(corners[0]));
    for (std::size_t i = 1; i < corners.size(); ++i)
      if ((at(mesh, corners[i]) - origin_).norm() > (at(mesh, corners[far]) - origin_).norm()) far = i;
    x_ = (at(mesh, corners[far]) - origin_).normalized();
    y_ = normal(mesh, face).cross(x_);
    flat_origin_ = net.sheet.vertices[flat[0]];
    flat_x_ = (net.sheet.vertices[flat[far]] - flat_origin_).normalized();
  }

  Vec2 operator()(const Vec3& p) const {
    return flat_origin_ + x_.dot(p - origin_) * flat_x_ + y_.dot(p - origin_) * perpendicular(flat_x_);
  }

 private:
  static Vec3 at(const Mesh& mesh, int vertex) { return mesh.point(VertexId(vertex)); }

  Vec3 origin_, x_, y_;
  Vec2 flat_origin_, flat_x_;
};

double area_of(const std::vector<Vec3>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]) / 2;
  return sum.norm();
}

}  // namespace

std::vector<JointFacet> joint_facets(const Mesh& mesh, const Unfolding& net, const std::vector<Joint>& joints,
                                     const std::vector<std::vector<int>>& pieces,
                                     const std::vector<PartTitle>& titles) {
  std::vector<int> panel_of_face(mesh.num_faces(), -1);
  for (std::size_t p = 0; p < net.mesh_face.size(); ++p) panel_of_face[net.mesh_face[p]] = static_cast<int>(p);
  std::vector<JointFacet> facets;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    const auto side = [&](int face, int other, bool turned) {
      JointFacet facet{panel_of_face[face], {}, 0, {}};
      const FaceToPanel flat(mesh, net, facet.panel);
      for (const Vec3& p : joint.polygon) facet.polygon.push_back(flat(p));
      if (turned) {  // seen from outside it runs the other way; the first corner becomes the last
        std::reverse(facet.polygon.begin(), facet.polygon.end());
        facet.up = static_cast<int>(facet.polygon.size()) - 1;
      }
      facet.text = fmt::format("to {}: {}", titles[pieces[other].front()].id, j + 1);
      facets.push_back(std::move(facet));
    };
    side(joint.first_face, joint.second, false);
    side(joint.second_face, joint.first, true);
  }
  return facets;
}

nlohmann::json joints_json(const Kit& kit) {
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t j = 0; j < kit.joints.size(); ++j) {
    const Joint& joint = kit.joints[j];
    nlohmann::json polygon = nlohmann::json::array();
    for (const Vec3& p : joint.polygon) polygon.push_back({p.x(), p.y(), p.z()});
    list.push_back({{"number", j + 1},
                    {"parts", {kit.parts.names[joint.first], kit.parts.names[joint.second]}},
                    {"faces", {joint.first_face, joint.second_face}},
                    {"area", area_of(joint.polygon)},
                    {"polygon", std::move(polygon)}});
  }
  return list;
}

}  // namespace plico
