#include "plico/geom/convex3.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plico {
namespace {

// One cut: facets are shortened one by one, then the sides that the cut left open are chained into its facet.
class PlaneClip {
 public:
  PlaneClip(const ConvexPolyhedron& body, const Plane& plane, int source) : body_(body), plane_(plane) {
    height_.reserve(body.points.size());
    for (const Vec3& p : body.points) height_.push_back(plane.height(p));
    source_ = source;
  }

  ConvexPolyhedron result() {
    if (std::none_of(height_.begin(), height_.end(), is_out)) return body_;
    if (std::all_of(height_.begin(), height_.end(), is_out)) return {};
    kept_.assign(body_.points.size(), -1);
    for (const ConvexPolyhedron::Facet& facet : body_.facets) shorten(facet);
    close();
    return std::move(out_);
  }

 private:
  static bool is_out(double height) { return height > 0; }

  int kept(int v) {
    if (kept_[v] < 0) {
      kept_[v] = static_cast<int>(out_.points.size());
      out_.points.push_back(body_.points[v]);
    }
    return kept_[v];
  }

  // The same point from both facets of the edge, whichever comes first.
  int crossing(int a, int b) {
    const auto [it, is_new] = crossing_.try_emplace(std::minmax(a, b), static_cast<int>(out_.points.size()));
    if (is_new) {
      const auto [p, q] = std::minmax(a, b);
      const double share = height_[p] / (height_[p] - height_[q]);
      out_.points.push_back(body_.points[p] + share * (body_.points[q] - body_.points[p]));
    }
    return it->second;
  }

  void shorten(const ConvexPolyhedron::Facet& facet) {
    ConvexPolyhedron::Facet shorter{{}, facet.plane, facet.source};
    const int n = static_cast<int>(facet.corners.size());
    int start = 0;  // a kept corner, so that every exit is followed by its entry
    while (start < n && is_out(height_[facet.corners[start]])) ++start;
    if (start == n) return;
    int exit = -1;
    for (int i = 0; i < n; ++i) {
      const int a = facet.corners[(start + i) % n], b = facet.corners[(start + i + 1) % n];
      if (!is_out(height_[a])) shorter.corners.push_back(kept(a));
      if (is_out(height_[a]) == is_out(height_[b])) continue;
      const int point = crossing(a, b);
      shorter.corners.push_back(point);
      if (is_out(height_[b]))
        exit = point;
      else
        open_[point] = exit;  // the facet of the cut runs from the entry to the exit
    }
    out_.facets.push_back(std::move(shorter));
  }

  void close() {
    while (!open_.empty()) {
      ConvexPolyhedron::Facet cut{{}, plane_, source_};
      int point = open_.begin()->first;
      while (open_.contains(point)) {
        cut.corners.push_back(point);
        const auto it = open_.find(point);
        point = it->second;
        open_.erase(it);
      }
      out_.facets.push_back(std::move(cut));
    }
  }

  const ConvexPolyhedron& body_;
  const Plane& plane_;
  int source_ = 0;
  std::vector<double> height_;
  std::vector<int> kept_;
  std::map<std::pair<int, int>, int> crossing_;
  std::map<int, int> open_;
  ConvexPolyhedron out_;
};

// What of `body` is outside the facets of `other`, in convex pieces appended to `pieces`.
void subtract(ConvexPolyhedron body, const ConvexPolyhedron& other, std::vector<ConvexPolyhedron>& pieces) {
  for (const ConvexPolyhedron::Facet& facet : other.facets) {
    ConvexPolyhedron outside = clip(body, facet.plane.flipped(), 0);
    if (!outside.empty()) pieces.push_back(std::move(outside));
    body = clip(body, facet.plane, 0);
    if (body.empty()) return;
  }
}

// An edge with the normals of its two facets, which are the ends of its arc on the Gauss sphere.
struct GaussArc {
  Vec3 from, to, left, right;
};

std::vector<GaussArc> gauss_arcs(const ConvexPolyhedron& body) {
  std::map<std::pair<int, int>, Vec3> normal_of;
  for (const ConvexPolyhedron::Facet& facet : body.facets)
    for (std::size_t i = 0; i < facet.corners.size(); ++i)
      normal_of[{facet.corners[i], facet.corners[(i + 1) % facet.corners.size()]}] = facet.plane.normal;
  std::vector<GaussArc> arcs;
  for (const auto& [edge, left] : normal_of)
    if (edge.first < edge.second) {
      const auto right = normal_of.find({edge.second, edge.first});
      if (right != normal_of.end())
        arcs.push_back({body.points[edge.first], body.points[edge.second], left, right->second});
    }
  return arcs;
}

// Do the arcs left-right of `a` and of the mirrored `b` cross? Then the two edges span a facet of the difference of the
// bodies (Gregorius, The separating axis test between convex polyhedra, 2013).
bool arcs_cross(const GaussArc& a, const GaussArc& b) {
  const Vec3 c = -b.left, d = -b.right;
  const Vec3 ab = a.right.cross(a.left), cd = d.cross(c);
  const double cba = c.dot(ab), dba = d.dot(ab), adc = a.left.dot(cd), bdc = a.right.dot(cd);
  return cba * dba < 0 && adc * bdc < 0 && cba * bdc > 0;
}

struct Gap {
  double width = -INFINITY;
  Plane plane;

  // The gap between a below and b above along a direction.
  void widen(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& direction) {
    const double top = extent(a, direction).second, bottom = extent(b, direction).first;
    if (bottom - top > width) *this = {bottom - top, {direction, (top + bottom) / 2}};
  }
};

}  // namespace

ConvexPolyhedron clip(const ConvexPolyhedron& body, const Plane& plane, int source) {
  return PlaneClip(body, plane, source).result();
}

ConvexPolyhedron intersection(ConvexPolyhedron a, const ConvexPolyhedron& b, int source) {
  for (const ConvexPolyhedron::Facet& facet : b.facets) {
    const auto is_above = [&](const Vec3& p) { return facet.plane.height(p) > 0; };
    if (std::any_of(a.points.begin(), a.points.end(), is_above)) a = clip(a, facet.plane, source);
    if (a.empty()) break;
  }
  return a;
}

double volume(const ConvexPolyhedron& body) {
  double six = 0;
  for (const ConvexPolyhedron::Facet& facet : body.facets)
    for (std::size_t i = 2; i < facet.corners.size(); ++i) {
      const Vec3 &o = body.points[0], &a = body.points[facet.corners[0]];
      six += (a - o).dot((body.points[facet.corners[i - 1]] - o).cross(body.points[facet.corners[i]] - o));
    }
  return six / 6;
}

Vec3 centroid(const ConvexPolyhedron& body) {
  Vec3 mean = Vec3::Zero(), moment = Vec3::Zero();
  for (const Vec3& p : body.points) mean += p / static_cast<double>(body.points.size());
  double six = 0;
  for (const ConvexPolyhedron::Facet& facet : body.facets)
    for (std::size_t i = 2; i < facet.corners.size(); ++i) {
      const Vec3 a = body.points[facet.corners[0]] - mean, b = body.points[facet.corners[i - 1]] - mean;
      const Vec3 c = body.points[facet.corners[i]] - mean;
      const double det = a.dot(b.cross(c));
      six += det;
      moment += det / 4 * (a + b + c);
    }
  return six > 0 ? Vec3(mean + moment / six) : mean;
}

Eigen::AlignedBox3d bounding_box(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  return box;
}

Vec3 vector_area(const ConvexPolyhedron& body, const ConvexPolyhedron::Facet& facet) {
  Vec3 twice = Vec3::Zero();
  const Vec3& o = body.points[facet.corners[0]];
  for (std::size_t i = 2; i < facet.corners.size(); ++i)
    twice += (body.points[facet.corners[i - 1]] - o).cross(body.points[facet.corners[i]] - o);
  return twice / 2;
}

std::pair<double, double> extent(std::span<const Vec3> points, const Vec3& direction) {
  std::pair<double, double> range(INFINITY, -INFINITY);
  for (const Vec3& p : points) {
    const double value = direction.dot(p);
    range = {std::min(range.first, value), std::max(range.second, value)};
  }
  return range;
}

double union_volume(std::span<const ConvexPolyhedron> bodies) {
  double sum = 0;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    boxes.push_back(bounding_box(bodies[i].points));
    std::vector<ConvexPolyhedron> pieces = {bodies[i]};
    for (std::size_t j = 0; j < i; ++j) {
      if (!boxes[j].intersects(boxes[i])) continue;
      std::vector<ConvexPolyhedron> rest;
      for (ConvexPolyhedron& piece : pieces) {
        if (bounding_box(piece.points).intersects(boxes[j]))
          subtract(std::move(piece), bodies[j], rest);
        else
          rest.push_back(std::move(piece));
      }
      pieces = std::move(rest);
    }
    for (const ConvexPolyhedron& piece : pieces) sum += volume(piece);
  }
  return sum;
}

std::optional<Plane> separating_plane(const ConvexPolyhedron& a, const ConvexPolyhedron& b, double tolerance) {
  Gap gap;
  for (const ConvexPolyhedron::Facet& facet : a.facets) gap.widen(a.points, b.points, facet.plane.normal);
  for (const ConvexPolyhedron::Facet& facet : b.facets) gap.widen(a.points, b.points, -facet.plane.normal);
  if (gap.width >= 0) return gap.plane;
  const std::vector<GaussArc> arcs = gauss_arcs(b);
  for (const GaussArc& mine : gauss_arcs(a))
    for (const GaussArc& other : arcs) {
      if (!arcs_cross(mine, other)) continue;
      Vec3 axis = (mine.to - mine.from).cross(other.to - other.from);
      if (axis.squaredNorm() == 0) continue;
      axis.normalize();
      if (axis.dot(mine.left + mine.right) < 0) axis = -axis;
      const double width = axis.dot(other.from - mine.from);
      if (width > gap.width) gap.widen(a.points, b.points, axis);
    }
  if (gap.width < -tolerance) return std::nullopt;
  return gap.plane;
}

}  // namespace plico
