// A lower bound for the loss of any plane between two convex bodies, by branch and bound: the oracle of bench_shell.
#pragma once
#include <algorithm>
#include <array>
#include <queue>

#include "plico/geom/convex3.h"

namespace plico::bench {

// Planes x_k + a x_u + b x_v = t with (a, b, t) in a box; `way` 1: the first body is below, -1: above.
struct PlaneBox {
  int axis = 0, way = 1;
  std::array<double, 3> low, high;  // a, b, t
  double bound = 0;

  bool operator<(const PlaneBox& other) const { return bound > other.bound; }  // the queue gives the least bound first
};

// What of a body lies above all planes of the box: above those through its corners at the highest t, since the height
// of a point is bilinear in (a, b) and falls with t.
inline double volume_above(ConvexPolyhedron body, const PlaneBox& box, int way) {
  const double t = way > 0 ? box.high[2] : box.low[2];
  for (int corner = 0; corner < 4 && !body.empty(); ++corner) {
    Vec3 normal = Vec3::Unit(box.axis);
    normal[(box.axis + 1) % 3] = corner & 1 ? box.high[0] : box.low[0];
    normal[(box.axis + 2) % 3] = corner & 2 ? box.high[1] : box.low[1];
    const Plane plane{normal.normalized(), t / normal.norm()};
    body = clip(body, way > 0 ? plane.flipped() : plane, 0);
  }
  return body.empty() ? 0 : volume(body);
}

struct Certificate {
  double bound = 0;  // no plane loses less volume than this: of the first above plus of the second below
  int boxes = 0;
};

// Ends when `known`, the loss of some plane, is proven to be within `gap` of the least, or after `max_boxes`.
inline Certificate certify(const ConvexPolyhedron& first, const ConvexPolyhedron& second, double known, double gap,
                           int max_boxes) {
  const auto bounded = [&](PlaneBox box) {
    box.bound = volume_above(first, box, box.way) + volume_above(second, box, -box.way);
    return box;
  };
  Eigen::AlignedBox3d all = bounding_box(first.points);
  all.extend(bounding_box(second.points));
  const double reach = all.min().cwiseAbs().cwiseMax(all.max().cwiseAbs()).sum();
  std::priority_queue<PlaneBox> queue;
  for (int axis = 0; axis < 3; ++axis)
    for (int way : {-1, 1}) queue.push(bounded({axis, way, {-1, -1, -reach}, {1, 1, reach}, 0}));
  Certificate result;
  while (true) {
    const PlaneBox box = queue.top();
    result.bound = box.bound;
    if (box.bound >= known - gap || result.boxes >= max_boxes) return result;
    queue.pop();
    int split = 0;
    const auto width = [&](int k) { return (box.high[k] - box.low[k]) * (k == 2 ? 1 : reach / 4); };
    for (int k = 1; k < 3; ++k)
      if (width(k) > width(split)) split = k;
    for (int half = 0; half < 2; ++half) {
      PlaneBox part = box;
      (half == 0 ? part.high : part.low)[split] = (box.low[split] + box.high[split]) / 2;
      queue.push(bounded(part));
      ++result.boxes;
    }
  }
}

}  // namespace plico::bench
