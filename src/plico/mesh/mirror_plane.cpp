#include "plico/mesh/mirror_plane.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "plico/base/error.h"
#include "plico/geom/box_tree.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/point_distance.h"

namespace plico {
namespace {

constexpr double kOnPlane = 1e-5;  // of the diagonal: files are rounded
// Of its shortest edge: a vertex so close to the plane is moved onto it, where a cut would leave slivers.
constexpr double kSnap = 0.3;

class Halver {
 public:
  Halver(const Mesh& mesh, const MirrorPlane& plane, double snap)
      : mesh_(mesh), plane_(plane), number_(mesh.num_vertices(), -1) {
    std::vector<double> shortest(mesh.num_vertices(), std::numeric_limits<double>::infinity());
    for (EdgeId e : mesh.edges())
      for (VertexId v : {mesh.from(mesh.halfedge(e)), mesh.to(mesh.halfedge(e))})
        shortest[v] = std::min(shortest[v], length(mesh, e));
    const double least = kOnPlane * diagonal(mesh);
    for (int v = 0; v < mesh.num_vertices(); ++v) {
      const double h = plane.height(mesh.point(VertexId(v)));
      height_.push_back(std::abs(h) <= std::max(least, snap * shortest[v]) ? 0 : h);
    }
  }

  std::optional<HalfMesh> run() {
    for (FaceId f : mesh_.faces())
      if (!add_face(mesh_.corners(f))) return {};
    if (half_.soup.num_faces() == 0) return {};
    return std::move(half_);
  }

 private:
  // False when the face lies in the plane.
  template <class Corners>
  bool add_face(const Corners& corners) {
    std::vector<int> kept;
    bool any_above = false, any_off = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int u = corners[i], v = corners[(i + 1) % corners.size()];
      any_above |= height_[u] > 0;
      any_off |= height_[u] != 0;
      if (height_[u] >= 0) kept.push_back(vertex(u));
      if (height_[u] * height_[v] < 0) kept.push_back(crossing(u, v));
    }
    if (any_above)
      for (std::size_t i = 2; i < kept.size(); ++i) half_.soup.add_face({kept[0], kept[i - 1], kept[i]});
    return any_off;
  }

  int add_point(const Vec3& p, bool on_plane) {
    half_.soup.points.push_back(on_plane ? plane_.foot(p) : p);
    half_.on_plane.push_back(on_plane);
    return half_.soup.num_points() - 1;
  }

  int vertex(int v) {
    if (number_[v] < 0) number_[v] = add_point(mesh_.soup().points[v], height_[v] == 0);
    return number_[v];
  }

  int crossing(int u, int v) {
    const auto [at, is_new] = crossing_.try_emplace(std::minmax(u, v), 0);
    if (is_new) {
      const auto [low, high] = at->first;
      const double t = height_[low] / (height_[low] - height_[high]);
      const std::vector<Vec3>& p = mesh_.soup().points;
      at->second = add_point((1 - t) * p[low] + t * p[high], true);
    }
    return at->second;
  }

  const Mesh& mesh_;
  const MirrorPlane& plane_;
  std::vector<double> height_;
  std::vector<int> number_;
  std::map<std::pair<int, int>, int> crossing_;
  HalfMesh half_;
};

// An edge inside the half whose ends are both on the plane would be there twice.
bool is_clean(const HalfMesh& half) {
  try {
    const Mesh mesh(half.soup);
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      if (!mesh.is_boundary(e) && half.on_plane[mesh.from(h)] && half.on_plane[mesh.to(h)]) return false;
    }
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

}  // namespace

std::vector<Vec3> candidates_across(const Mesh& mesh, const Vec3& middle) {
  std::vector<Vec3> normals{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (FaceId f : mesh.faces()) {
    const Vec3 d = center(mesh, f) - middle;
    spread += area(mesh, f) * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  for (int i = 0; i < 3; ++i) normals.emplace_back(axes.eigenvectors().col(i));
  return normals;
}

std::optional<MirrorPlane> mirror_plane(const Mesh& mesh, double tolerance) {
  const double total = surface_area(mesh), most = tolerance * diagonal(mesh);
  if (!(total > 0)) return {};
  MirrorPlane plane;
  plane.on.setZero();
  for (FaceId f : mesh.faces()) plane.on += area(mesh, f) / total * center(mesh, f);
  const SurfaceDistance distance(mesh.soup());
  for (const Vec3& across : candidates_across(mesh, plane.on)) {
    plane.across = across;
    bool symmetric = true;
    for (int v = 0; symmetric && v < mesh.num_vertices(); ++v)
      symmetric = distance(plane.image(mesh.point(VertexId(v)))) <= most;
    if (symmetric) return plane;
  }
  return {};
}

std::optional<HalfMesh> upper_half(const Mesh& triangles, const MirrorPlane& plane) {
  for (double snap : {kSnap, 0.0}) {
    std::optional<HalfMesh> half = Halver(triangles, plane, snap).run();
    if (half && is_clean(*half)) return half;
  }
  return {};
}

PolygonSoup with_image(const HalfMesh& half, const MirrorPlane& plane) {
  PolygonSoup whole = half.soup;
  std::vector<int> image;
  for (int v = 0; v < half.soup.num_points(); ++v) {
    image.push_back(half.on_plane[v] ? v : whole.num_points());
    if (!half.on_plane[v]) whole.points.push_back(plane.image(half.soup.points[v]));
  }
  for (int f = 0; f < half.soup.num_faces(); ++f) {
    const auto t = half.soup.face(f);
    whole.add_face({image[t[0]], image[t[2]], image[t[1]]});
  }
  return whole;
}

}  // namespace plico
