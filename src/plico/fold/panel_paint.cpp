#include "plico/fold/panel_paint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plico/geom/box_tree.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/point_distance.h"

namespace plico {
namespace {

constexpr double kInPlane = 1e-6;    // of the diagonal: painted triangles so near to a panel lie on it
constexpr double kCovered = 0.9999;  // of a panel's area: all of it, but for rounding
constexpr double kAlike = 2.0 / 255;
// Pixels along the diagonal of the shape in pictures made here, and along a panel: half a millimetre on a large animal.
constexpr double kPixelsAcross = 700;
constexpr int kLeastPixels = 4, kMostPixels = 256;

// A panel in space and in its own plane.
struct Plane {
  Vec3 origin, x, y, normal;
  std::vector<Vec2> outline;

  Vec2 flat(const Vec3& p) const { return {(p - origin).dot(x), (p - origin).dot(y)}; }
  Vec3 in_space(const Vec2& p) const { return origin + p.x() * x + p.y() * y; }
};

Plane plane_of(const Mesh& mesh, FaceId face) {
  const auto corners = mesh.corners(face);
  Plane plane;
  plane.origin = mesh.point(VertexId(corners[0]));
  plane.x = (mesh.point(VertexId(corners[1])) - plane.origin).normalized();
  plane.normal = normal(mesh, face);
  plane.y = plane.normal.cross(plane.x);
  for (const int v : corners) plane.outline.push_back(plane.flat(mesh.point(VertexId(v))));
  return plane;
}

Vec3 normal_of(const PaintedTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return (b - a).cross(c - a).normalized();
}

bool alike(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) <= kAlike && std::abs(a[1] - b[1]) <= kAlike && std::abs(a[2] - b[2]) <= kAlike;
}

// The affine map that takes three points of the plane to uv.
Eigen::Matrix<double, 2, 3> map_to_uv(const std::array<Vec2, 3>& at, const std::array<Vec2, 3>& uv) {
  Eigen::Matrix2d from, to;
  from << at[1] - at[0], at[2] - at[0];
  to << uv[1] - uv[0], uv[2] - uv[0];
  Eigen::Matrix<double, 2, 3> map;
  map.leftCols<2>() = to * from.inverse();
  map.col(2) = uv[0] - map.leftCols<2>() * at[0];
  return map;
}

class Painter {
 public:
  Painter(const Mesh& mesh, const Paint& paint)
      : mesh_(mesh), paint_(paint), diagonal_(diagonal(mesh)), boxes_(boxes_of(paint)), tree_(boxes_) {
    result_.pictures = paint.pictures;
    for (const PaintedTriangle& triangle : paint.triangles) normals_.push_back(normal_of(triangle));
    find_near_triangles();
  }

  PanelPaint run(const std::vector<int>& mesh_face) {
    for (const int face : mesh_face) result_.panels.push_back(patches(FaceId(face)));
    return std::move(result_);
  }

 private:
  static std::vector<Eigen::AlignedBox3d> boxes_of(const Paint& paint) {
    std::vector<Eigen::AlignedBox3d> boxes(paint.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
      for (const Vec3& p : paint.triangles[t].corners) boxes[t].extend(p);
    return boxes;
  }

  // Of each face the triangles whose boxes meet its own.
  void find_near_triangles() {
    const int triangles = static_cast<int>(boxes_.size());
    std::vector<Eigen::AlignedBox3d> boxes = boxes_;
    const Vec3 reach = Vec3::Constant(kInPlane * diagonal_);
    for (const FaceId f : mesh_.faces()) {
      Eigen::AlignedBox3d box;
      for (const int v : mesh_.corners(f)) box.extend(mesh_.point(VertexId(v)));
      boxes.emplace_back(box.min() - reach, box.max() + reach);
    }
    near_.resize(mesh_.num_faces());
    BoxTree(boxes).overlapping_pairs([&](int i, int j) {
      if (i < triangles && j >= triangles) near_[j - triangles].push_back(i);
      return true;
    });
    for (std::vector<int>& list : near_) std::ranges::sort(list);
  }

  std::vector<Patch> patches(FaceId face) {
    const Plane plane = plane_of(mesh_, face);
    for (const double side : {1.0, -1.0})  // a face that was turned over has its paint with it
      if (std::vector<Patch> found = covering(face, plane, side); !found.empty()) return found;
    return {baked(plane)};
  }

  bool lies_on(int triangle, const Plane& plane, double side) const {
    if (!(side * normals_[triangle].dot(plane.normal) > 0)) return false;
    return std::ranges::all_of(paint_.triangles[triangle].corners, [&](const Vec3& p) {
      return std::abs((p - plane.origin).dot(plane.normal)) <= kInPlane * diagonal_;
    });
  }

  // The pieces of the triangles on the panel, when together they cover it; none otherwise.
  std::vector<Patch> covering(FaceId face, const Plane& plane, double side) const {
    std::vector<Patch> result;
    double covered = 0;
    for (const int t : near_[face]) {
      if (!lies_on(t, plane, side)) continue;
      Patch patch = piece(t, plane);
      const double area = patch.corners.size() < 3 ? 0 : signed_area(patch.corners);
      if (!(area > 0)) continue;
      const PaintedTriangle& triangle = paint_.triangles[t];
      if (triangle.picture < 0 && !triangle.is_plain()) return {};
      covered += area;
      result.push_back(std::move(patch));
    }
    if (covered < kCovered * signed_area(plane.outline)) return {};
    const bool plain = std::ranges::all_of(
        result, [&](const Patch& p) { return p.picture < 0 && alike(p.color, result.front().color); });
    if (!plain) return result;
    result.resize(1);
    result.front().corners = plane.outline;
    return result;
  }

  Patch piece(int t, const Plane& plane) const {
    const PaintedTriangle& triangle = paint_.triangles[t];
    std::array<Vec2, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = plane.flat(triangle.corners[i]);
    Patch patch;
    patch.color = triangle.color_at(Vec3::Constant(1.0 / 3));
    patch.picture = triangle.picture;
    const double area = cross(at[1] - at[0], at[2] - at[0]);
    if (area == 0) return patch;
    if (patch.picture >= 0) patch.to_uv = map_to_uv(at, triangle.uv);
    if (area < 0) std::swap(at[1], at[2]);
    patch.corners = clipped(plane.outline, at);
    return patch;
  }

  // Rather a point that faces the same way than one round the corner, and that one rather than one on the back.
  double strangeness(int t, const Vec3& normal) const {
    const double facing = normals_[t].dot(normal);
    return diagonal_ * (1e-3 * (1 - facing) + (facing > 0 ? 0 : 0.02));
  }

  Color nearest_color(const Vec3& p, const Vec3& normal) const {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    tree_.nearest(p, [&](int t) {
      const Vec3 weights = nearest_weights(paint_.triangles[t].corners, p);
      const auto& [a, b, c] = paint_.triangles[t].corners;
      const double away =
          (weights[0] * a + weights[1] * b + weights[2] * c - p).norm() + std::max(0.0, strangeness(t, normal));
      if (away < least) least = away, best = t;
      return away;
    });
    return paint_.color_at(best, nearest_weights(paint_.triangles[best].corners, p));
  }

  // The panel's own picture, of the box around it.
  Patch baked(const Plane& plane) {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : plane.outline) box.extend(p);
    const double pixel = std::max(diagonal_ / kPixelsAcross, box.sizes().maxCoeff() / kMostPixels);
    const auto count = [&](double length) {
      return std::clamp(static_cast<int>(std::ceil(length / pixel)), kLeastPixels, kMostPixels);
    };
    Picture picture{count(box.sizes().x()), count(box.sizes().y()), {}};
    // The centres of the outermost pixels lie on the rim, so that nothing is taken from beyond it.
    const Vec2 step(box.sizes().x() / (picture.width - 1), box.sizes().y() / (picture.height - 1));
    Patch patch{plane.outline, kWhite, -1};
    std::vector<Color> colors;
    for (int row = 0; row < picture.height; ++row)
      for (int column = 0; column < picture.width; ++column)
        colors.push_back(nearest_color(
            plane.in_space({box.min().x() + column * step.x(), box.max().y() - row * step.y()}), plane.normal));
    if (std::ranges::all_of(colors, [&](const Color& c) { return alike(c, colors.front()); })) {
      patch.color = colors.front();
      return patch;
    }
    for (const Color& color : colors) {
      for (const double channel : color) picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
      picture.rgba.push_back(255);
    }
    patch.picture = static_cast<int>(result_.pictures.size());
    const Vec2 uv_a_unit = Vec2(1.0 / picture.width, 1.0 / picture.height).cwiseQuotient(step);
    const Vec2 start = Vec2(0.5 / picture.width, 0.5 / picture.height) - box.min().cwiseProduct(uv_a_unit);
    patch.to_uv << uv_a_unit.x(), 0, start.x(), 0, uv_a_unit.y(), start.y();
    result_.pictures.push_back(std::move(picture));
    return patch;
  }

  const Mesh& mesh_;
  const Paint& paint_;
  const double diagonal_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  BoxTree tree_;
  std::vector<Vec3> normals_;
  std::vector<std::vector<int>> near_;
  PanelPaint result_;
};

// Of a patch with a picture: over a few points in it.
Color mean_color(const Patch& patch, const std::vector<Picture>& pictures) {
  if (patch.picture < 0) return patch.color;
  constexpr int kSteps = 8;
  Color sum{};
  double count = 0;
  for (const auto& corners : triangulate(patch.corners))
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; i + j < kSteps; ++j) {
        const double a = (i + 1.0 / 3) / kSteps, b = (j + 1.0 / 3) / kSteps;
        const Vec2 p =
            a * patch.corners[corners[0]] + b * patch.corners[corners[1]] + (1 - a - b) * patch.corners[corners[2]];
        const Color color = color_at(pictures[patch.picture], patch.uv_at(p));
        for (std::size_t k = 0; k < 3; ++k) sum[k] += color[k];
        ++count;
      }
  for (double& channel : sum) channel /= std::max(count, 1.0);
  return product(patch.color, sum);
}

}  // namespace

PanelPaint panel_paint(const Mesh& mesh, const Unfolding& net, const Paint& paint) {
  if (paint.empty()) return {};
  return Painter(mesh, paint).run(net.mesh_face);
}

PanelPaint plain_paint(const CreasePattern& sheet, const std::vector<Color>& colors) {
  PanelPaint paint;
  for (std::size_t p = 0; p < colors.size(); ++p) {
    const std::vector<int>& corners = sheet.faces[p];
    const Vec2 origin = sheet.vertices[corners[0]], x = (sheet.vertices[corners[1]] - origin).normalized();
    Patch patch{.corners = {}, .color = colors[p]};
    for (const int v : corners) {
      const Vec2 at = sheet.vertices[v] - origin;
      patch.corners.emplace_back(at.dot(x), at.dot(perpendicular(x)));
    }
    paint.panels.push_back({std::move(patch)});
  }
  return paint;
}

std::vector<Color> panel_colors(const PanelPaint& paint) {
  std::vector<Color> colors;
  for (const std::vector<Patch>& patches : paint.panels) {
    Color sum{};
    double area = 0;
    for (const Patch& patch : patches) {
      const Color color = mean_color(patch, paint.pictures);
      const double share = std::abs(signed_area(patch.corners));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += share * color[k];
      area += share;
    }
    for (double& channel : sum) channel = area > 0 ? channel / area : 1;
    colors.push_back(sum);
  }
  return colors;
}

}  // namespace plico
