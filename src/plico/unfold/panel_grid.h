// A uniform grid of boxes in the plane, hashed, so that it has no borders: which panels may meet a box?
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "plico/unfold/flat_faces.h"

namespace plico {

class PanelGrid {
 public:
  // For about `panels` boxes of about `extent` units.
  PanelGrid(int panels, double extent);

  void insert(int panel, const Box2& box);
  void remove(int panel, const Box2& box);  // the box it was inserted with

  // Calls visit(panel) once for every panel whose box meets `box`, in no particular order, until it returns false.
  template <class Visit>
  void visit_meeting(const Box2& box, Visit&& visit) const {
    const Cells cells = cells_of(box);
    for (std::int32_t y = cells.y0; y <= cells.y1; ++y) {
      for (std::int32_t x = cells.x0; x <= cells.x1; ++x) {
        for (const Entry& entry : bucket_[slot(x, y)]) {
          if (entry.x != x || entry.y != y || !entry.box.meets(box)) continue;
          // A pair that shares several cells is met in the one that holds the lower corner of its boxes' common part.
          if (cell(std::max(entry.box.x0, box.x0)) != x || cell(std::max(entry.box.y0, box.y0)) != y) continue;
          if (!visit(entry.panel)) return;
        }
      }
    }
  }

 private:
  struct Cells {
    std::int32_t x0, y0, x1, y1;
  };
  struct Entry {  // a bucket may serve several cells
    int panel;
    std::int32_t x, y;
    Box2 box;
  };
  std::int32_t cell(double x) const { return static_cast<std::int32_t>(std::floor(x * per_unit_)); }
  Cells cells_of(const Box2& box) const { return {cell(box.x0), cell(box.y0), cell(box.x1), cell(box.y1)}; }
  std::size_t slot(std::int32_t x, std::int32_t y) const {
    const auto h =
        static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL;
    return static_cast<std::size_t>(h >> 32) & mask_;
  }

  double per_unit_;
  std::size_t mask_;
  std::vector<std::vector<Entry>> bucket_;
};

}  // namespace plico
