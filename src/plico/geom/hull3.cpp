#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "plico/geom/convex3.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

// A triangle of the growing hull, and the points that see it and no triangle before it.
struct HullTriangle {
  std::array<int, 3> corners;
  std::array<int, 3> across;  // the triangle on the other side of the edge corners[i], corners[i + 1]
  Vec3 normal;                // rounded, only to pick the farthest point
  std::vector<int> outside = {};
  bool alive = true;
};

// Quickhull. A point sees a triangle when it lies strictly above it, exactly; so coplanar points outside a facet see
// only its neighbours, the horizon is one loop, and no new triangle is degenerate.
class HullBuilder {
 public:
  explicit HullBuilder(std::span<const Vec3> points) : points_(points) {}

  ConvexPolyhedron build() {
    if (!start()) return {};
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (triangles_[t].alive && !triangles_[t].outside.empty()) add(farthest(triangles_[t]), static_cast<int>(t));
    return result();
  }

 private:
  bool sees(int p, const HullTriangle& t) const {
    return orient3d(points_[t.corners[0]], points_[t.corners[1]], points_[t.corners[2]], points_[p]) < 0;
  }

  int farthest_from(const auto& distance) const {
    int best = 0;
    double most = -1;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
      if (const double d = distance(points_[i]); d > most) most = d, best = i;
    return best;
  }

  // The first tetrahedron, large so that most points fall into it. Rounded distances pick its corners; where they say
  // that everything is flat, the exact decision has the last word.
  bool start() {
    if (points_.size() < 4) return false;
    const Vec3 origin = points_[0];
    const int a = farthest_from([&](const Vec3& p) { return (p - origin).squaredNorm(); });
    const int b = farthest_from([&](const Vec3& p) { return (p - points_[a]).squaredNorm(); });
    const Vec3 ab = points_[b] - points_[a];
    const int c = farthest_from([&](const Vec3& p) { return (p - points_[a]).cross(ab).squaredNorm(); });
    const Vec3 normal = (points_[c] - points_[a]).cross(ab);
    int d = farthest_from([&](const Vec3& p) { return std::abs((p - points_[a]).dot(normal)); });
    for (int i = 0; i < static_cast<int>(points_.size()) && side(a, b, c, d) == 0; ++i) d = i;
    if (side(a, b, c, d) == 0) return false;
    first_tetrahedron(side(a, b, c, d) > 0 ? std::array{a, b, c, d} : std::array{b, a, c, d});
    return true;
  }

  int side(int a, int b, int c, int d) const { return orient3d(points_[a], points_[b], points_[c], points_[d]); }

  // d lies below a, b, c.
  void first_tetrahedron(const std::array<int, 4>& v) {
    const auto [a, b, c, d] = v;
    make({a, b, c}, {3, 1, 2});
    make({c, b, d}, {0, 3, 2});
    make({a, c, d}, {0, 1, 3});
    make({b, a, d}, {0, 2, 1});
    std::vector<int> all(points_.size());
    for (int i = 0; i < static_cast<int>(all.size()); ++i) all[i] = i;
    hand_out(all, 0);
  }

  void make(const std::array<int, 3>& corners, const std::array<int, 3>& across) {
    const auto [a, b, c] = corners;
    triangles_.push_back({corners, across, (points_[b] - points_[a]).cross(points_[c] - points_[a])});
  }

  // Every point goes to the first triangle from `first` on that it sees; the others are inside.
  void hand_out(const std::vector<int>& points, int first) {
    for (int p : points)
      for (int t = first; t < static_cast<int>(triangles_.size()); ++t)
        if (sees(p, triangles_[t])) {
          triangles_[t].outside.push_back(p);
          break;
        }
  }

  int farthest(const HullTriangle& t) const {
    const auto height = [&](int p) { return t.normal.dot(points_[p] - points_[t.corners[0]]); };
    return *std::max_element(t.outside.begin(), t.outside.end(), [&](int p, int q) { return height(p) < height(q); });
  }

  struct HorizonEdge {
    int from, to;
    int beyond;  // the triangle that stays
  };

  // Takes away what p sees, starting with `seen`; returns the loop around it and collects the points set free.
  std::vector<HorizonEdge> dig(int p, int seen, std::vector<int>& freed) {
    std::vector<HorizonEdge> horizon;
    std::vector<int> stack = {seen};
    triangles_[seen].alive = false;
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      freed.insert(freed.end(), triangles_[t].outside.begin(), triangles_[t].outside.end());
      triangles_[t].outside.clear();
      for (int i = 0; i < 3; ++i) {
        const int other = triangles_[t].across[i];
        if (!triangles_[other].alive) continue;
        if (sees(p, triangles_[other])) {
          triangles_[other].alive = false;
          stack.push_back(other);
        } else {
          horizon.push_back({triangles_[t].corners[i], triangles_[t].corners[(i + 1) % 3], other});
        }
      }
    }
    return horizon;
  }

  void add(int p, int seen) {
    std::vector<int> freed;
    const std::vector<HorizonEdge> horizon = dig(p, seen, freed);
    const int first = static_cast<int>(triangles_.size());
    std::map<int, int> leaving;  // corner of the horizon -> the new triangle on the edge that leaves it
    for (const HorizonEdge& edge : horizon) {
      leaving[edge.from] = static_cast<int>(triangles_.size());
      make({edge.from, edge.to, p}, {edge.beyond, -1, -1});
      relink(edge);
    }
    for (int t = first; t < static_cast<int>(triangles_.size()); ++t) {
      const int next = leaving.at(triangles_[t].corners[1]);
      triangles_[t].across[1] = next;
      triangles_[next].across[2] = t;
    }
    hand_out(freed, first);
  }

  void relink(const HorizonEdge& edge) {
    HullTriangle& beyond = triangles_[edge.beyond];
    for (int i = 0; i < 3; ++i)
      if (beyond.corners[i] == edge.to && beyond.corners[(i + 1) % 3] == edge.from)
        beyond.across[i] = static_cast<int>(triangles_.size()) - 1;
  }

  // The normal of a needle is mostly rounding, or 0. Any plane that holds all points will do for it: that cuts nothing
  // off.
  Plane supporting_plane(const HullTriangle& t) const {
    const Vec3 &a = points_[t.corners[0]], &b = points_[t.corners[1]], &c = points_[t.corners[2]];
    const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    Vec3 normal = t.normal.normalized();
    if (t.normal.norm() > 1e-6 * longest2) return {normal, normal.dot(a)};
    if (!(std::abs(normal.norm() - 1) < 1e-9)) normal = Vec3::UnitX();
    return {normal, extent(points_, normal).second};
  }

  ConvexPolyhedron result() const {
    ConvexPolyhedron hull;
    std::map<int, int> renumbered;
    for (const HullTriangle& t : triangles_) {
      if (!t.alive) continue;
      ConvexPolyhedron::Facet facet;
      for (int v : t.corners) {
        const auto [it, is_new] = renumbered.try_emplace(v, static_cast<int>(hull.points.size()));
        if (is_new) hull.points.push_back(points_[v]);
        facet.corners.push_back(it->second);
      }
      facet.plane = supporting_plane(t);
      hull.facets.push_back(std::move(facet));
    }
    return hull;
  }

  std::span<const Vec3> points_;
  std::vector<HullTriangle> triangles_;
};

}  // namespace

ConvexPolyhedron convex_hull(std::span<const Vec3> points) { return HullBuilder(points).build(); }

}  // namespace plico
