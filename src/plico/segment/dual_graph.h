// The faces of a mesh as nodes and the edges between them as arcs, weighed for cutting: cheap where a seam is hidden.
#pragma once
#include <span>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

class DualGraph {
 public:
  struct Arc {
    int to = 0;           // face
    double cost = 0;      // of a seam here: length times seam_factor(fold angle, as a mesh of 2,000 faces has it)
    double length = 0;    // of the edge
    double distance = 0;  // between the centres of both faces, over the middle of the edge
  };

  explicit DualGraph(const Mesh& mesh);  // O(n)

  int num_faces() const { return static_cast<int>(area_.size()); }
  double area(int face) const { return area_[face]; }
  double total_area() const { return total_area_; }

  // No cut may part these neighbours: a seam there costs held_cost(), which is more than any that may be cut.
  void hold(int a, int b);
  double held_cost() const;

  // Makes seams cheaper where the thickness of the shape changes, and a little dearer where it does not: a limb may
  // begin without a valley. `thick` of every face (segment/thickness.h), 0 where it is not known: nothing changes
  // there, nor between faces that are held together.
  void discount(const std::vector<double>& thick);

  // The same faces, where every seam costs this share of its length besides.
  DualGraph with_length(double share) const;

  std::span<const Arc> arcs(int face) const {
    return {arcs_.data() + first_[face], static_cast<std::size_t>(first_[face + 1] - first_[face])};
  }

 private:
  std::vector<int> first_ = {0};
  std::vector<Arc> arcs_;
  std::vector<double> area_;
  double total_area_ = 0;
};

// What a unit of seam costs at this fold angle (valley > 0): 1 where it is flat, falling to 0.12 in valleys, where a
// seam is hidden and expected (the minima rule of Hoffman and Richards 1984), and to 0.75 on ridges.
double seam_factor(double fold_angle);

// Cost of the seam between `side` and the other faces of a part; both are marked by value in `mark`: faces of the part
// outside `side` have `rest`, those inside have `side`.
double cut_cost(const DualGraph& graph, std::span<const int> side_faces, const std::vector<int>& mark, int rest);

}  // namespace plico
