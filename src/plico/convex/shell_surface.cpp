#include "plico/convex/shell_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "plico/geom/predicates.h"

namespace plico {
namespace {

Vec3 doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

}  // namespace

ShellSurface::ShellSurface(const ConvexPolyhedron& body, const ShellRoom& room) : room_(room) {
  for (const Vec3& p : body.points) vertices_.push_back({p, {}, {}});
  for (const ConvexPolyhedron::Facet& facet : body.facets)
    for (std::size_t i = 2; i < facet.corners.size(); ++i)
      add_triangle({facet.corners[0], facet.corners[i - 1], facet.corners[i]});
  find_flats();
}

// Contact planes first; then every plane that two neighbouring triangles share.
void ShellSurface::find_flats() {
  for (std::size_t i = 0; i < room_.planes.size(); ++i) {
    if (!room_.contact[i]) continue;
    const Plane& plane = room_.planes[i];
    double highest = -INFINITY;
    for (const Vertex& v : vertices_) highest = std::max(highest, plane.height(v.point));
    plane_of_room_.push_back(static_cast<int>(i));
    add_flat({plane.normal, plane.offset + highest});
  }
  for (const auto& [p, q] : edges()) {
    const Vec3 &a = point(p), &b = point(q), &c = point(corner_beyond(q, p)), &d = point(corner_beyond(p, q));
    const bool left = doubled_area(a, b, c).norm() > doubled_area(b, a, d).norm();
    const Vec3 normal = left ? doubled_area(a, b, c) : doubled_area(b, a, d);
    if (!(normal.norm() > 0)) continue;
    const Plane plane{normal.normalized(), normal.normalized().dot(a)};
    if (std::abs(plane.height(left ? d : c)) > room_.tolerance) continue;
    const bool known = std::any_of(flat_planes_.begin(), flat_planes_.end(), [&](const Plane& flat) {
      return std::max({std::abs(flat.height(a)), std::abs(flat.height(b)), std::abs(flat.height(c)),
                       std::abs(flat.height(d))}) <= room_.tolerance;
    });
    if (known) continue;
    plane_of_room_.push_back(-1);
    add_flat(plane);
  }
}

void ShellSurface::add_flat(const Plane& plane) {
  for (Vertex& v : vertices_)
    if (std::abs(plane.height(v.point)) <= room_.tolerance) v.flats.push_back(static_cast<int>(flat_planes_.size()));
  flat_planes_.push_back(plane);
}

std::optional<ShellSurface::Patch> ShellSurface::patch_of(int vertex) const {
  const Vertex& v = vertices_[vertex];
  std::optional<Patch> patch = with_loop({{vertex, -1}, v.triangles, {}, {}, {}});
  if (patch) patch->flats = flats_beyond(*patch, v.flats);
  if (patch && patch->flats.size() > 2) return std::nullopt;
  return patch;
}

std::optional<ShellSurface::Patch> ShellSurface::patch_of(int from, int to, bool keep_flat) const {
  const Vertex &a = vertices_[from], &b = vertices_[to];
  std::vector<int> triangles, all, one, flats;
  std::set_union(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(),
                 std::back_inserter(triangles));
  std::optional<Patch> patch = with_loop({{from, to}, std::move(triangles), {}, {}, {}});
  if (!patch) return std::nullopt;
  std::set_union(a.flats.begin(), a.flats.end(), b.flats.begin(), b.flats.end(), std::back_inserter(all));
  flats = flats_beyond(*patch, all);
  if (keep_flat) {
    std::set_symmetric_difference(a.flats.begin(), a.flats.end(), b.flats.begin(), b.flats.end(),
                                  std::back_inserter(one));
    std::set_union(flats.begin(), flats.end(), one.begin(), one.end(), std::back_inserter(patch->flats));
  } else {
    patch->flats = flats;
  }
  if (patch->flats.size() > 3 || (keep_flat && patch->flats == flats)) return std::nullopt;
  return patch;
}

// Of `flats`, the contacts and those with a triangle just beyond the loop.
std::vector<int> ShellSurface::flats_beyond(const Patch& patch, const std::vector<int>& flats) const {
  std::vector<int> result;
  for (int flat : flats) {
    bool beyond = plane_of_room_[flat] >= 0;
    for (std::size_t i = 0; i < patch.loop.size() && !beyond; ++i)
      beyond = on_one_flat({patch.loop[i], patch.loop[(i + 1) % patch.loop.size()], patch.across[i]}, {flat});
    if (beyond) result.push_back(flat);
  }
  return result;
}

std::optional<ShellSurface::Patch> ShellSurface::with_loop(Patch patch) const {
  std::map<int, int> next;
  std::size_t sides = 0;
  const auto is_removed = [&](int v) { return v == patch.removed[0] || v == patch.removed[1]; };
  for (int t : patch.triangles)
    for (int i = 0; i < 3; ++i) {
      const int p = triangles_[t][i], q = triangles_[t][(i + 1) % 3];
      if (is_removed(p) || is_removed(q)) continue;
      next[p] = q;
      ++sides;
    }
  if (sides < 3 || next.size() != sides) return std::nullopt;
  for (int p = next.begin()->first; patch.loop.size() < sides; p = patch.loop.back()) {
    const auto it = next.find(p);
    if (it == next.end()) return std::nullopt;
    patch.loop.push_back(it->second);
    if (it->second == next.begin()->first) break;
  }
  if (patch.loop.size() != sides) return std::nullopt;
  for (std::size_t i = 0; i < sides; ++i) {
    patch.across.push_back(corner_beyond(patch.loop[i], patch.loop[(i + 1) % sides]));
    if (patch.across.back() < 0) return std::nullopt;
  }
  return patch;
}

int ShellSurface::corner_beyond(int p, int q) const {
  for (int t : vertices_[p].triangles)
    for (int i = 0; i < 3; ++i)
      if (triangles_[t][i] == q && triangles_[t][(i + 1) % 3] == p) return triangles_[t][(i + 2) % 3];
  return -1;
}

bool ShellSurface::on_one_flat(std::initializer_list<int> vertices, const std::vector<int>& flats) const {
  return std::any_of(flats.begin(), flats.end(), [&](int flat) {
    return std::all_of(vertices.begin(), vertices.end(), [&](int v) {
      return std::binary_search(vertices_[v].flats.begin(), vertices_[v].flats.end(), flat);
    });
  });
}

// Keeps the new vertex below (sign 1) or above (-1) the plane through three vertices, unless all lie on one flat.
void ShellSurface::add_below(const Patch& patch, int p, int q, int r, double sign, std::vector<Plane>& limits) const {
  if (on_one_flat({p, q, r}, patch.flats)) return;
  const Vec3 normal = sign * doubled_area(point(p), point(q), point(r));
  const double length = normal.norm();
  if (length > 0) limits.push_back({normal / length, normal.dot(point(p)) / length - room_.margin});
}

std::vector<Plane> ShellSurface::limits(const Patch& patch) const {
  std::vector<Plane> result;
  for (std::size_t i = 0; i < patch.loop.size(); ++i)
    add_below(patch, patch.loop[(i + 1) % patch.loop.size()], patch.loop[i], patch.across[i], 1, result);
  for (std::size_t i = 0; i < room_.planes.size(); ++i) {
    const bool lies_on_it = std::any_of(patch.flats.begin(), patch.flats.end(),
                                        [&](int flat) { return plane_of_room_[flat] == static_cast<int>(i); });
    if (!lies_on_it) result.push_back({room_.planes[i].normal, room_.planes[i].offset - room_.margin});
  }
  return result;
}

void ShellSurface::add_above(const Patch& patch, std::vector<Plane>& limits) const {
  for (int t : patch.triangles) add_below(patch, triangles_[t][0], triangles_[t][1], triangles_[t][2], -1, limits);
}

void ShellSurface::add_spokes(const Patch& patch, std::vector<Plane>& limits) const {
  const std::size_t n = patch.loop.size();
  for (std::size_t i = 0; i < n; ++i)
    add_below(patch, patch.loop[i], patch.loop[(i + 1) % n], patch.loop[(i + 2) % n], -1, limits);
}

std::vector<Plane> ShellSurface::flats(const Patch& patch) const {
  std::vector<Plane> result;
  for (int flat : patch.flats) result.push_back(flat_planes_[flat]);
  return result;
}

bool ShellSurface::is_in_room(const Patch& patch, const Vec3& point) const {
  return room_.box.contains(point) &&
         std::all_of(room_.planes.begin(), room_.planes.end(),
                     [&](const Plane& plane) { return side_of_plane(plane, point) < 0; }) &&
         std::all_of(patch.flats.begin(), patch.flats.end(),
                     [&](int flat) { return std::abs(flat_planes_[flat].height(point)) <= room_.tolerance; });
}

// The triangle over one side of the loop, with its neighbours across and after it.
bool ShellSurface::is_convex_side(const Patch& patch, std::size_t i, const Vec3& point) const {
  const std::size_t n = patch.loop.size();
  const int p = patch.loop[i], q = patch.loop[(i + 1) % n], r = patch.loop[(i + 2) % n], w = patch.across[i];
  const Vec3 &a = vertices_[p].point, &b = vertices_[q].point;
  const auto is_below = [&](int other) {
    return on_one_flat({p, q, other}, patch.flats) || orient3d(a, b, point, vertices_[other].point) > 0;
  };
  if (!is_below(w) || !is_below(r)) return false;
  const Vec3 area = doubled_area(a, b, point);
  if (!(area.norm() > room_.margin * (b - a).norm())) return false;
  for (int flat : patch.flats)
    if (on_one_flat({p, q}, {flat}) && !(area.dot(flat_planes_[flat].normal) > 0)) return false;
  for (int gone : patch.removed)
    if (gone >= 0 && !on_one_flat({p, q, gone}, patch.flats) && orient3d(a, b, point, vertices_[gone].point) < 0)
      return false;
  return true;
}

bool ShellSurface::is_allowed(const Patch& patch, const Vec3& point) const {
  if (!point.allFinite() || !is_in_room(patch, point)) return false;
  for (std::size_t i = 0; i < patch.loop.size(); ++i)
    if (!is_convex_side(patch, i, point)) return false;
  return true;
}

void ShellSurface::replace(const Patch& patch, const Vec3& point) {
  for (int t : patch.triangles) remove_triangle(t);
  const int v = patch.removed[0];
  vertices_[v].point = point;
  std::vector<int> flats;  // the new vertex may lie on more of them than it must
  for (int gone : patch.removed)
    if (gone >= 0)
      for (int flat : vertices_[gone].flats)
        if (std::abs(flat_planes_[flat].height(point)) <= room_.tolerance) flats.push_back(flat);
  std::sort(flats.begin(), flats.end());
  flats.erase(std::unique(flats.begin(), flats.end()), flats.end());
  vertices_[v].flats = std::move(flats);
  for (std::size_t i = 0; i < patch.loop.size(); ++i)
    add_triangle({patch.loop[i], patch.loop[(i + 1) % patch.loop.size()], v});
}

void ShellSurface::remove_triangle(int t) {
  for (int v : triangles_[t]) {
    std::vector<int>& list = vertices_[v].triangles;
    list.erase(std::lower_bound(list.begin(), list.end(), t));
  }
  triangles_[t] = {-1, -1, -1};
  --num_triangles_;
}

void ShellSurface::add_triangle(const std::array<int, 3>& corners) {
  for (int v : corners) vertices_[v].triangles.push_back(static_cast<int>(triangles_.size()));
  triangles_.push_back(corners);
  ++num_triangles_;
}

Vec3 ShellSurface::uphill(const Patch& patch) const {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = point(patch.loop.front());
  for (std::size_t i = 0; i < patch.loop.size(); ++i)
    sum += (point(patch.loop[i]) - origin).cross(point(patch.loop[(i + 1) % patch.loop.size()]) - origin) / 2;
  return sum;
}

double ShellSurface::gain(const Patch& patch, const Vec3& at) const {
  double six = 0;  // tetrahedra between the new vertex and the triangles that it replaces
  for (int t : patch.triangles) {
    const auto& c = triangles_[t];
    six += (point(c[0]) - at).dot((point(c[1]) - at).cross(point(c[2]) - at));
  }
  return -six / 6;
}

std::vector<int> ShellSurface::neighbours(int v) const {
  std::vector<int> result;
  for (int t : vertices_[v].triangles)
    for (int corner : triangles_[t])
      if (corner != v) result.push_back(corner);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::array<int, 2>> ShellSurface::edges() const {
  std::vector<std::array<int, 2>> result;
  for (int v = 0; v < num_vertices(); ++v)
    for (int w : neighbours(v))
      if (v < w) result.push_back({v, w});
  return result;
}

std::vector<int> ShellSurface::triangles() const {
  std::vector<int> result;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (triangles_[t][0] >= 0) result.push_back(static_cast<int>(t));
  return result;
}

std::vector<Vec3> ShellSurface::points() const {
  std::vector<Vec3> result;
  for (const Vertex& v : vertices_)
    if (!v.triangles.empty()) result.push_back(v.point);
  return result;
}

}  // namespace plico
