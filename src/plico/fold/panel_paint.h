// How the panels of a net look: what is printed on their outside.
#pragma once
#include <vector>

#include "plico/base/picture.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/paint.h"

namespace plico {

// A piece of a panel of one colour, or with one picture laid straight over it. In the panel's own plane: its first
// corner at the origin, its first side along +x.
struct Patch {
  std::vector<Vec2> corners;                                                // counter-clockwise, in the unit of the net
  Color color = kWhite;                                                     // tints the picture when there is one
  int picture = -1;                                                         // -1 for none
  Eigen::Matrix<double, 2, 3> to_uv = Eigen::Matrix<double, 2, 3>::Zero();  // (u, v) = to_uv * (x, y, 1)

  Vec2 uv_at(const Vec2& p) const { return to_uv.leftCols<2>() * p + to_uv.col(2); }
};

struct PanelPaint {
  std::vector<std::vector<Patch>> panels;  // one entry a panel; empty when nothing is painted
  std::vector<Picture> pictures;

  bool empty() const { return panels.empty(); }
};

// What each panel of the net of a mesh takes from the paint on its surface.
//   - Where painted triangles cover the panel, their pieces are its patches, exactly; a panel of one colour is one
//   patch.
//   - Where they do not (the shape was simplified, or colours run into each other), the panel gets a small picture of
//   its
//     own: every point has the look of the nearest point of the paint, rather of one that faces the same way.
// Empty without paint. O((panels + triangles) log triangles + pixels).
PanelPaint panel_paint(const Mesh& mesh, const Unfolding& net, const Paint& paint);

// Panels of one colour each; empty without colours.
PanelPaint plain_paint(const CreasePattern& sheet, const std::vector<Color>& colors);

// The mean colour of each panel: what programs show that know one colour a face.
std::vector<Color> panel_colors(const PanelPaint& paint);

}  // namespace plico
