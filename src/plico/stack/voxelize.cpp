#include "plico/stack/voxelize.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plico/base/error.h"
#include "plico/mesh/triangulate.h"

namespace plico {
namespace {

constexpr double kMargin = 1e-6;  // of a voxel: sides of the surface's box lie inside the outermost voxels
constexpr int kBisections = 40;

using Corners = std::array<Vec3, 3>;

bool separates(const Vec3& axis, const Corners& t, const Vec3& half) {
  const double a = axis.dot(t[0]), b = axis.dot(t[1]), c = axis.dot(t[2]);
  const double reach = half.dot(axis.cwiseAbs());
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

// Whether a triangle and a closed box share a point: thirteen axes (Akenine-Möller 2001).
bool touches(Corners t, const Vec3& centre, const Vec3& half) {
  for (Vec3& corner : t) corner -= centre;
  for (int i = 0; i < 3; ++i)
    if (separates(Vec3::Unit(i), t, half)) return false;
  const Corners edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  if (separates(edges[0].cross(edges[1]), t, half)) return false;
  for (const Vec3& edge : edges)
    for (int i = 0; i < 3; ++i)
      if (separates(Vec3::Unit(i).cross(edge), t, half)) return false;
  return true;
}

// Fills the voxels that a triangle, in grid coordinates, touches: boxes of voxels are halved while they touch.
class TriangleFiller {
 public:
  explicit TriangleFiller(VoxelGrid& grid) : grid_(grid) {}

  void fill(const Corners& triangle) {
    Eigen::AlignedBox3d box;
    for (const Vec3& corner : triangle) box.extend(corner);
    const std::array<int, 3> size{grid_.nx(), grid_.ny(), grid_.nz()};
    Block block;
    for (int i = 0; i < 3; ++i) {
      block.low[i] = std::clamp(static_cast<int>(std::floor(box.min()[i])), 0, size[i] - 1);
      block.high[i] = std::clamp(static_cast<int>(std::floor(box.max()[i])), 0, size[i] - 1) + 1;
    }
    halve(triangle, block);
  }

 private:
  struct Block {
    std::array<int, 3> low{}, high{};  // voxels [low, high)
  };

  void halve(const Corners& triangle, const Block& block) {
    Vec3 low, high;
    int longest = 0;
    for (int i = 0; i < 3; ++i) {
      low[i] = block.low[i];
      high[i] = block.high[i];
      if (block.high[i] - block.low[i] > block.high[longest] - block.low[longest]) longest = i;
    }
    if (!touches(triangle, (low + high) / 2, (high - low) / 2)) return;
    const int extent = block.high[longest] - block.low[longest];
    if (extent == 1) return grid_.fill({block.low[0], block.low[1], block.low[2]});
    Block first = block, second = block;
    first.high[longest] = second.low[longest] = block.low[longest] + extent / 2;
    halve(triangle, first);
    halve(triangle, second);
  }

  VoxelGrid& grid_;
};

Eigen::AlignedBox3d box_of_corners(const PolygonSoup& soup) {
  Eigen::AlignedBox3d box;
  for (int v : soup.corners) {
    const Vec3& p = soup.points[v];
    if (!(p.array().abs() <= kMaxCoordinate).all())
      throw InvalidInput("mesh/not-finite",
                         fmt::format("a coordinate is {} {} {}, must be finite and at most 1e30", p.x(), p.y(), p.z()),
                         fmt::format("vertex {}", v), "plico check");
    box.extend(p);
  }
  return box;
}

}  // namespace

Voxelization voxelize(const PolygonSoup& soup, double cells) {
  require(cells >= 1 && cells <= 1e6, "cells", cells, "in [1, 1000000]");
  if (soup.num_faces() == 0) throw InvalidInput("mesh/empty", "there is no polygon to voxelize");
  const Eigen::AlignedBox3d box = box_of_corners(soup);
  const double longest = box.sizes().maxCoeff();
  if (!(longest > 0)) throw InvalidInput("mesh/empty", "all polygons lie in one point", {}, "plico check");
  Voxelization result;
  result.side = longest / cells * (1 + 2 * kMargin);
  std::array<int, 3> size{};
  for (int i = 0; i < 3; ++i)
    size[i] = std::max(1, static_cast<int>(std::ceil(box.sizes()[i] / result.side - kMargin)));
  result.grid = VoxelGrid(size[0], size[1], size[2]);
  result.origin = box.center() - result.side / 2 * Vec3(size[0], size[1], size[2]);
  TriangleFiller filler(result.grid);
  const auto in_grid = [&](int corner) -> Vec3 { return (soup.points[corner] - result.origin) / result.side; };
  for (int f = 0; f < soup.num_faces(); ++f)
    for (const auto& [a, b, c] : triangulate_face(soup, f)) filler.fill({in_grid(a), in_grid(b), in_grid(c)});
  result.touched = result.grid.count();
  result.grid.fill_enclosed();
  result.filled = result.grid.count();
  return result;
}

double cells_for_squares(const PolygonSoup& soup, int squares) {
  require(squares >= 6, "squares", squares, "at least 6");
  const auto count = [&](double cells) { return pieces_of(shell_of(voxelize(soup, cells).grid)).front().size(); };
  // The shell has about six squares a cell of a cube's side, and at least a few a cell of any side.
  double low = 1, high = std::max(2.0, std::sqrt(static_cast<double>(squares)));
  while (count(high) < squares) high *= 2;
  double best = low;
  int best_miss = std::numeric_limits<int>::max();
  for (int i = 0; i < kBisections && best_miss > 0; ++i) {
    const double cells = (low + high) / 2;
    const int found = count(cells);
    if (std::abs(found - squares) < best_miss) best = cells, best_miss = std::abs(found - squares);
    (found < squares ? low : high) = cells;
  }
  return best;
}

}  // namespace plico
