#include "plico/geom/triangle_intersection.h"

#include "plico/geom/predicates.h"

namespace plico {
namespace {

Vec2 dropped(const Vec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

// An axis along which the triangle does not look like a line.
int viewing_axis(const Triangle3& t) {
  for (int axis = 0; axis < 2; ++axis)
    if (orient2d(dropped(t[0], axis), dropped(t[1], axis), dropped(t[2], axis)) != 0) return axis;
  return 2;
}

bool point_in_triangle(const Vec2& p, const std::array<Vec2, 3>& t) {
  const int a = orient2d(t[0], t[1], p), b = orient2d(t[1], t[2], p), c = orient2d(t[2], t[0], p);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool between(double a, double b, double x) { return (a <= x && x <= b) || (b <= x && x <= a); }

bool on_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  return orient2d(a, b, p) == 0 && between(a.x(), b.x(), p.x()) && between(a.y(), b.y(), p.y());
}

bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) {
  if (orient2d(p, q, a) * orient2d(p, q, b) < 0 && orient2d(a, b, p) * orient2d(a, b, q) < 0) return true;
  return on_segment(p, q, a) || on_segment(p, q, b) || on_segment(a, b, p) || on_segment(a, b, q);
}

bool coplanar_segment_meets(const Vec3& p, const Vec3& q, const Triangle3& triangle) {
  const int axis = viewing_axis(triangle);
  const std::array<Vec2, 3> t = {dropped(triangle[0], axis), dropped(triangle[1], axis), dropped(triangle[2], axis)};
  const Vec2 u = dropped(p, axis), v = dropped(q, axis);
  return point_in_triangle(u, t) || segments_meet(u, v, t[0], t[1]) || segments_meet(u, v, t[1], t[2]) ||
         segments_meet(u, v, t[2], t[0]);
}

bool one_side(const Triangle3& s, const Triangle3& t) {  // s strictly on one side of the plane of t
  const int a = orient3d(t[0], t[1], t[2], s[0]);
  return a != 0 && a == orient3d(t[0], t[1], t[2], s[1]) && a == orient3d(t[0], t[1], t[2], s[2]);
}

}  // namespace

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle3& t) {
  const int side_p = orient3d(t[0], t[1], t[2], p), side_q = orient3d(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return coplanar_segment_meets(p, q, t);
  const int a = orient3d(p, q, t[0], t[1]), b = orient3d(p, q, t[1], t[2]), c = orient3d(p, q, t[2], t[0]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool triangles_meet(const Triangle3& s, const Triangle3& t) {
  if (one_side(s, t) || one_side(t, s)) return false;
  // Where two triangles meet, an edge of one meets the other.
  for (std::size_t i = 0; i < 3; ++i)
    if (segment_meets_triangle(s[i], s[(i + 1) % 3], t) || segment_meets_triangle(t[i], t[(i + 1) % 3], s)) return true;
  return false;
}

bool triangles_meet_beyond_corner(const Triangle3& s, const Triangle3& t) {
  // They share a segment that starts at the corner; it ends on an edge across from the corner.
  return segment_meets_triangle(s[1], s[2], t) || segment_meets_triangle(t[1], t[2], s);
}

bool triangles_meet_beyond_edge(const Triangle3& s, const Triangle3& t) {
  if (orient3d(s[0], s[1], s[2], t[2]) != 0) return false;
  const int axis = viewing_axis(s);
  const Vec2 a = dropped(s[0], axis), b = dropped(s[1], axis);
  return orient2d(a, b, dropped(s[2], axis)) == orient2d(a, b, dropped(t[2], axis));
}

}  // namespace plico
