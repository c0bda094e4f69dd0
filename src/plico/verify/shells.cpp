#include "plico/verify/shells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plico/base/rng.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

// Planes of a body, to ask whether points are in it.
struct HalfSpaces {
  std::vector<Plane> planes;
  Eigen::AlignedBox3d box;

  // Positive outside; minus the distance to the nearest plane inside.
  double outside(const Vec3& p) const {
    double most = -INFINITY;
    for (const Plane& plane : planes) most = std::max(most, plane.height(p));
    return most;
  }
  bool contains(const Vec3& p) const {
    return box.contains(p) &&
           std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) { return plane.height(p) <= 0; });
  }
};

HalfSpaces half_spaces(const PolygonSoup& surface) {
  HalfSpaces result;
  for (const Vec3& p : surface.points) result.box.extend(p);
  for (int f = 0; f < surface.num_faces(); ++f) {
    const auto c = surface.face(f);
    const Vec3& a = surface.points[c[0]];
    const Vec3 normal = (surface.points[c[1]] - a).cross(surface.points[c[2]] - a);
    // Through the farthest point: the same plane, but for needles, whose normals are mostly rounding.
    const Vec3 unit = normal.normalized();
    if (normal.norm() > 0) result.planes.push_back({unit, extent(surface.points, unit).second});
  }
  return result;
}

HalfSpaces half_spaces(const ConvexPolyhedron& hull) {
  HalfSpaces result;
  for (const Vec3& p : hull.points) result.box.extend(p);
  for (const auto& facet : hull.facets) result.planes.push_back(facet.plane);
  return result;
}

class ShellsJudge {
 public:
  ShellsJudge(const ShellsClaim& claim, const ShellsCheckOptions& options, const Run& run)
      : claim_(claim), options_(options), run_(run) {
    Eigen::AlignedBox3d box;
    for (const auto& part : claim.parts)
      for (const Vec3& p : part) box.extend(p);
    for (const auto& shell : claim.shells)
      for (const Vec3& p : shell.surface.points) box.extend(p);
    diagonal_ = box.isEmpty() ? 0 : box.diagonal().norm();
  }

  ShellsVerdict judge() {
    if (!read_surfaces()) return finish();
    for (int s = 0; s < verdict_.shells && still_running(); ++s) {
      check_convex(s);
      check_inside(s);
    }
    check_disjoint();
    check_contacts();
    check_loss();
    return finish();
  }

  ShellsVerdict judge_around(const ShellsClaim& before, double max_growth) {
    if (!read_surfaces()) return finish();
    if (before.shells.size() != claim_.shells.size()) {
      defect("shells/count", fmt::format("{} shells became {}", before.shells.size(), claim_.shells.size()));
      return finish();
    }
    for (int s = 0; s < verdict_.shells && still_running(); ++s) {
      check_convex(s);
      check_around(s, before.shells[s].surface, max_growth);
    }
    check_disjoint();
    check_contacts();
    return finish();
  }

 private:
  bool read_surfaces() {
    verdict_.shells = static_cast<int>(claim_.shells.size());
    for (int s = 0; s < verdict_.shells; ++s)
      if (!is_triangles(s)) return false;
    for (const auto& shell : claim_.shells) spaces_.push_back(half_spaces(shell.surface));
    return true;
  }

  // The old surface is inside, and the volume between is no more than allowed.
  void check_around(int s, const PolygonSoup& old, double max_growth) {
    double worst = -INFINITY;
    for (int v : old.corners) worst = std::max(worst, spaces_[s].outside(old.points[v]));
    if (!(worst <= options_.tolerance * diagonal_))
      defect("shells/not-around", fmt::format("shell {} leaves {:.3g} of what it was outside", s, worst));
    const double growth = enclosed_volume(surface(s)) / enclosed_volume(old) - 1;
    if (!(growth >= -1e-6 && growth <= max_growth + 1e-9))
      defect("shells/growth", fmt::format("shell {} grew by {:.6g}, allowed is {:.6g}", s, growth, max_growth));
  }

  static double enclosed_volume(const PolygonSoup& soup) {
    double six = 0;
    const Vec3 origin = soup.points.front();
    for (int f = 0; f < soup.num_faces(); ++f) {
      const auto c = soup.face(f);
      six += (soup.points[c[0]] - origin).dot((soup.points[c[1]] - origin).cross(soup.points[c[2]] - origin));
    }
    return six / 6;
  }

  bool still_running() {
    if (run_.over()) verdict_.complete = false;
    return verdict_.complete;
  }

  void defect(const std::string& code, const std::string& message) {
    if (++count_[code] <= kShown) verdict_.defects.push_back({code, message});
  }

  ShellsVerdict finish() {
    for (const auto& [code, count] : count_)
      if (count > kShown) verdict_.defects.push_back({code, fmt::format("{} more of this kind", count - kShown)});
    return std::move(verdict_);
  }

  const PolygonSoup& surface(int s) const { return claim_.shells[s].surface; }

  bool is_triangles(int s) {
    const PolygonSoup& soup = surface(s);
    bool good = soup.num_faces() >= 4;
    for (int f = 0; f < soup.num_faces() && good; ++f) {
      good = soup.face(f).size() == 3;
      for (int v : soup.face(f)) good = good && v >= 0 && v < soup.num_points() && soup.points[v].allFinite();
    }
    if (!good) defect("shells/no-surface", fmt::format("shell {} is not made of at least 4 triangles", s));
    verdict_.triangles += soup.num_faces();
    return good;
  }

  // Closed, in one piece, of genus 0, and no neighbour of a triangle reaches above it: then it is convex, since a
  // closed surface that is convex at every edge and wraps its inside once is.
  void check_convex(int s) {
    const PolygonSoup& soup = surface(s);
    std::map<std::pair<int, int>, int> opposite;  // directed edge -> third corner
    bool closed = true;
    for (int f = 0; f < soup.num_faces(); ++f) {
      const auto c = soup.face(f);
      for (int i = 0; i < 3; ++i) closed &= opposite.try_emplace({c[i], c[(i + 1) % 3]}, c[(i + 2) % 3]).second;
    }
    int reflex = 0;
    for (const auto& [edge, third] : opposite) {
      const auto across = opposite.find({edge.second, edge.first});
      if (across == opposite.end()) {
        closed = false;
      } else if (is_reflex(soup.points[edge.first], soup.points[edge.second], soup.points[third],
                           soup.points[across->second])) {
        ++reflex;
      }
    }
    if (reflex > 0) defect("shells/reflex", fmt::format("shell {} has {} reflex edges", s, reflex / 2 + reflex % 2));
    if (!closed || !is_sphere(soup)) defect("shells/not-closed", fmt::format("shell {} is no closed sphere", s));
  }

  // The edge a b between the triangles a b left and b a right; one folded back onto itself is reflex, too.
  static bool is_reflex(const Vec3& a, const Vec3& b, const Vec3& left, const Vec3& right) {
    const int side = orient3d(a, b, left, right);
    return side < 0 || (side == 0 && (b - a).cross(left - a).dot((a - b).cross(right - b)) <= 0);
  }

  // Euler's formula for the used points, and one piece.
  static bool is_sphere(const PolygonSoup& soup) {
    std::vector<int> root(soup.points.size(), -1);
    const auto find = [&](int v) {
      while (root[v] != v) v = root[v] = root[root[v]];
      return v;
    };
    for (int v : soup.corners) root[v] = v;
    int pieces = static_cast<int>(root.size() - std::count(root.begin(), root.end(), -1));
    const int used = pieces;
    for (int f = 0; f < soup.num_faces(); ++f)
      for (int i = 0; i < 2; ++i)
        if (const int a = find(soup.face(f)[i]), b = find(soup.face(f)[i + 1]); a != b) root[a] = b, --pieces;
    return pieces == 1 && 2 * used - soup.num_faces() == 4;  // V - 3F/2 + F = 2
  }

  void check_inside(int s) {
    const ConvexPolyhedron hull = convex_hull(claim_.shells[s].in_hull_of);
    const HalfSpaces space = half_spaces(hull);
    double worst = hull.empty() ? INFINITY : -INFINITY;
    for (const Vec3& p : surface(s).points) worst = std::max(worst, space.outside(p));
    if (worst > options_.tolerance * diagonal_)
      defect("shells/outside", fmt::format("shell {} sticks out of the hull of its part by {:.3g}", s, worst));
  }

  void check_disjoint() {
    std::map<std::pair<int, int>, std::vector<Plane>> planes;
    for (const auto& contact : claim_.contacts) {
      if (!is_pair(contact)) {
        defect("shells/contact", fmt::format("a contact names shells {} and {}", contact.first, contact.second));
      } else if (contact.first < contact.second) {
        planes[{contact.first, contact.second}].push_back(contact.plane);
      } else {
        planes[{contact.second, contact.first}].push_back(contact.plane.flipped());
      }
    }
    for (int a = 0; a < verdict_.shells; ++a)
      for (int b = a + 1; b < verdict_.shells; ++b) {
        if (!still_running()) return;
        const std::vector<Plane>& claimed = planes[{a, b}];
        if (claimed.empty() ? boxes_apart(a, b) : parted(a, b, claimed))
          ++verdict_.pairs;
        else
          defect("shells/overlap", fmt::format("no plane parts shells {} and {}", a, b));
      }
  }

  bool is_pair(const ShellsClaim::Contact& contact) const {
    return contact.first >= 0 && contact.second >= 0 && contact.first < verdict_.shells &&
           contact.second < verdict_.shells && contact.first != contact.second;
  }

  bool boxes_apart(int a, int b) const {
    const Eigen::AlignedBox3d &x = spaces_[a].box, &y = spaces_[b].box;
    return (x.max().array() <= y.min().array()).any() || (y.max().array() <= x.min().array()).any();
  }

  bool parted(int a, int b, const std::vector<Plane>& planes) {
    return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return all_on_side(surface(a), plane, -1) && all_on_side(surface(b), plane, 1);
    });
  }

  bool all_on_side(const PolygonSoup& soup, const Plane& plane, int side) {
    verdict_.plane_tests += soup.num_points();
    return plane.normal.squaredNorm() > 0 && std::all_of(soup.points.begin(), soup.points.end(), [&](const Vec3& p) {
             return side_of_plane(plane, p) == side;
           });
  }

  // Every corner of a contact lies on the surface of both shells, and the corners span an area.
  void check_contacts() {
    for (const auto& contact : claim_.contacts) {
      if (contact.polygon.empty() || !is_pair(contact)) continue;
      double off = 0;
      for (const Vec3& p : contact.polygon)
        for (int s : {contact.first, contact.second}) off = std::max(off, std::abs(spaces_[s].outside(p)));
      Vec3 twice = Vec3::Zero();
      for (std::size_t i = 2; i < contact.polygon.size(); ++i)
        twice += (contact.polygon[i - 1] - contact.polygon[0]).cross(contact.polygon[i] - contact.polygon[0]);
      if (off > options_.contact_tolerance * diagonal_ || !(twice.norm() > 0))
        defect("shells/not-touching", fmt::format("the contact of shells {} and {} is off their surfaces by {:.3g}",
                                                  contact.first, contact.second, off));
    }
  }

  // Of random points in the union of the hulls, the share that no shell contains. A point is drawn in a hull's box, and
  // counts when that hull is the first that contains it, weighted by the box's volume: so the union is covered once.
  void check_loss() {
    std::vector<HalfSpaces> hulls;
    for (const auto& part : claim_.parts) hulls.push_back(half_spaces(convex_hull(part)));
    double all = 0, lost = 0, squares = 0;
    double boxes = 0;
    for (const HalfSpaces& hull : hulls) boxes += hull.planes.empty() ? 0 : hull.box.volume();
    for (std::size_t h = 0; h < hulls.size(); ++h) {
      if (!still_running()) return;
      if (hulls[h].planes.empty()) continue;
      const int samples = 1000 + static_cast<int>(options_.samples * (hulls[h].box.volume() / boxes));
      sample_hull(h, hulls, samples, all, lost, squares);
    }
    verdict_.loss = all > 0 ? lost / all : 0;
    verdict_.loss_error = all > 0 ? 4 * std::sqrt(squares) / all + 4.0 / options_.samples : 1;
    if (!(std::abs(verdict_.loss - claim_.loss) <= verdict_.loss_error))
      defect("shells/loss",
             fmt::format("the loss is claimed to be {:.4g} %, and is {:.4g} % by samples (within {:.2g})",
                         100 * claim_.loss, 100 * verdict_.loss, 100 * verdict_.loss_error));
  }

  void sample_hull(std::size_t h, const std::vector<HalfSpaces>& hulls, int samples, double& all, double& lost,
                   double& squares) const {
    Rng rng = Rng(options_.seed).stream(h);
    const Vec3 size = hulls[h].box.sizes();
    int inside = 0, unfilled = 0;
    for (int i = 0; i < samples; ++i) {
      Vec3 p = hulls[h].box.min();
      for (int axis = 0; axis < 3; ++axis) p[axis] += rng.uniform() * size[axis];
      if (!hulls[h].contains(p)) continue;
      const auto contains = [&](const HalfSpaces& space) { return space.contains(p); };
      if (std::any_of(hulls.begin(), hulls.begin() + static_cast<std::ptrdiff_t>(h), contains)) continue;
      ++inside;
      if (std::none_of(spaces_.begin(), spaces_.end(), contains)) ++unfilled;
    }
    const double weight = size.prod() / samples;
    all += weight * inside;
    lost += weight * unfilled;
    // Variance of a count of hits; a count of 0 may have been 1.
    squares += weight * weight * std::max(1, unfilled);
  }

  static constexpr int kShown = 5;

  const ShellsClaim& claim_;
  const ShellsCheckOptions& options_;
  const Run& run_;
  double diagonal_ = 0;
  std::vector<HalfSpaces> spaces_;
  std::map<std::string, int> count_;
  ShellsVerdict verdict_;
};

}  // namespace

ShellsVerdict verify_shells(const ShellsClaim& claim, const ShellsCheckOptions& options, const Run& run) {
  return ShellsJudge(claim, options, run).judge();
}

ShellsVerdict verify_remeshed_shells(const RemeshClaim& claim, const ShellsCheckOptions& options, const Run& run) {
  return ShellsJudge(claim.after, options, run).judge_around(claim.before, claim.max_growth);
}

}  // namespace plico
