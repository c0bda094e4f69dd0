// The sides of all faces, brought together at the edges: for polygons that need not make a surface.
#pragma once
#include <span>
#include <vector>

#include "plico/mesh/soup.h"

namespace plico {

struct FaceSide {
  int low, high;  // the edge's vertices, low < high
  int face;
  int corner;    // where the side starts, index into soup.corners
  int next;      // where it ends
  bool forward;  // runs from low to high
};

// The sides of the faces with include[face] != 0, sorted so that the sides of one edge are neighbours, in face order.
class FaceSides {
 public:
  FaceSides(const PolygonSoup& soup, const std::vector<char>& include);

  // Calls visit(sides of one edge) for every edge.
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t end = i + 1;
      while (end < sides_.size() && sides_[end].low == sides_[i].low && sides_[end].high == sides_[i].high) ++end;
      visit(std::span<const FaceSide>(sides_.data() + i, end - i));
      i = end;
    }
  }

 private:
  std::vector<FaceSide> sides_;
};

}  // namespace plico
