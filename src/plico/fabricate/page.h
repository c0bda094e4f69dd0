// Paper sizes and the size of the finished model.
#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "plico/fold/page_layout.h"
#include "plico/fold/unfolding.h"

namespace plico {

struct PageOptions {
  Vec2 size{210, 297};  // millimetres
  Margins margin = 10;  // left free, millimetres, at least 0
};
void check(const PageOptions& options);  // throws InvalidOption naming field, value and range

Vec2 printable(const PageOptions& page);  // the size inside the margins

// "A4", "B3", "Letter", ... or "WIDTHxHEIGHT" with units as parse_length_mm takes them ("300x400", "12x18in");
// millimetres. Throws InvalidOption otherwise.
Vec2 paper_size(std::string_view name);

// "8mm" all around, "8,12" above and below, then left and right, or "8,12,20,12": top, right, bottom, left, as style
// sheets have them. Throws InvalidOption.
Margins parse_margins(std::string_view text);

// What the finished model is like: how large, and how far each sheet edge is folded when its seam is glued.
struct FoldedShape {
  Vec3 size = Vec3::Zero();              // of its bounding box, in the net's unit
  std::vector<double> seam_angle;        // of each mesh edge, radians, valley > 0 > mountain; empty when not known
  std::vector<std::vector<Vec3>> faces;  // corners of each mesh face; empty when not known
};
FoldedShape folded_shape(const Mesh& mesh);

// The wanted size; at most one of the four is given, the others are NaN.
struct SizeOptions {
  double height = std::numeric_limits<double>::quiet_NaN();   // millimetres, along the up axis
  double width = std::numeric_limits<double>::quiet_NaN();    // millimetres, along x
  double longest = std::numeric_limits<double>::quiet_NaN();  // millimetres, the longest side of the bounding box
  double scale = std::numeric_limits<double>::quiet_NaN();    // millimetres per unit
  char up = 'y';                                              // the axis of the height: 'y' or 'z'
  // None given: as large as fits, every part on one page; or, when false, a net unit is a millimetre.
  bool fill_page = false;
  bool is_given() const;
};

// Millimetres per net unit. Throws InvalidOption when two sizes are given, one is not positive, or the model has no
// extent along the axis.
double scale_of(const FoldedShape& shape, const SizeOptions& options);

}  // namespace plico
