#include "plico/workflow/shell_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "plico/base/error.h"
#include "plico/io/text/json_text.h"
#include "plico/io/text/parse_json.h"

namespace plico {
namespace {

using nlohmann::json;

constexpr char kShellKey[] = "plico:shell";
constexpr double kOffLattice = 1e-6;  // sides
constexpr double kMostSides = 1e6;    // from the first corner: what is farther has no room in a grid

using Node = std::array<long, 3>;  // of the lattice; of edges and squares twice their middle

class ShellFileReader {
 public:
  ShellFileReader(std::string_view bytes, std::string name) : name_(std::move(name)) {
    const json file = parse_json(bytes, name_, "shell");
    read_points(file);
    read_faces(file);
    if (const auto at = file.find(kShellKey); at != file.end() && at->is_object())
      pair_ = at->value("pair", std::string());
  }

  VoxelPieces build(int refine, Pairing otherwise) {
    find_lattice();
    for (std::size_t f = 0; f < faces_.size(); ++f) squares_.push_back(square_of(static_cast<int>(f)));
    check_neighbours();
    return solid_of(refine, pair_ == "empty" ? Pairing::Empty : pair_ == "solid" ? Pairing::Solid : otherwise);
  }

 private:
  [[noreturn]] void fail(const char* code, const std::string& message, int face = -1) const {
    throw InvalidInput(code, message, face < 0 ? name_ : fmt::format("{}: face {}", name_, face),
                       "plico voxelize MESH --cells 25 -o shell.fold");
  }

  static const json* list_in(const json& file, const char* key) {
    if (!file.is_object()) return nullptr;
    const auto at = file.find(key);
    return at != file.end() && at->is_array() && !at->empty() ? &*at : nullptr;
  }

  void read_points(const json& file) {
    const json* list = list_in(file, "vertices_coords");
    if (list == nullptr) fail("shell/no-squares", "there are no vertices_coords; a shell has points in space");
    for (const json& row : *list) {
      const bool in_space =
          row.is_array() && row.size() == 3 && row[0].is_number() && row[1].is_number() && row[2].is_number();
      if (!in_space)
        fail("shell/flat", fmt::format("vertices_coords[{}] is {}; a shell has three numbers there", points_.size(),
                                       row.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 40)));
      points_.emplace_back(row[0].get<double>(), row[1].get<double>(), row[2].get<double>());
    }
  }

  void read_faces(const json& file) {
    const json* list = list_in(file, "faces_vertices");
    if (list == nullptr) fail("shell/no-squares", "there are no faces_vertices; a shell has squares");
    for (const json& row : *list) {
      const int face = static_cast<int>(faces_.size());
      if (!row.is_array() || row.size() != 4)
        fail("shell/no-square", fmt::format("a face has {} corners, must be a square", row.size()), face);
      std::array<int, 4> corners{};
      for (int i = 0; i < 4; ++i) {
        const bool there = row[i].is_number_integer() && row[i].get<long>() >= 0 &&
                           row[i].get<long>() < static_cast<long>(points_.size());
        if (!there)
          fail("shell/no-square", fmt::format("corner {} is none of the {} vertices", i, points_.size()), face);
        corners[i] = row[i].get<int>();
      }
      faces_.push_back(corners);
    }
  }

  void find_lattice() {
    origin_ = points_[faces_[0][0]];
    side_ = (points_[faces_[0][1]] - origin_).norm();
    if (!(side_ > 0 && side_ <= 1e30)) fail("shell/no-square", fmt::format("a side is {} long", side_), 0);
  }

  Node node_of(int face, int corner) const {
    const Vec3 at = (points_[faces_[face][corner]] - origin_) / side_;
    Node node{};
    for (int i = 0; i < 3; ++i) {
      if (!(std::abs(at[i]) < kMostSides)) fail("shell/off-lattice", "a corner is too far from those of face 0", face);
      node[i] = std::lround(at[i]);
      if (std::abs(at[i] - static_cast<double>(node[i])) > kOffLattice)
        fail("shell/off-lattice",
             fmt::format("corner {} is {:.3g} sides off the grid of squares with sides {:.6g} that face 0 begins",
                         corner, std::abs(at[i] - static_cast<double>(node[i])), side_),
             face);
    }
    return node;
  }

  // The solid voxel behind a face, and the side on which the face is.
  ShellSquare square_of(int face) const {
    std::array<Node, 4> c{};
    for (int i = 0; i < 4; ++i) c[i] = node_of(face, i);
    Node along{}, across{}, back{};
    for (int i = 0; i < 3; ++i) {
      along[i] = c[1][i] - c[0][i];
      across[i] = c[3][i] - c[0][i];
      back[i] = c[2][i] - c[1][i];
    }
    const auto length = [](const Node& n) { return std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]); };
    const Node normal{along[1] * across[2] - along[2] * across[1], along[2] * across[0] - along[0] * across[2],
                      along[0] * across[1] - along[1] * across[0]};
    if (length(along) != 1 || length(across) != 1 || length(normal) != 1 || back != across)
      fail("shell/no-square", fmt::format("a face is no square with sides {:.6g} along the axes", side_), face);
    ShellSquare square;
    Node low = c[0];
    int axis = 0;
    for (int i = 0; i < 3; ++i) {
      for (const Node& corner : c) low[i] = std::min(low[i], corner[i]);
      if (normal[i] != 0) axis = i;
    }
    square.normal = static_cast<Axis>(2 * axis + (normal[axis] < 0));
    if (normal[axis] > 0) --low[axis];
    square.voxel = {static_cast<int>(low[0]), static_cast<int>(low[1]), static_cast<int>(low[2])};
    return square;
  }

  // A square lies beside another over each of its sides: there are two, or four that are joined in pairs.
  void check_neighbours() const {
    std::map<std::pair<Voxel, Axis>, int> known;
    std::map<Node, int> sides;
    std::vector<std::array<Node, 4>> sides_of_face;
    for (std::size_t f = 0; f < squares_.size(); ++f) {
      const auto [at, fresh] = known.try_emplace({squares_[f].voxel, squares_[f].normal}, static_cast<int>(f));
      if (!fresh) fail("shell/square-twice", fmt::format("it is the same square as face {}", at->second), f);
      std::array<Node, 4>& around = sides_of_face.emplace_back();
      for (int i = 0; i < 4; ++i) {
        const Node a = node_of(static_cast<int>(f), i), b = node_of(static_cast<int>(f), (i + 1) % 4);
        ++sides[around[i] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]}];
      }
    }
    for (std::size_t f = 0; f < squares_.size(); ++f) {
      const auto joined = std::ranges::count_if(sides_of_face[f], [&](const Node& s) { return sides[s] % 2 == 0; });
      if (joined != 4)
        fail("shell/open", fmt::format("a square has neighbours over {} of its sides, must have 4", joined), f);
    }
  }

  VoxelPieces solid_of(int refine, Pairing pairing) const {
    Voxel low = squares_[0].voxel, high = low;
    for (const ShellSquare& square : squares_) {
      const Voxel& v = square.voxel;
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    VoxelPieces all;
    all.pairing = pairing;
    all.solid.grid = VoxelGrid(high.x - low.x + 1, high.y - low.y + 1, high.z - low.z + 1);
    for (const ShellSquare& square : squares_)
      all.solid.grid.fill({square.voxel.x - low.x, square.voxel.y - low.y, square.voxel.z - low.z});
    all.solid.grid.fill_enclosed();
    all.solid.touched = all.solid.filled = all.solid.grid.count();
    all.solid.side = side_;
    all.solid.origin = origin_ + side_ * Vec3(low.x, low.y, low.z);
    const int outside = shell_of(all.solid.grid, pairing).size();
    if (outside != static_cast<int>(squares_.size()))
      fail("shell/no-solid", fmt::format("what lies behind the {} squares is a solid with {}; do all look outwards?",
                                         squares_.size(), outside));
    refine_voxels(all.solid, refine);
    all.pieces = pieces_of(shell_of(all.solid.grid, pairing));
    return all;
  }

  std::string name_, pair_;
  std::vector<Vec3> points_;
  std::vector<std::array<int, 4>> faces_;
  Vec3 origin_ = Vec3::Zero();
  double side_ = 1;
  std::vector<ShellSquare> squares_;  // without neighbours
};

}  // namespace

std::string write_shell_file(const VoxelMesh& voxels, const std::string& report) {
  const PolygonSoup surface = surface_of(voxels.shell, voxels.solid.origin, voxels.solid.side);
  std::vector<int> faces(surface.num_faces());
  for (int f = 0; f < surface.num_faces(); ++f) faces[f] = f;
  JsonText text;
  text.open();
  text.key("file_spec");
  text.raw("1.2");
  text.key("file_creator");
  text.raw("\"plico\"");
  text.key("frame_classes");
  text.raw("[\"foldedForm\"]");
  text.key("frame_attributes");
  text.raw("[\"3D\",\"manifold\",\"orientable\"]");
  text.key("vertices_coords");
  text.list(surface.points, [&](const Vec3& p) { text.point(p); });
  text.key("faces_vertices");
  text.list(faces, [&](int f) {
    text.raw("[");
    for (int i = 0; i < 4; ++i) {
      if (i > 0) text.raw(",");
      text.integer(surface.face(f)[i]);
    }
    text.raw("]");
  });
  text.key(kShellKey);
  text.raw(voxels.pairing == Pairing::Solid ? "{\"pair\":\"solid\"}" : "{\"pair\":\"empty\"}");
  if (!report.empty()) {
    text.key("plico:report");
    text.raw(report);
  }
  text.close();
  return text.take() + "\n";
}

bool is_shell_file(std::string_view bytes, const std::string& name) {
  if (name.ends_with(".fold")) return true;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return name == "-" && first != std::string_view::npos && bytes[first] == '{' &&
         bytes.find("\"faces_vertices\"") != std::string_view::npos;
}

VoxelPieces read_shell_file(std::string_view bytes, const std::string& name, int refine, Pairing pairing) {
  return ShellFileReader(bytes, name).build(refine, pairing);
}

}  // namespace plico
