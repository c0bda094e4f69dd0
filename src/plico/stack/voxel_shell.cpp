#include "plico/stack/voxel_shell.h"

#include <algorithm>
#include <numeric>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr std::array<std::array<int, 3>, 6> kSteps{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
constexpr std::array<Axis, 6> kAxes{Axis::PlusX, Axis::MinusX, Axis::PlusY, Axis::MinusY, Axis::PlusZ, Axis::MinusZ};

Vec3 vector_of(Axis a) {
  const auto& step = kSteps[static_cast<int>(a)];
  return {static_cast<double>(step[0]), static_cast<double>(step[1]), static_cast<double>(step[2])};
}

std::uint8_t side_towards(Axis normal, Axis direction) {
  const std::array<Axis, 4> sides = sides_of(normal);
  return static_cast<std::uint8_t>(std::find(sides.begin(), sides.end(), direction) - sides.begin());
}

// Numbers the squares of a grid and finds what lies beyond their sides.
class ShellBuilder {
 public:
  ShellBuilder(const VoxelGrid& grid, Pairing pairing) : grid_(grid), pairing_(pairing) {}

  VoxelShell run() {
    collect_squares();
    for (ShellSquare& square : shell_.squares)
      for (int side = 0; side < 4; ++side) join(square, side);
    shell_.edges_with_four /= 4;  // met from each of its squares
    return std::move(shell_);
  }

 private:
  std::size_t key(const Voxel& v, Axis normal) const {
    return ((static_cast<std::size_t>(v.z) * grid_.ny() + v.y) * grid_.nx() + v.x) * 6 + static_cast<int>(normal);
  }

  void collect_squares() {
    for (int z = 0; z < grid_.nz(); ++z)
      for (int y = 0; y < grid_.ny(); ++y)
        for (int x = 0; x < grid_.nx(); ++x) {
          const Voxel v{x, y, z};
          if (!grid_.solid(v)) continue;
          for (Axis normal : kAxes)
            if (!grid_.solid(beside(v, normal))) add(v, normal);
        }
  }

  void add(const Voxel& v, Axis normal) {
    keys_.push_back(key(v, normal));
    shell_.squares.push_back({.voxel = v, .normal = normal});
  }

  // Beyond a side lies the next square of a flat face, a square of the same voxel around a convex edge, or one that
  // rises from a concave edge.
  void join(ShellSquare& square, int side) {
    const Axis direction = sides_of(square.normal)[side];
    const Voxel across = beside(square.voxel, direction), above = beside(across, square.normal);
    const bool rises = grid_.solid(above);
    if (grid_.solid(across))
      return rises ? join_concave(square, side, above, direction) : join_flat(square, side, across, direction);
    if (rises) ++shell_.edges_with_four;
    if (rises && pairing_ == Pairing::Empty) return join_concave(square, side, above, direction);
    link(square, side, square.voxel, direction, square.normal, -1);
  }

  void join_flat(ShellSquare& square, int side, const Voxel& across, Axis direction) {
    link(square, side, across, square.normal, opposite(direction), 0);
  }
  void join_concave(ShellSquare& square, int side, const Voxel& above, Axis direction) {
    link(square, side, above, opposite(direction), opposite(square.normal), 1);
  }

  void link(ShellSquare& square, int side, const Voxel& voxel, Axis normal, Axis towards, int quarter_turn) {
    // Keys ascend in the order of the squares.
    square.neighbor[side] =
        static_cast<int>(std::lower_bound(keys_.begin(), keys_.end(), key(voxel, normal)) - keys_.begin());
    square.entry[side] = side_towards(normal, towards);
    square.quarter_turn[side] = static_cast<std::int8_t>(quarter_turn);
  }

  const VoxelGrid& grid_;
  Pairing pairing_;
  VoxelShell shell_;
  std::vector<std::size_t> keys_;
};

}  // namespace

Voxel beside(const Voxel& voxel, Axis direction) {
  const auto& step = kSteps[static_cast<int>(direction)];
  return {voxel.x + step[0], voxel.y + step[1], voxel.z + step[2]};
}

VoxelGrid::VoxelGrid(int nx, int ny, int nz) : nx_(nx), ny_(ny), nz_(nz) {
  const double voxels = static_cast<double>(nx) * ny * nz;
  if (nx < 1 || ny < 1 || nz < 1 || voxels > static_cast<double>(kMostVoxels))
    throw InvalidOption(
        fmt::format(
            "a grid of {} x {} x {} voxels takes {:.3g} GB of memory, must be at most {:.3g} (one byte a voxel)", nx,
            ny, nz, voxels / 1e9, static_cast<double>(kMostVoxels) / 1e9),
        "--cells 100");
  solid_.assign(static_cast<std::size_t>(voxels), 0);
}

long VoxelGrid::count() const { return std::count(solid_.begin(), solid_.end(), 1); }

// Floods the outside row by row: a run of empty voxels is entered at one of them, and every run beside it once.
void VoxelGrid::fill_enclosed() {
  constexpr char kOutside = 2;
  std::vector<Voxel> open;
  const auto enter_runs = [&](int first, int last, int y, int z) {
    if (y < 0 || z < 0 || y >= ny_ || z >= nz_) return;
    const char* row = &solid_[index({0, y, z})];
    for (int x = first; x <= last; ++x)
      if (row[x] == 0 && (x == last || row[x + 1] != 0)) open.push_back({x, y, z});
  };
  const auto flood = [&] {
    while (!open.empty()) {
      const Voxel v = open.back();
      open.pop_back();
      char* row = &solid_[index({0, v.y, v.z})];
      if (row[v.x] != 0) continue;
      int first = v.x, last = v.x;
      while (first > 0 && row[first - 1] == 0) --first;
      while (last + 1 < nx_ && row[last + 1] == 0) ++last;
      std::fill(row + first, row + last + 1, kOutside);
      for (int side : {-1, 1}) {
        enter_runs(first, last, v.y + side, v.z);
        enter_runs(first, last, v.y, v.z + side);
      }
    }
  };
  for (int z = 0; z < nz_; ++z)
    for (int y = 0; y < ny_; ++y) {
      if (y == 0 || z == 0 || y == ny_ - 1 || z == nz_ - 1) enter_runs(0, nx_ - 1, y, z);
      if (!solid_[index({0, y, z})]) open.push_back({0, y, z});
      if (!solid_[index({nx_ - 1, y, z})]) open.push_back({nx_ - 1, y, z});
      flood();
    }
  for (char& state : solid_) state = state == kOutside ? 0 : 1;
}

std::array<Axis, 4> sides_of(Axis normal) {
  switch (normal) {
    case Axis::PlusX:
      return {Axis::PlusY, Axis::PlusZ, Axis::MinusY, Axis::MinusZ};
    case Axis::MinusX:
      return {Axis::PlusZ, Axis::PlusY, Axis::MinusZ, Axis::MinusY};
    case Axis::PlusY:
      return {Axis::PlusZ, Axis::PlusX, Axis::MinusZ, Axis::MinusX};
    case Axis::MinusY:
      return {Axis::PlusX, Axis::PlusZ, Axis::MinusX, Axis::MinusZ};
    case Axis::PlusZ:
      return {Axis::PlusX, Axis::PlusY, Axis::MinusX, Axis::MinusY};
    case Axis::MinusZ:
      break;
  }
  return {Axis::PlusY, Axis::PlusX, Axis::MinusY, Axis::MinusX};
}

std::array<Vec3, 4> corners_of(const ShellSquare& square) {
  const std::array<Axis, 4> sides = sides_of(square.normal);
  const Vec3 middle = Vec3(square.voxel.x, square.voxel.y, square.voxel.z) + Vec3::Constant(0.5);
  const Vec3 centre = middle + 0.5 * vector_of(square.normal);
  std::array<Vec3, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = centre + 0.5 * (vector_of(sides[i]) - vector_of(sides[(i + 1) % 4]));
  return corners;
}

VoxelGrid refined(const VoxelGrid& grid, int factor) {
  const long most = VoxelGrid::kMostVoxels / std::max({1, grid.nx(), grid.ny(), grid.nz()});
  require(factor >= 1 && factor <= most, "refine", factor, fmt::format("in [1, {}]", most));
  VoxelGrid fine(grid.nx() * factor, grid.ny() * factor, grid.nz() * factor);
  for (int z = 0; z < fine.nz(); ++z)
    for (int y = 0; y < fine.ny(); ++y)
      for (int x = 0; x < fine.nx(); ++x)
        if (grid.solid({x / factor, y / factor, z / factor})) fine.fill({x, y, z});
  return fine;
}

VoxelShell shell_of(const VoxelGrid& grid, Pairing pairing) { return ShellBuilder(grid, pairing).run(); }

std::vector<VoxelShell> pieces_of(const VoxelShell& shell) {
  std::vector<int> piece(shell.size(), -1), number(shell.size());
  std::vector<VoxelShell> pieces;
  for (int start = 0; start < shell.size(); ++start) {
    if (piece[start] >= 0) continue;
    std::vector<int> members{start};
    piece[start] = static_cast<int>(pieces.size());
    for (std::size_t i = 0; i < members.size(); ++i)
      for (int next : shell.squares[members[i]].neighbor)
        if (piece[next] < 0) piece[next] = piece[start], members.push_back(next);
    std::sort(members.begin(), members.end());
    for (std::size_t i = 0; i < members.size(); ++i) number[members[i]] = static_cast<int>(i);
    VoxelShell& own = pieces.emplace_back();
    for (int s : members) own.squares.push_back(shell.squares[s]);
    for (ShellSquare& square : own.squares)
      for (int& next : square.neighbor) next = number[next];
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const VoxelShell& a, const VoxelShell& b) { return a.size() > b.size(); });
  if (pieces.size() == 1) pieces.front().edges_with_four = shell.edges_with_four;
  return pieces;
}

PolygonSoup surface_of(const VoxelShell& shell, const Vec3& origin, double side) {
  // Corner i of a square is where its side i begins; across a side the neighbour's corners run the other way.
  std::vector<int> point(4 * shell.squares.size(), -1);
  PolygonSoup soup;
  for (int s = 0; s < shell.size(); ++s)
    for (int i = 0; i < 4; ++i) {
      if (point[4 * s + i] >= 0) continue;
      for (int at = s, corner = i; point[4 * at + corner] < 0;) {  // around the vertex
        point[4 * at + corner] = soup.num_points();
        const ShellSquare& square = shell.squares[at];
        at = square.neighbor[corner];
        corner = (square.entry[corner] + 1) % 4;
      }
      soup.points.push_back(origin + side * corners_of(shell.squares[s])[i]);
    }
  for (int s = 0; s < shell.size(); ++s)
    soup.add_face({point[4 * s], point[4 * s + 1], point[4 * s + 2], point[4 * s + 3]});
  return soup;
}

}  // namespace plico
