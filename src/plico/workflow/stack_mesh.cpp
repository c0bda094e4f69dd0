#include "plico/workflow/stack_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/stack/chain.h"

namespace plico {
namespace {

constexpr char kChainKey[] = "plico:chain";
constexpr double kPrintGap = 0.02;  // of the thickness

// The strip, vertex by vertex beside its place in the shape.
class StripBuilder {
 public:
  StripBuilder(const VoxelMesh& voxels, const Stack& stack, ChainClaim& claim)
      : voxels_(voxels), stack_(stack), claim_(claim), side_(voxels.solid.side) {}

  void build() {
    Vec2 centre = Vec2::Zero();
    std::vector<int> face(4, -1);
    const int n = static_cast<int>(stack_.path.size());
    for (int p = 0; p < n; ++p) {
      add_corners(p, centre, face);
      if (p + 1 == n) break;
      const int h = index(stack_.headings[p]);
      std::vector<int> next(4, -1);
      next[h] = face[(h + 1) & 3];
      next[(h + 3) & 3] = face[(h + 2) & 3];
      const double angle = shape_angle(p);
      claim_.sheet.edges.push_back({next[h], next[(h + 3) & 3], assignment_of(angle), angle});
      centre += side_ * Vec2(h == 0 ? 1 : h == 2 ? -1 : 0, h == 1 ? 1 : h == 3 ? -1 : 0);
      face = next;
    }
    add_borders();
  }

 private:
  const ShellSquare& square(int panel) const { return voxels_.shell.squares[stack_.path[panel]]; }
  int side_between(int panel, int other) const {
    const auto& around = square(panel).neighbor;
    return static_cast<int>(std::find(around.begin(), around.end(), stack_.path[other]) - around.begin());
  }
  double shape_angle(int hinge) const { return square(hinge).quarter_turn[side_between(hinge, hinge + 1)] * kPi / 2; }
  // Which corner of the square in the shape is corner 0 of the panel in the strip: East is the side behind corner 1.
  int first_corner(int panel) const {
    if (stack_.headings.empty()) return 0;
    const bool last = panel + 1 == static_cast<int>(stack_.path.size());
    const int side = side_between(panel, last ? panel - 1 : panel + 1);
    const int heading = index(last ? opposite(stack_.headings[panel - 1]) : stack_.headings[panel]);
    return (side - heading - 1) & 3;
  }
  void add_corners(int panel, const Vec2& centre, std::vector<int>& face) {
    const std::array<Vec3, 4> corners = corners_of(square(panel));
    const int first = first_corner(panel);
    for (int i = 0; i < 4; ++i) {
      if (face[i] >= 0) continue;
      face[i] = claim_.sheet.num_vertices();
      claim_.sheet.vertices.push_back(centre + side_ / 2 * Vec2(i == 1 || i == 2 ? 1 : -1, i >= 2 ? 1 : -1));
      claim_.shape.push_back(voxels_.solid.origin + side_ * corners[(first + i) & 3]);
    }
    claim_.sheet.faces.push_back(face);
  }
  void add_borders() {
    const int n = claim_.sheet.num_faces();
    for (int p = 0; p < n; ++p)
      for (int i = 0; i < 4; ++i) {
        const bool to_next = p + 1 < n && i == ((index(stack_.headings[p]) + 1) & 3);
        const bool to_last = p > 0 && i == ((index(stack_.headings[p - 1]) + 3) & 3);
        const std::vector<int>& face = claim_.sheet.faces[p];
        if (!to_next && !to_last) claim_.sheet.edges.push_back({face[i], face[(i + 1) & 3], Assignment::Boundary, 0});
      }
  }

  const VoxelMesh& voxels_;
  const Stack& stack_;
  ChainClaim& claim_;
  double side_;
};

ChainClaim claim_of(const VoxelMesh& voxels, const Stack& stack, const StackMeshOptions& options) {
  ChainClaim claim;
  StripBuilder(voxels, stack, claim).build();
  claim.thickness = options.thickness * voxels.solid.side;
  claim.trim = options.trim > 0 ? options.trim * voxels.solid.side : claim.thickness;
  claim.stack = fold_angles(stack.folds);
  claim.width = stack.box.width;
  claim.depth = stack.box.depth;
  claim.height = stack.box.height;
  return claim;
}

// W + D + H of the voxels, in sides.
double shape_size(const VoxelShell& shell) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const ShellSquare& square : shell.squares)
    for (const Vec3& corner : corners_of(square)) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  return (high - low).sum();
}

// A walk that ends beside its start may be cut anywhere.
bool is_closed(const SquareGraph& graph, const std::vector<int>& walk) {
  return std::ranges::count(graph.neighbours[walk.front()], walk.back()) > 0;
}

PolygonSoup box_around_origin(const Vec3& half) {
  PolygonSoup box;
  for (double z : {-half.z(), half.z()})
    box.points.insert(
        box.points.end(),
        {{-half.x(), -half.y(), z}, {half.x(), -half.y(), z}, {half.x(), half.y(), z}, {-half.x(), half.y(), z}});
  box.add_face({3, 2, 1, 0});
  box.add_face({4, 5, 6, 7});
  for (int i = 0; i < 4; ++i) box.add_face({i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i});
  return box;
}

}  // namespace

void check(const StackMeshOptions& options) {
  const double t = options.thickness;
  require(t > 0 && t < 0.5, "thickness", t, "above 0 and below 0.5 voxel sides");
  require(options.trim == 0 || (options.trim >= t / 2 && options.trim <= t), "trim", options.trim,
          fmt::format("in [thickness / 2, thickness] = [{:.6g}, {:.6g}] voxel sides", t / 2, t));
}

StackedChain stacked_chain(const VoxelMesh& voxels, CompactResult found, const StackMeshOptions& options) {
  StackedChain chain;
  chain.found = std::move(found);
  chain.claim = claim_of(voxels, chain.found.best, options);
  chain.verdict = verify_chain(chain.claim);
  chain.compactness = chain.verdict.size_sum / shape_size(voxels.shell);
  chain.volume_ratio = chain.verdict.volume / static_cast<double>(voxels.solid.grid.count());
  chain.slots_per_panel =
      static_cast<double>(chain.found.best.box.slots()) / static_cast<double>(chain.found.best.path.size());
  return chain;
}

StackedChain stack_voxels(const VoxelMesh& voxels, const std::vector<int>& cycle, const StackMeshOptions& options,
                          const Run& run) {
  check(options);
  const SquareGraph graph = graph_of(voxels.shell);
  const StackBox base =
      options.width > 0 ? StackBox{options.width, options.depth, 0} : best_base(graph.size(), options.thickness);
  const CompactOptions how{.seed = options.seed,
                           .width = base.width,
                           .depth = base.depth,
                           .exchanges = options.exchanges,
                           .reach = options.reach};
  const bool may_be_cut = !options.as_it_runs && is_closed(graph, cycle);
  return stacked_chain(voxels, compact_stack(graph, cycle, may_be_cut, how, run), options);
}

FoldFile chain_file(const ChainClaim& claim) {
  FoldFile file = fold_file(claim.sheet);
  file.folded = claim.shape;
  nlohmann::json chain = {{"thickness", claim.thickness}, {"trim", claim.trim},     {"width", claim.width},
                          {"depth", claim.depth},         {"height", claim.height}, {"stack_angles_deg", {}}};
  for (double angle : claim.stack) chain["stack_angles_deg"].push_back(degrees(angle));
  if (claim.opened >= 0) chain["motion_opens_hinges"] = claim.opened;
  file.other.emplace_back(kChainKey, chain.dump());
  return file;
}

std::optional<ChainClaim> chain_claim(const FoldFile& file) {
  const auto at =
      std::find_if(file.other.begin(), file.other.end(), [](const auto& entry) { return entry.first == kChainKey; });
  if (at == file.other.end()) return {};
  ChainClaim claim;
  claim.sheet = file.net.sheet;
  claim.shape = file.folded;
  try {
    const nlohmann::json chain = nlohmann::json::parse(at->second);
    claim.thickness = chain.at("thickness").get<double>();
    claim.trim = chain.at("trim").get<double>();
    claim.width = chain.at("width").get<int>();
    claim.depth = chain.at("depth").get<int>();
    claim.height = chain.at("height").get<int>();
    claim.opened = chain.value("motion_opens_hinges", -1);
    for (const nlohmann::json& angle : chain.at("stack_angles_deg"))
      claim.stack.push_back(radians(angle.get<double>()));
  } catch (const nlohmann::json::exception&) {
    throw InvalidInput("chain/file", "plico:chain does not say thickness, trim, width, depth, height and angles");
  }
  return claim;
}

std::string chain_table(const VoxelMesh& voxels, const Stack& stack, const ChainClaim& claim) {
  static constexpr const char* kNormals[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  std::string table = "panel,voxel_x,voxel_y,voxel_z,normal,turn,shape_deg,stack_deg,cell_x,cell_y,layer\n";
  const std::vector<Slot> slots = stack_slots(stack.headings, stack.folds);
  for (std::size_t p = 0; p < slots.size(); ++p) {
    const ShellSquare& square = voxels.shell.squares[stack.path[p]];
    const bool last = p + 1 == slots.size();
    const int turn = last || p == 0 ? 0 : (index(stack.headings[p]) - index(stack.headings[p - 1])) & 3;
    const double shape = last ? 0 : degrees(claim.sheet.edges[p].fold_angle), pile = last ? 0 : degrees(claim.stack[p]);
    table += fmt::format("{},{},{},{},{},{},{:.0f},{:.0f},{},{},{}\n", p, square.voxel.x, square.voxel.y,
                         square.voxel.z, kNormals[static_cast<int>(square.normal)],
                         turn == 0   ? "straight"
                         : turn == 1 ? "left"
                                     : "right",
                         shape, pile, slots[p].x, slots[p].y, slots[p].layer);
  }
  return table;
}

PlacedSolid chain_solid(const ChainClaim& claim, ChainSolid what, double side) {
  const Linkage linkage = chain_linkage_of(claim);
  const std::vector<Vec3>& first = linkage.panels[0];
  const double scale = side / ((first[1] - first[0]).norm() + 2 * claim.trim);
  const double gap = what == ChainSolid::Panel ? 0 : kPrintGap;
  const Vec3 half(side / 2 - scale * claim.trim, side / 2 - scale * claim.trim,
                  scale * (1 - gap) * claim.thickness / 2);
  PlacedSolid solid{"panel", box_around_origin(half), {}};
  if (what == ChainSolid::Panel) {
    solid.places = {Pose::Identity()};
  } else {
    const bool is_stack = what == ChainSolid::Stack;
    solid.name = is_stack ? "stack" : "shape";
    const Configuration stack = Eigen::Map<const Configuration>(claim.stack.data(), linkage.num_hinges());
    const Pose start = is_stack ? Pose::Identity() : into_shape(claim);
    const std::vector<Pose> poses = folding_map(linkage, is_stack ? stack : goal(linkage));
    for (int p = 0; p < linkage.num_panels(); ++p) {
      const Vec3 centre = (linkage.panels[p][0] + linkage.panels[p][2]) / 2;
      Pose place = start * poses[p] * Eigen::Translation3d(centre);
      place.translation() *= scale;
      solid.places.push_back(place);
    }
  }
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  for (const Pose& place : solid.places) low = low.cwiseMin(place.translation() - place.linear().cwiseAbs() * half);
  for (Pose& place : solid.places) place.translation() -= low;
  return solid;
}

}  // namespace plico
