// How a shape looks: colours and pictures on its surface. A paint belongs to the surface in space and not to the
// numbers of its faces, so whatever changes the faces (welding, repair, simplifying, flat regions, parts) leaves it as
// it is.
#pragma once
#include <array>
#include <vector>

#include "plico/base/picture.h"
#include "plico/base/vec.h"

namespace plico {

struct PaintedTriangle {
  std::array<Vec3, 3> corners;  // counter-clockwise from outside, in the unit of the mesh
  std::array<Color, 3> colors;  // at the corners, blended in between; they tint the picture when there is one
  int picture = -1;             // of the paint's pictures, -1 for none
  std::array<Vec2, 3> uv{Vec2::Zero(), Vec2::Zero(),
                         Vec2::Zero()};  // of the picture at the corners, as color_at() has it

  bool is_plain() const;  // one colour all over
  // Where the corners count `weights`, which add up to 1.
  Vec2 uv_at(const Vec3& weights) const;
  Color color_at(const Vec3& weights) const;  // without the picture
};

struct Paint {
  std::vector<PaintedTriangle> triangles;
  std::vector<Picture> pictures;

  bool empty() const { return triangles.empty(); }
  // Colour and picture together.
  Color color_at(int triangle, const Vec3& weights) const;
};

}  // namespace plico
