#include "plico/io/pattern/fold_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"

namespace plico::fold_json {
namespace {

constexpr double kFlatSheet = 1e-5;  // of the extent

// Of the points, the one for which `distance` is largest.
template <class Distance>
const Vec3& farthest(const std::vector<Vec3>& points, Distance distance) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
}

// Through three points that are far apart, so that rounding turns it little.
SheetPlane plane_through(const std::vector<Vec3>& points) {
  SheetPlane plane;
  plane.axis = -1;
  plane.on = points[0];
  const Vec3 along = farthest(points, [&](const Vec3& p) { return (p - plane.on).norm(); }) - plane.on;
  const Vec3 side = farthest(points, [&](const Vec3& p) { return along.cross(p - plane.on).norm(); }) - plane.on;
  Vec3 normal = along.cross(side).normalized();
  int axis = 2;
  for (const int other : {1, 0})
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  if (normal[axis] < 0) normal = -normal;
  const Vec3 right = axis == 0 ? Vec3::UnitY() : Vec3::UnitX();
  plane.right = (right - right.dot(normal) * normal).normalized();
  plane.up = normal.cross(plane.right);
  return plane;
}

}  // namespace

void fail(const std::string& code, const std::string& message, const std::string& where,
          const std::string& suggestion) {
  throw InvalidInput("fold/" + code, message, where, suggestion);
}

const Json* member(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

const Json* Frame::find(const char* key) const {
  for (const Json* frame : chain_)
    if (const Json* value = member(*frame, key)) return value;
  return nullptr;
}

const Json* Frame::array(const char* key, int size) const {
  const Json* value = find(key);
  if (!value) return nullptr;
  if (!value->is_array()) fail("type", fmt::format("{} is not an array", key), at(key));
  if (value->size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4)
    fail("size", fmt::format("{} has too many entries", key), at(key));
  if (size >= 0 && static_cast<int>(value->size()) != size)
    fail("length", fmt::format("{} has {} entries, {} are needed", key, value->size(), size), at(key));
  return value;
}

std::string Frame::entry(const char* key, std::size_t i) const { return fmt::format("{}{}[{}]", where_, key, i); }

Json Frame::flattened() const {
  Json all = Json::object();
  for (const Json* frame : chain_)
    for (const auto& [key, value] : frame->items())
      if (!key.starts_with("file_") && key != "frame_parent" && key != "frame_inherit" && !all.contains(key))
        all[key] = value;
  return all;
}

std::vector<Frame> frames(const Json& root) {
  constexpr std::size_t kLongestChain = 64;
  std::vector<const Json*> all{&root};
  if (const Json* more = member(root, "file_frames")) {
    if (!more->is_array()) fail("type", "file_frames is not an array", "file_frames");
    for (const Json& frame : *more) {
      if (!frame.is_object()) fail("type", "a frame is not an object", fmt::format("file_frames[{}]", all.size() - 1));
      all.push_back(&frame);
    }
  }
  std::vector<Frame> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string where = i == 0 ? "" : fmt::format("file_frames[{}].", i - 1);
    std::vector<const Json*> chain{all[i]};
    for (std::size_t at = i; at != 0;) {
      const Json *inherit = member(*all[at], "frame_inherit"), *parent = member(*all[at], "frame_parent");
      if (!inherit || !inherit->is_boolean() || !inherit->get<bool>()) break;
      if (parent && !(parent->is_number_unsigned() && parent->get<std::uint64_t>() < all.size()))
        fail("parent", fmt::format("frame_parent is {}, must be in [0, {}]", parent->dump(), all.size() - 1),
             where + "frame_parent");
      at = parent ? parent->get<std::size_t>() : 0;
      chain.push_back(all[at]);
      if (chain.size() > kLongestChain)
        fail("parent", fmt::format("a frame inherits from more than {} others, or from itself", kLongestChain),
             where + "frame_parent");
    }
    result.emplace_back(where, std::move(chain));
  }
  return result;
}

double number(const Json& value, const Frame& frame, const char* key, std::size_t i) {
  if (!value.is_number())
    fail("type", fmt::format("{} holds something that is not a number", key), frame.entry(key, i));
  const double x = value.get<double>();
  if (!std::isfinite(x)) fail("number", fmt::format("{} holds an infinite number", key), frame.entry(key, i));
  return x;
}

int index(const Json& value, int limit, const Frame& frame, const char* key, std::size_t i) {
  if (!value.is_number_integer())
    fail("type", fmt::format("{} holds something that is not an index", key), frame.entry(key, i));
  const bool fits = value.is_number_unsigned() ? value.get<std::uint64_t>() < static_cast<std::uint64_t>(limit) : false;
  if (!fits)
    fail("index", fmt::format("{} holds index {}, must be in [0, {}]", key, value.dump(), limit - 1),
         frame.entry(key, i));
  return static_cast<int>(value.get<std::uint64_t>());
}

std::vector<int> indices(const Frame& frame, const char* key, int size, int limit) {
  std::vector<int> result;
  const Json* array = frame.array(key, size);
  for (std::size_t i = 0; array && i < array->size(); ++i) result.push_back(index((*array)[i], limit, frame, key, i));
  return result;
}

std::vector<Vec3> points(const Frame& frame, int size) {
  const char* key = "vertices_coords";
  std::vector<Vec3> result;
  const Json* array = frame.array(key, size);
  for (std::size_t i = 0; array && i < array->size(); ++i) {
    const Json& row = (*array)[i];
    if (!row.is_array() || row.size() < 2 || row.size() > 3)
      fail("coordinates", "a vertex needs 2 or 3 coordinates", frame.entry(key, i));
    Vec3 p(0, 0, 0);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double x = number(row[k], frame, key, i);
      if (std::abs(x) > kMaxCoordinate)
        fail("number", fmt::format("{} holds {}, must be at most {}", key, x, kMaxCoordinate), frame.entry(key, i));
      p[static_cast<int>(k)] = x;
    }
    result.push_back(p);
  }
  return result;
}

std::optional<SheetPlane> sheet_plane(const std::vector<Vec3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  if (box.isEmpty()) return SheetPlane();
  const Vec3 sizes = box.sizes();
  const double most_off = kFlatSheet * sizes.maxCoeff();
  for (const double allowed : {0.0, most_off})
    for (const int axis : {2, 1, 0})
      if (sizes[axis] <= allowed) {
        SheetPlane plane;
        plane.axis = axis, plane.off = sizes[axis];
        return plane;
      }
  SheetPlane plane = plane_through(points);
  const Vec3 normal = plane.right.cross(plane.up);
  for (const Vec3& p : points) plane.off = std::max(plane.off, std::abs(normal.dot(p - plane.on)));
  return plane.off <= most_off ? std::optional(plane) : std::nullopt;
}

Vec2 in_plane(const Vec3& p, const SheetPlane& plane) {
  if (plane.axis < 0) return {plane.right.dot(p - plane.on), plane.up.dot(p - plane.on)};
  if (plane.axis == 1) return {p.x(), 0.0 - p.z()};
  return plane.axis == 0 ? Vec2(p.y(), p.z()) : Vec2(p.x(), p.y());
}

}  // namespace plico::fold_json
