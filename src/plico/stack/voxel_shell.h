// The outside of a solid made of voxels: unit squares, each joined to four others. Source: [Xi17] 6.3.1, read as R13.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "plico/base/vec.h"
#include "plico/mesh/soup.h"

namespace plico {

// The six directions of the grid: +x, -x, +y, -y, +z, -z.
enum class Axis : std::uint8_t { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ };
constexpr Axis opposite(Axis a) { return static_cast<Axis>(static_cast<int>(a) ^ 1); }

struct Voxel {
  int x = 0, y = 0, z = 0;
  bool operator==(const Voxel&) const = default;
  auto operator<=>(const Voxel&) const = default;
};
Voxel beside(const Voxel& voxel, Axis direction);

// Voxels of a box, solid or not. Outside of the box everything is empty.
class VoxelGrid {
 public:
  VoxelGrid() = default;
  VoxelGrid(int nx, int ny, int nz);  // all empty; throws InvalidOption beyond kMostVoxels

  static constexpr long kMostVoxels = 2'000'000'000;

  int nx() const { return nx_; }
  int ny() const { return ny_; }
  int nz() const { return nz_; }
  bool solid(const Voxel& v) const { return inside(v) && solid_[index(v)]; }
  void fill(const Voxel& v) { solid_[index(v)] = 1; }  // `v` must be in the box
  long count() const;

  // Fills everything that cannot be reached from outside through faces of empty voxels. O(voxels).
  void fill_enclosed();

 private:
  bool inside(const Voxel& v) const { return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < nx_ && v.y < ny_ && v.z < nz_; }
  std::size_t index(const Voxel& v) const { return (static_cast<std::size_t>(v.z) * ny_ + v.y) * nx_ + v.x; }

  int nx_ = 0, ny_ = 0, nz_ = 0;
  std::vector<char> solid_;
};

// Where four squares meet in an edge, two pairs of them are joined: those of the same solid voxel, or those of the same
// empty voxel. Either way the shell stays a manifold (R13).
enum class Pairing { Solid, Empty };

// One square: the face of a solid voxel on the side of `normal`. Its sides are numbered counter-clockwise, seen from
// outside.
struct ShellSquare {
  Voxel voxel;
  Axis normal = Axis::PlusX;
  std::array<int, 4> neighbor{};              // the square beyond each side
  std::array<std::uint8_t, 4> entry{};        // and its own number of that side
  std::array<std::int8_t, 4> quarter_turn{};  // fold angle there, in quarter turns: -1 convex (mountain), 0, 1 concave
};

struct VoxelShell {
  std::vector<ShellSquare> squares;  // in the order of voxels (z, y, x) and normals
  int edges_with_four = 0;           // where the pairing decided

  int size() const { return static_cast<int>(squares.size()); }
};

// The direction in which side 0, 1, 2, 3 of a square with this normal lies.
std::array<Axis, 4> sides_of(Axis normal);

// Its corners in grid coordinates (voxel v spans [v, v + 1]), counter-clockwise seen from outside; side i runs from
// corner i to corner i + 1.
std::array<Vec3, 4> corners_of(const ShellSquare& square);

// The boundary between solid and empty. O(voxels).
VoxelShell shell_of(const VoxelGrid& grid, Pairing pairing = Pairing::Solid);

// The connected pieces of a shell as shells of their own, the largest first (ties: the first square). O(squares).
std::vector<VoxelShell> pieces_of(const VoxelShell& shell);

// The squares as a surface: corners that turn about the same vertex are one point, so that the surface is a manifold
// also where four squares meet. Voxel (x, y, z) begins at origin + side * (x, y, z). O(squares).
PolygonSoup surface_of(const VoxelShell& shell, const Vec3& origin = Vec3::Zero(), double side = 1);

}  // namespace plico
