#include "plico/motion/penetration.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

struct Span {
  double low, high;
};

inline Span project(const PlacedPlate& plate, const Vec3& axis) {
  Span span{axis.dot(plate.corners[0]), 0};
  span.high = span.low;
  for (int i = 1; i < plate.count; ++i) {
    const double d = axis.dot(plate.corners[i]);
    span.low = std::min(span.low, d);
    span.high = std::max(span.high, d);
  }
  return span;
}

inline bool apart(const Span& a, const Span& b, double touch) {
  return b.low - a.high >= -touch || a.low - b.high >= -touch;
}

// The spans of a plate along its own normal are one number up to rounding; its first corner is enough.
inline bool apart_along_normal(const PlacedPlate& a, const PlacedPlate& b, double touch) {
  const double at = a.normal.dot(a.corners[0]);
  return apart({at, at}, project(b, a.normal), touch * a.normal.norm());
}

}  // namespace

bool penetrate(const PlacedPlate& a, const PlacedPlate& b, double touch) {
  if (apart_along_normal(a, b, touch) || apart_along_normal(b, a, touch)) return false;
  for (int i = 0; i < a.count; ++i) {
    const Vec3 side_a = a.corners[i + 1 == a.count ? 0 : i + 1] - a.corners[i];
    for (int j = 0; j < b.count; ++j) {
      const Vec3 side_b = b.corners[j + 1 == b.count ? 0 : j + 1] - b.corners[j];
      const Vec3 axis = side_a.cross(side_b);
      const double length2 = axis.squaredNorm();
      // Nearly parallel sides give an axis made of rounding errors; the other axes decide.
      if (length2 <= 1e-16 * side_a.squaredNorm() * side_b.squaredNorm()) continue;
      if (apart(project(a, axis), project(b, axis), touch * std::sqrt(length2))) return false;
    }
  }
  return true;
}

}  // namespace plico
