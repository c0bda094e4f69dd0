#include "plico/convex/cut_loss.h"

#include <cmath>

namespace plico {
namespace {

// The part of one body above the plane z = 0 of a frame.
struct AboveFrame {
  double volume = 0;
  Vec3 moments = Vec3::Zero();  // of the cross-section: area, integrals of x and y
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();

  // The side of the cross-section on a facet with this normal, counter-clockwise seen from above. The facet moves it
  // outward by -normal.z / |normal.xy| when the plane rises by 1.
  void add_side(const Vec3& from, const Vec3& to, const Vec3& normal) {
    const double cross = from.x() * to.y() - from.y() * to.x();
    moments += Vec3(cross / 2, cross * (from.x() + to.x()) / 6, cross * (from.y() + to.y()) / 6);
    const double across = std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
    if (across < 1e-9) return;  // the plane lies in the facet: no second derivative there
    const Vec3 p(1, from.x(), from.y()), q(1, to.x(), to.y()), s = p + q;
    const double length = (to - from).head<2>().norm();
    hessian += normal.z() / across * length / 6 * (p * p.transpose() + q * q.transpose() + s * s.transpose());
  }
};

Vec3 at_plane(const Vec3& a, const Vec3& b) { return a + a.z() / (a.z() - b.z()) * (b - a); }

// Adds the cone from the origin over the facet's part above; the section contains the origin's plane, so it adds none.
void add_facet(const ConvexPolyhedron::Facet& facet, const std::vector<Vec3>& local, const Vec3& normal,
               AboveFrame& sum) {
  const std::size_t n = facet.corners.size();
  Vec3 first, last, exit, entry;
  int count = 0;
  double six = 0;
  bool crosses = false;
  const auto add = [&](const Vec3& p) {
    if (count == 0) first = p;
    if (count >= 2) six += first.dot(last.cross(p));
    last = p;
    ++count;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &a = local[facet.corners[i]], &b = local[facet.corners[i + 1 == n ? 0 : i + 1]];
    if (a.z() > 0) add(a);
    if ((a.z() > 0) == (b.z() > 0)) continue;
    crosses = true;
    const Vec3 p = at_plane(a, b);
    (a.z() > 0 ? exit : entry) = p;
    add(p);
  }
  sum.volume += six / 6;
  if (crosses) sum.add_side(exit, entry, normal);
}

AboveFrame above(const ConvexPolyhedron& body, const PlaneFrame& frame) {
  const Eigen::Matrix3d turn = frame.axes.transpose();
  std::vector<Vec3> local;
  local.reserve(body.points.size());
  for (const Vec3& p : body.points) local.push_back(turn * (p - frame.origin));
  AboveFrame sum;
  for (const ConvexPolyhedron::Facet& facet : body.facets) add_facet(facet, local, turn * facet.plane.normal, sum);
  return sum;
}

}  // namespace

PlaneFrame frame_of(const Plane& plane, const Vec3& near) {
  const Vec3& n = plane.normal;
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  PlaneFrame frame;
  frame.origin = near - plane.height(near) * n;
  frame.axes.col(0) = n.cross(Vec3::Unit(least)).normalized();
  frame.axes.col(1) = n.cross(Vec3(frame.axes.col(0)));
  frame.axes.col(2) = n;
  return frame;
}

CutLoss cut_loss(const CutPair& pair, const PlaneFrame& frame) {
  const AboveFrame i = above(pair.first, frame), j = above(pair.second, frame);
  const double below_i = pair.first_volume - i.volume, below_j = pair.second_volume - j.volume;
  const double wi = pair.first_weight, wj = pair.second_weight;
  return {wi * i.volume + wj * below_j, wi * below_i + wj * j.volume, wj * j.moments - wi * i.moments,
          wi * i.hessian - wj * j.hessian};
}

}  // namespace plico
