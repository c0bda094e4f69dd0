// The panels of an unfolding side by side: which edge each side lies on, and the walk around each part.
#pragma once
#include <vector>

#include "plico/fold/unfolding.h"

namespace plico {

// A side of a panel: from corner `side` to the next one, counter-clockwise, so the panel is on its left.
struct PanelSide {
  int panel = -1, side = -1;
};

class NetSides {
 public:
  // Throws InvalidInput when a panel has a side that is no edge, or an edge has three panels.
  explicit NetSides(const Unfolding& net);

  int edge(int panel, int side) const { return side_edge_[panel][side]; }
  const std::vector<int>& edges(int panel) const { return side_edge_[panel]; }
  // One side of the edge: the only one on the boundary, the first panel's otherwise; the other one is second_side.
  PanelSide side(int edge) const { return first_[edge]; }
  PanelSide second_side(int edge) const { return second_[edge]; }
  bool is_fold(int edge) const { return second_[edge].panel >= 0; }
  int part(int edge) const { return net_.part[first_[edge].panel]; }
  Vec2 from(PanelSide s) const { return corner(s.panel, s.side); }
  Vec2 to(PanelSide s) const { return corner(s.panel, s.side + 1); }
  const Unfolding& net() const { return net_; }

  // The boundary of each part as closed walks of boundary edges, the part on the left; one walk for a net that is a
  // disk. Walks start at their lowest edge and are ordered by it.
  std::vector<std::vector<std::vector<int>>> outlines() const;

 private:
  Vec2 corner(int panel, int i) const {
    const auto& face = net_.sheet.faces[panel];
    return net_.sheet.vertices[face[i % face.size()]];
  }
  PanelSide next_on_boundary(PanelSide s) const;

  const Unfolding& net_;
  std::vector<std::vector<int>> side_edge_;
  std::vector<PanelSide> first_, second_;
};

// The same net with some more folds cut: their two sides become mates, and a part may fall into several, numbered by
// their first panel. Panels and edges keep their numbers and places, second sides of new cuts are appended; a new cut
// keeps the fold angle, as that of its seam. O(n).
Unfolding cut_folds(const Unfolding& net, const std::vector<char>& is_cut);

}  // namespace plico
