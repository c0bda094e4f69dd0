// Convex pieces of the plane in a grid, and exact questions about them.
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

// Does the convex `shape` lie in the polygon, touching allowed? The polygon is simple and counter-clockwise. Exact.
bool contains(std::span<const Vec2> polygon, std::span<const Vec2> shape);

// Convex counter-clockwise pieces, each owned by some item (a panel, a tab), found by place.
class PieceGrid {
 public:
  explicit PieceGrid(double cell) : cell_(cell) {}

  void add(std::vector<Vec2> convex, int group = 0);
  // Does `shape`, convex and counter-clockwise, share an interior point with a piece of this group? Exact.
  bool overlaps(std::span<const Vec2> shape, int group = 0) const;

 private:
  struct Piece {
    std::vector<Vec2> corners;
    Eigen::AlignedBox2d box;
    int group;
  };
  template <class Visit>
  void each_cell(const Eigen::AlignedBox2d& box, int group, Visit visit) const;

  double cell_;
  std::vector<Piece> pieces_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

}  // namespace plico
