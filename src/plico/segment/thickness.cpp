#include "plico/segment/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "plico/base/libm.h"
#include "plico/geom/box_tree.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr int kAround = 6;                           // rays in each ring of the cone
constexpr std::array kRings = {kPi / 7, kPi / 3.6};  // angles from its axis
constexpr int kSmoothings = 2;

// Where rays that start inside leave a mesh.
class Inside {
 public:
  explicit Inside(const Mesh& mesh) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (FaceId f : mesh.faces()) {
      const std::vector<int> corners(mesh.corners(f).begin(), mesh.corners(f).end());
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Corners& t = triangles_.emplace_back(Corners{
            mesh.point(VertexId(corners[0])), mesh.point(VertexId(corners[i])), mesh.point(VertexId(corners[i + 1]))});
        Eigen::AlignedBox3d& box = boxes.emplace_back(t[0]);
        box.extend(t[1]);
        box.extend(t[2]);
      }
    }
    tree_.emplace(boxes);
  }

  // Infinite when the ray hits nothing from inside.
  double way_out(const Vec3& from, const Vec3& along, double at_least) const {
    double nearest = std::numeric_limits<double>::infinity();
    const Vec3 inverse = along.cwiseInverse();
    const auto enters = [&](const Eigen::AlignedBox3d& box) {
      double first = at_least, last = nearest;
      for (int k = 0; k < 3; ++k) {
        const double a = (box.min()[k] - from[k]) * inverse[k], b = (box.max()[k] - from[k]) * inverse[k];
        // A ray in the plane of a box side gives no number; such a side does not bound it.
        if (!(a == a && b == b)) continue;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
      }
      return first <= last;
    };
    tree_->any(enters, [&](int i) {
      const double t = hit(triangles_[i], from, along);
      if (t > at_least && t < nearest) nearest = t;
      return false;
    });
    return nearest;
  }

 private:
  using Corners = std::array<Vec3, 3>;

  // By Moeller and Trumbore (1997); -1 for a miss, and for a triangle seen from outside.
  static double hit(const Corners& t, const Vec3& from, const Vec3& along) {
    const Vec3 u = t[1] - t[0], v = t[2] - t[0], p = along.cross(v);
    const double det = u.dot(p);
    if (!(det < 0)) return -1;
    const Vec3 s = from - t[0], q = s.cross(u);
    const double a = s.dot(p) / det, b = along.dot(q) / det;
    return a >= 0 && b >= 0 && a + b <= 1 ? v.dot(q) / det : -1;
  }

  std::vector<Corners> triangles_;
  std::optional<BoxTree> tree_;
};

// Directions into the shape, the axis first.
std::vector<Vec3> cone(const Mesh& mesh, FaceId f) {
  const Vec3 axis = -normal(mesh, f);
  HalfedgeId longest = *mesh.halfedges(f).begin();
  for (HalfedgeId h : mesh.halfedges(f))
    if (length(mesh, mesh.edge(h)) > length(mesh, mesh.edge(longest))) longest = h;
  const Vec3 x = (mesh.point(mesh.to(longest)) - mesh.point(mesh.from(longest))).normalized(), y = axis.cross(x);
  std::vector<Vec3> rays{axis};
  for (double off : kRings)
    for (int i = 0; i < kAround; ++i) {
      const double turn = 2 * kPi * i / kAround;
      rays.push_back(plico::cos(off) * axis + plico::sin(off) * (plico::cos(turn) * x + plico::sin(turn) * y));
    }
  return rays;
}

}  // namespace

std::vector<double> thickness(const Mesh& mesh) {
  const Inside inside(mesh);
  std::vector<double> thick;
  for (FaceId f : mesh.faces()) {
    const double at_least = 1e-6 * std::sqrt(area(mesh, f));
    std::vector<double> ways;
    for (const Vec3& ray : cone(mesh, f))
      if (const double way = inside.way_out(center(mesh, f), ray, at_least); std::isfinite(way)) ways.push_back(way);
    if (ways.empty()) {
      thick.push_back(0);
      continue;
    }
    std::nth_element(ways.begin(), ways.begin() + ways.size() / 2, ways.end());
    thick.push_back(ways[ways.size() / 2]);
  }
  for (int round = 0; round < kSmoothings; ++round) {
    std::vector<double> smooth;
    for (FaceId f : mesh.faces()) {
      double sum = area(mesh, f) * thick[f], total = area(mesh, f);
      for (HalfedgeId h : mesh.halfedges(f))
        if (const HalfedgeId twin = mesh.twin(h); twin.valid() && thick[mesh.face(twin)] > 0)
          sum += area(mesh, mesh.face(twin)) * thick[mesh.face(twin)], total += area(mesh, mesh.face(twin));
      smooth.push_back(thick[f] > 0 && total > 0 ? sum / total : 0);
    }
    thick = std::move(smooth);
  }
  return thick;
}

std::vector<int> cut_by_thickness(const Mesh& mesh, const DualGraph& graph, std::vector<int> part,
                                  const NeckCutOptions& options, const Run& run) {
  const int count = part.empty() ? 0 : 1 + *std::max_element(part.begin(), part.end());
  if (std::isinf(options.worst_score) || count >= options.max_parts || run.over()) return part;
  DualGraph discounted = graph;
  discounted.discount(thickness(mesh));
  return cut_at_necks(discounted, std::move(part), options, run);
}

}  // namespace plico
