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
  // Boxes are kept in single precision, rounded outward: a few panels that just miss the box are visited, too.
  template <class Visit>
  void visit_meeting(const Box2& box, Visit&& visit) const {
    const FloatBox wanted(box);
    const Cells cells = cells_of(wanted);
    for (std::int32_t y = cells.y0; y <= cells.y1; ++y) {
      for (std::int32_t x = cells.x0; x <= cells.x1; ++x) {
        // A pair that shares several cells is met in the one that holds the lower corner of its boxes' common part.
        const std::uint32_t first = (x > cells.x0 ? kFirstColumn : 0) | (y > cells.y0 ? kFirstRow : 0);
        for (const Entry& entry : bucket_[slot(x, y)]) {
          if ((entry.tag & (kCell | first)) != (tag_of(x, y) | first) || !entry.box.meets(wanted)) continue;
          if (!visit(entry.panel)) return;
        }
      }
    }
  }

 private:
  struct FloatBox {
    float x0, y0, x1, y1;
    explicit FloatBox(const Box2& box) : x0(below(box.x0)), y0(below(box.y0)), x1(above(box.x1)), y1(above(box.y1)) {}
    bool meets(const FloatBox& o) const {  // as numbers: four tests without a branch
      return (int{x0 < o.x1} & int{o.x0 < x1} & int{y0 < o.y1} & int{o.y0 < y1}) != 0;
    }
    static constexpr float kRounding = 0x1p-23F;
    static float below(double x) { return static_cast<float>(x) - std::abs(static_cast<float>(x)) * kRounding; }
    static float above(double x) { return static_cast<float>(x) + std::abs(static_cast<float>(x)) * kRounding; }
  };
  struct Cells {
    std::int32_t x0, y0, x1, y1;
  };
  struct Entry {  // a bucket may serve several cells
    FloatBox box;
    int panel;
    std::uint32_t tag;  // of the cell; is it in the first column, the first row of its panel?
  };
  static constexpr std::uint32_t kFirstColumn = 1U << 31, kFirstRow = 1U << 30, kCell = kFirstRow - 1;
  // Cells of one bucket that share a tag are 32,768 cells apart.
  static std::uint32_t tag_of(std::int32_t x, std::int32_t y) {
    return (static_cast<std::uint32_t>(x) & 0x7fff) << 15 | (static_cast<std::uint32_t>(y) & 0x7fff);
  }
  std::int32_t cell(float x) const {
    const double cells = x * per_unit_;
    const auto toward_zero = static_cast<std::int32_t>(cells);
    return toward_zero - std::int32_t{cells < toward_zero};
  }
  Cells cells_of(const FloatBox& box) const { return {cell(box.x0), cell(box.y0), cell(box.x1), cell(box.y1)}; }
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
