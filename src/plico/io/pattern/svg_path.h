// The outlines of SVG shapes as straight strokes and cubic curves, for the reader of crease patterns.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

// From a to b: straight, or the cubic Bezier curve with the control points c and d.
struct SvgStroke {
  Vec2 a, b;
  bool curved = false;
  Vec2 c{0, 0}, d{0, 0};
};

struct SvgPath {
  std::vector<SvgStroke> strokes;
  std::string error;  // what is wrong with it, and at which byte; empty when it could be read
};

// The attribute d of a <path>: all commands of SVG 1.1, absolute and relative. Quadratic curves become the same curve
// as a cubic; arcs become cubics that leave them by less than 1/3000 of the radius.
SvgPath parse_path(std::string_view d);

// An ellipse in four curves, counter-clockwise on paper whose y points up; a rectangle with round corners.
std::vector<SvgStroke> ellipse_strokes(const Vec2& centre, double rx, double ry);
std::vector<SvgStroke> rectangle_strokes(const Vec2& corner, const Vec2& size, double rx, double ry);

// The curve as a chain of points, both ends included, no farther than `tolerance` from it; as few, evenly spaced in its
// parameter, as a bound on its second derivative asks for. A straight stroke is its two ends.
std::vector<Vec2> flatten(const SvgStroke& stroke, double tolerance);

}  // namespace plico
