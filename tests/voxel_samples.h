// Small solids of voxels for tests, and where their squares are.
#pragma once
#include <vector>

#include "plico/stack/voxel_shell.h"

namespace plico {

inline VoxelGrid voxels(const std::vector<Voxel>& solid) {
  VoxelGrid grid(8, 8, 8);
  for (const Voxel& v : solid) grid.fill(v);
  return grid;
}

inline std::vector<ShellSquare> in_order(const VoxelShell& shell, const std::vector<int>& order) {
  std::vector<ShellSquare> squares;
  for (int s : order) squares.push_back(shell.squares[s]);
  return squares;
}

inline Vec3 middle_of(const ShellSquare& square) {
  const std::array<Vec3, 4> corners = corners_of(square);
  return (corners[0] + corners[2]) / 2;
}

inline Vec3 front_of(const ShellSquare& square) {
  const std::array<Vec3, 4> corners = corners_of(square);
  return (corners[1] - corners[0]).cross(corners[2] - corners[1]);
}

}  // namespace plico
