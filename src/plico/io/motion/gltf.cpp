#include "plico/io/motion/gltf.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/io/motion/panel_joints.h"
#include "plico/io/motion/panel_solid.h"

namespace plico {
namespace {

using Json = nlohmann::ordered_json;

// glTF's own numbers for element types and buffer uses.
enum { kUnsignedInt = 5125, kFloat = 5126, kVertexBuffer = 34962, kIndexBuffer = 34963 };
enum Material { kFront, kBack, kWall };
constexpr double kLongestStep = 2 * kPi / 3;

template <class T>
void append(std::string& bytes, T value) {
  static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

// One of the three parts of the binary chunk.
struct BufferView {
  int index;
  std::string bytes;
};

class GlbWriter {
 public:
  GlbWriter(const Linkage& linkage, const FoldingPath& path, const GltfOptions& options)
      : linkage_(linkage), path_(path), options_(options), joints_(panel_joints(linkage)) {}

  std::string write() {
    add_header();
    for (int p = 0; p < linkage_.num_panels(); ++p) add_panel(p);
    add_stage();
    add_animation();
    return container();
  }

 private:
  void add_header() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "plico"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"name", "folding"}, {"nodes", {linkage_.num_panels()}}}};
    json_["nodes"] = json_["meshes"] = json_["materials"] = json_["accessors"] = Json::array();
    add_material("front", {0.87, 0.48, 0.078, 1});
    add_material("back", {0.92, 0.88, 0.79, 1});
    if (linkage_.thickness > 0) add_material("wall", {0.55, 0.42, 0.25, 1});
  }
  void add_material(const char* name, const std::array<double, 4>& colour) {
    json_["materials"].push_back(
        {{"name", name},
         {"pbrMetallicRoughness", {{"baseColorFactor", colour}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}}});
  }

  int add_accessor(const BufferView& view, std::size_t offset, int type, const char* shape, std::size_t count) {
    Json accessor = {{"bufferView", view.index}};
    if (offset) accessor["byteOffset"] = offset;
    accessor["componentType"] = type;
    accessor["count"] = count;
    accessor["type"] = shape;
    json_["accessors"].push_back(std::move(accessor));
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int add_points(const std::vector<Vec3>& points, const Vec3& origin) {
    const int id = add_accessor(positions_, positions_.bytes.size(), kFloat, "VEC3", points.size());
    Eigen::Vector3f low, high;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3f p = (points[i] - origin).cast<float>();
      low = i ? Eigen::Vector3f(low.cwiseMin(p)) : p;
      high = i ? Eigen::Vector3f(high.cwiseMax(p)) : p;
      for (float x : p) append(positions_.bytes, x);
    }
    json_["accessors"][id]["min"] = {low.x(), low.y(), low.z()};
    json_["accessors"][id]["max"] = {high.x(), high.y(), high.z()};
    return id;
  }
  Json primitive(int points, const std::vector<std::array<int, 3>>& triangles, Material material) {
    const int id = add_accessor(indices_, indices_.bytes.size(), kUnsignedInt, "SCALAR", 3 * triangles.size());
    for (const auto& triangle : triangles)
      for (int corner : triangle) append(indices_.bytes, static_cast<std::uint32_t>(corner));
    return {{"attributes", {{"POSITION", points}}}, {"indices", id}, {"material", static_cast<int>(material)}};
  }

  // Front and back are separate one-sided surfaces in one place: each side shows its own colour.
  void add_panel(int p) {
    const PanelSolid solid = panel_solid(linkage_, p);
    const PanelJoint& joint = joints_[p];
    const int points = add_points(solid.points, joint.origin);
    Json primitives = {primitive(points, solid.front, kFront), primitive(points, solid.back, kBack)};
    if (!solid.walls.empty()) primitives.push_back(primitive(points, solid.walls, kWall));
    const std::string name = fmt::format("panel {}", p);
    json_["meshes"].push_back({{"name", name}, {"primitives", primitives}});
    Json node = {{"name", name}, {"mesh", p}};
    if (joint.parent >= 0) {
      node["translation"] = {joint.offset.x(), joint.offset.y(), joint.offset.z()};
      node["rotation"] = quaternion(joint.axis, path_.waypoints.front().config[joint.hinge]);
    }
    if (!joint.children.empty()) node["children"] = joint.children;
    json_["nodes"].push_back(std::move(node));
  }

  // The sheet lies in x and y; glTF's up is y.
  void add_stage() {
    std::vector<int> roots;
    for (int p : linkage_.order)
      if (joints_[p].parent < 0) roots.push_back(p);
    const double s = options_.metres_per_unit;
    json_["nodes"].push_back({{"name", "sheet"},
                              {"rotation", quaternion(Vec3::UnitX(), -kPi / 2)},
                              {"scale", {s, s, s}},
                              {"children", roots}});
  }

  static std::array<float, 4> quaternion(const Vec3& axis, double angle) {
    const Vec3 v = plico::sin(angle / 2) * axis;
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
            static_cast<float>(plico::cos(angle / 2))};
  }

  void add_animation() {
    Json channels = Json::array(), samplers = Json::array();
    for (int p = 0; p < linkage_.num_panels(); ++p) {
      if (joints_[p].parent < 0) continue;
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", p}, {"path", "rotation"}}}});
      samplers.push_back(sampler(joints_[p]));
    }
    if (!channels.empty()) json_["animations"] = {{{"name", "fold"}, {"channels", channels}, {"samplers", samplers}}};
  }

  Json sampler(const PanelJoint& joint) {
    const std::vector<AngleKey> keys = short_steps(angle_keys(path_, joint.hinge));
    std::vector<float> times;
    for (const AngleKey& key : keys) times.push_back(static_cast<float>(key.time * options_.seconds));
    const int input = time_accessor(times);
    const int output = add_accessor(animation_, animation_.bytes.size(), kFloat, "VEC4", keys.size());
    for (const AngleKey& key : keys)
      for (float x : quaternion(joint.axis, key.angle)) append(animation_.bytes, x);
    return {{"input", input}, {"interpolation", "LINEAR"}, {"output", output}};
  }
  static std::vector<AngleKey> short_steps(const std::vector<AngleKey>& keys) {
    std::vector<AngleKey> result{keys.front()};
    for (std::size_t i = 1; i < keys.size(); ++i) {
      const AngleKey a = keys[i - 1], b = keys[i];
      const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(b.angle - a.angle) / kLongestStep)));
      for (int k = 1; k < pieces; ++k) {
        const double s = static_cast<double>(k) / pieces;
        result.push_back({(1 - s) * a.time + s * b.time, (1 - s) * a.angle + s * b.angle});
      }
      result.push_back(b);
    }
    return result;
  }
  // Hinges that move at the same times share their times.
  int time_accessor(const std::vector<float>& times) {
    const auto [at, is_new] = times_.try_emplace(times, -1);
    if (!is_new) return at->second;
    at->second = add_accessor(animation_, animation_.bytes.size(), kFloat, "SCALAR", times.size());
    json_["accessors"][at->second]["min"] = {times.front()};
    json_["accessors"][at->second]["max"] = {times.back()};
    for (float t : times) append(animation_.bytes, t);
    return at->second;
  }

  std::string container() {
    std::string binary;
    json_["bufferViews"] = Json::array();
    for (const auto& [view, target] :
         {std::pair(&positions_, int{kVertexBuffer}), {&indices_, int{kIndexBuffer}}, {&animation_, 0}}) {
      if (view->bytes.empty()) continue;
      Json entry = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", view->bytes.size()}};
      if (target == kVertexBuffer) entry["byteStride"] = 3 * sizeof(float);
      if (target) entry["target"] = target;
      json_["bufferViews"].push_back(std::move(entry));
      binary += view->bytes;
    }
    json_["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = json_.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
    append(glb, static_cast<std::uint32_t>(text.size()));
    glb += "JSON" + text;
    append(glb, static_cast<std::uint32_t>(binary.size()));
    return glb + std::string("BIN\0", 4) + binary;
  }

  const Linkage& linkage_;
  const FoldingPath& path_;
  const GltfOptions& options_;
  const std::vector<PanelJoint> joints_;
  Json json_;
  BufferView positions_{0, {}}, indices_{1, {}}, animation_{2, {}};
  std::map<std::vector<float>, int> times_;
};

}  // namespace

std::string write_glb(const Linkage& linkage, const FoldingPath& path, const GltfOptions& options) {
  if (linkage.num_panels() == 0) throw InvalidInput("linkage/empty", "a linkage without panels cannot be animated");
  if (!(options.seconds > 0)) throw InvalidOption(fmt::format("seconds = {} must be above 0", options.seconds));
  if (!(options.metres_per_unit > 0))
    throw InvalidOption(fmt::format("metres_per_unit = {} must be above 0", options.metres_per_unit));
  require_within_limits(linkage, path);
  return GlbWriter(linkage, path, options).write();
}

}  // namespace plico
