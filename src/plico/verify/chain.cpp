#include "plico/verify/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr double kExact = 1e-9;  // sides
constexpr double kLoose = 1e-6;  // sides: what is farther from a lattice is not in it

// Rounding of one pose after the other: a million of them were seen to add up to 8e-9 sides.
double most_rounding(int panels) { return std::max(kExact, 1e-13 * panels); }

using Cell = std::array<long, 3>;

void report(ChainVerdict& verdict, const char* code, const std::string& message) {
  for (const Defect& known : verdict.defects)
    if (known.code == code) return;
  verdict.defects.push_back({code, message});
}

// In half sides of a lattice; false when the point is not in it.
bool cell_of(const Vec3& point, double unit, Cell& cell) {
  for (int i = 0; i < 3; ++i) {
    cell[i] = std::lround(point[i] / unit);
    if (!(std::abs(point[i] / unit - static_cast<double>(cell[i])) < kLoose)) return false;
  }
  return true;
}

bool is_square(const std::vector<Vec2>& corners, double side) {
  if (corners.size() != 4) return false;
  for (int i = 0; i < 4; ++i) {
    const Vec2 a = corners[(i + 1) % 4] - corners[i], b = corners[(i + 2) % 4] - corners[(i + 1) % 4];
    if (!(std::abs(a.norm() - side) <= kExact * side && (b - perpendicular(a)).norm() <= kExact * side)) return false;
  }
  return true;
}

// Are these equal squares in a row?
bool check_strip(const ChainClaim& claim, const Linkage& linkage, ChainVerdict& verdict) {
  const CreasePattern& sheet = claim.sheet;
  for (int p = 0; p < sheet.num_faces(); ++p)
    if (!is_square(polygon(sheet, p), verdict.side))
      report(verdict, "chain/no-square", fmt::format("panel {} is no square of side {:.6g}", p, verdict.side));
  if (linkage.num_hinges() != sheet.num_faces() - 1)
    report(verdict, "chain/no-row", fmt::format("{} hinges join {} panels", linkage.num_hinges(), sheet.num_faces()));
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    const auto [low, high] = std::minmax(linkage.hinges[h].left, linkage.hinges[h].right);
    if (low != h || high != h + 1)
      report(verdict, "chain/no-row", fmt::format("hinge {} joins panels {} and {}", h, low, high));
  }
  if (static_cast<int>(claim.stack.size()) != linkage.num_hinges())
    report(verdict, "chain/stack-angles",
           fmt::format("{} stack angles for {} hinges", claim.stack.size(), linkage.num_hinges()));
  if (static_cast<int>(claim.shape.size()) != sheet.num_vertices())
    report(verdict, "chain/shape-points",
           fmt::format("{} points of the shape for {} vertices", claim.shape.size(), sheet.num_vertices()));
  return verdict.valid();
}

void check_shape(const ChainClaim& claim, const Linkage& linkage, ChainVerdict& verdict) {
  const Pose start = into_shape(claim);
  const std::vector<Pose> poses = folding_map(linkage, goal(linkage));
  for (int p = 0; p < verdict.panels; ++p)
    for (int v : claim.sheet.faces[p]) {
      const Vec3 flat(claim.sheet.vertices[v].x(), claim.sheet.vertices[v].y(), 0);
      const double error = (start * (poses[p] * flat) - claim.shape[v]).norm() / verdict.side;
      verdict.shape_error = std::max(verdict.shape_error, error);
      if (!(error <= most_rounding(verdict.panels)))
        report(verdict, "chain/other-shape",
               fmt::format("folding puts a corner of panel {} {:.3g} sides from where the shape has it", p, error));
    }
}

// Every square once, and every side beside another one: the shape is a closed surface of lattice squares.
void check_surface(const ChainClaim& claim, ChainVerdict& verdict) {
  const double half = verdict.side / 2;
  const Pose lattice = into_shape(claim).inverse();
  std::map<Cell, int> square_at, sides_at;
  const Vec3 origin = lattice * claim.shape[claim.sheet.faces[0][0]];
  for (int p = 0; p < verdict.panels; ++p) {
    Vec3 corner[4], centre = Vec3::Zero();
    for (int i = 0; i < 4; ++i) centre += (corner[i] = lattice * claim.shape[claim.sheet.faces[p][i]] - origin) / 4;
    Cell cell;
    if (!cell_of(centre, half, cell)) {
      report(verdict, "chain/off-lattice", fmt::format("square {} lies in no lattice with the first", p));
      return;
    }
    if (const auto [at, fresh] = square_at.emplace(cell, p); !fresh)
      report(verdict, "chain/square-twice", fmt::format("panels {} and {} are the same square", at->second, p));
    for (int i = 0; i < 4; ++i)
      if (cell_of((corner[i] + corner[(i + 1) % 4]) / 2, half, cell)) ++sides_at[cell];
  }
  const auto open = std::count_if(sides_at.begin(), sides_at.end(), [](const auto& s) { return s.second % 2 != 0; });
  if (open > 0) report(verdict, "chain/open", fmt::format("{} sides of squares have no square beside them", open));
}

void check_stack(const ChainClaim& claim, const Linkage& linkage, ChainVerdict& verdict) {
  const Configuration config = Eigen::Map<const Configuration>(claim.stack.data(), linkage.num_hinges());
  const std::vector<Pose> poses = folding_map(linkage, config);
  const Vec3 origin = (linkage.panels[0][0] + linkage.panels[0][2]) / 2;
  const Vec3 along = (linkage.panels[0][1] - linkage.panels[0][0]).normalized();
  std::map<Cell, int> panel_in;
  Cell low{}, high{};
  for (int p = 0; p < verdict.panels; ++p) {
    const Vec3 moved = poses[p] * Vec3((linkage.panels[p][0] + linkage.panels[p][2]) / 2) - origin;
    const Vec3 place(moved.dot(along), moved.dot(Vec3::UnitZ().cross(along)), moved.z());
    const Vec3 in_slots(place.x() / verdict.side, place.y() / verdict.side, place.z() / linkage.thickness);
    Cell slot;
    cell_of(in_slots, 1, slot);
    const Vec3 exact(slot[0] * verdict.side, slot[1] * verdict.side, slot[2] * linkage.thickness);
    const double tilt = 1 - std::abs(poses[p].linear()(2, 2));
    const double error = std::max((place - exact).norm() / verdict.side, tilt);
    verdict.stack_error = std::max(verdict.stack_error, error);
    if (!(error <= most_rounding(verdict.panels)))
      report(verdict, "chain/no-slot", fmt::format("panel {} lies {:.3g} sides off its slot in the stack", p, error));
    if (const auto [at, fresh] = panel_in.emplace(slot, p); !fresh)
      report(verdict, "chain/slot-twice",
             fmt::format("panels {} and {} lie in slot ({}, {}, {})", at->second, p, slot[0], slot[1], slot[2]));
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], slot[i]);
      high[i] = std::max(high[i], slot[i]);
    }
  }
  verdict.width = static_cast<int>(high[0] - low[0] + 1);
  verdict.depth = static_cast<int>(high[1] - low[1] + 1);
  verdict.height = static_cast<int>(high[2] - low[2] + 1);
}

void check_box(const ChainClaim& claim, ChainVerdict& verdict) {
  if ((verdict.width > verdict.depth) != (claim.width > claim.depth)) std::swap(verdict.width, verdict.depth);
  if (verdict.width != claim.width || verdict.depth != claim.depth || verdict.height != claim.height)
    report(verdict, "chain/other-box",
           fmt::format("the stack measures {} x {} x {} panels, claimed are {} x {} x {}", verdict.width, verdict.depth,
                       verdict.height, claim.width, claim.depth, claim.height));
  const long base = static_cast<long>(verdict.width) * verdict.depth;
  const double share = claim.thickness / verdict.side;
  verdict.ideal = static_cast<int>((verdict.panels + base - 1) / base);
  verdict.size_sum = verdict.width + verdict.depth + share * verdict.height;
  verdict.volume = static_cast<double>(base) * share * verdict.height;
}

}  // namespace

Pose into_shape(const ChainClaim& claim) {
  const std::vector<int>& face = claim.sheet.faces[0];
  const auto flat = [&](int i) {
    return Vec3(claim.sheet.vertices[face[i]].x(), claim.sheet.vertices[face[i]].y(), 0);
  };
  const double side = (flat(1) - flat(0)).norm();
  const auto frame = [&](const Vec3& origin, const Vec3& along, const Vec3& across) {
    Pose pose = Pose::Identity();
    const Vec3 x = (along - origin) / side, y = (across - origin) / side;
    pose.linear() << x, y, x.cross(y);
    pose.translation() = origin;
    return pose;
  };
  const Pose from = frame(flat(0), flat(1), flat(3));
  return frame(claim.shape[face[0]], claim.shape[face[1]], claim.shape[face[3]]) * from.inverse();
}

Linkage chain_linkage_of(const ChainClaim& claim) {
  return thick_hinged(make_linkage(claim.sheet, {}, 0), claim.thickness, claim.trim);
}

ChainVerdict verify_chain(const ChainClaim& claim) {
  ChainVerdict verdict;
  verdict.panels = claim.sheet.num_faces();
  if (verdict.panels == 0) {
    report(verdict, "chain/empty", "the chain has no panel");
    return verdict;
  }
  const std::vector<Vec2> first = polygon(claim.sheet, 0);
  verdict.side = (first[1] - first[0]).norm();
  if (!check_strip(claim, make_linkage(claim.sheet, {}, 0), verdict)) return verdict;
  try {
    const Linkage linkage = chain_linkage_of(claim);
    check_shape(claim, linkage, verdict);
    check_surface(claim, verdict);
    check_stack(claim, linkage, verdict);
  } catch (const InvalidOption& error) {
    report(verdict, "chain/thickness", error.what());
    return verdict;
  }
  check_box(claim, verdict);
  return verdict;
}

}  // namespace plico
