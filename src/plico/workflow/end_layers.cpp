#include "plico/workflow/end_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plico/fold/linkage.h"
#include "plico/fold/real_vertices.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/verify/flat_layers.h"

namespace plico {
namespace {

constexpr double kFlatEnd = 1e-6;    // radians: of a fold that is flat or closed
constexpr double kThinnest = 1e-4;   // of the mean side: how wide what two panels share must be; drawings are rounded
constexpr double kFlush = 1e-7;      // diagonals: panels nearer than this lie on each other
constexpr double kNearlyFlat = 0.2;  // least cosine between two panels that are about to lie on each other
constexpr double kSeenEvery = radians(10);  // of a crease: how far it turns between two looks

bool is_closed_fold(double angle) { return std::abs(std::abs(angle) - kPi) < kFlatEnd; }

using Triangle2 = std::array<Vec2, 3>;

// Counter-clockwise triangles of a panel, in the sheet.
std::vector<Triangle2> triangles_of(const CreasePattern& sheet, int face) {
  const std::vector<Vec2> corners = polygon(sheet, face);
  std::vector<Triangle2> triangles;
  for (const auto& t : triangulate(corners)) triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  return triangles;
}

class LayerReader {
 public:
  LayerReader(const CreasePattern& sheet, const Linkage& linkage, const FoldingPath& path)
      : sheet_(sheet), diagonal_(diagonal(sheet)), thinnest_(kThinnest * mean_side_length(linkage)) {
    look_at(linkage, path);
    for (int f = 0; f < sheet.num_faces(); ++f) {
      triangles_.push_back(triangles_of(sheet, f));
      Eigen::AlignedBox2d& box = boxes_.emplace_back();
      for (const Vec2& p : polygon(sheet, f)) box.extend(at_end(f, p));
    }
  }

  EndLayers run() {
    EndLayers layers;
    layers.flat = true;
    const std::vector<int> part = parts_of(sheet_);
    for (int f = 0; f < sheet_.num_faces(); ++f)
      for (int g = f + 1; g < sheet_.num_faces(); ++g) {
        if (part[f] != part[g] || !boxes_[f].intersects(boxes_[g])) continue;
        const std::optional<Vec2> shared = place_in_common(f, g);
        if (!shared) continue;
        if (const int side = side_of(f, g, *shared); side != 0) layers.orders.push_back({f, g, side});
      }
    return layers;
  }

 private:
  // Between waypoints as well where panels stand there as angles in between say, without loops, whose motions have few.
  void look_at(const Linkage& linkage, const FoldingPath& path) {
    poses_.push_back(folding_map(linkage, path.waypoints.front().config));
    for (std::size_t w = 1; w < path.waypoints.size(); ++w) {
      const Configuration &before = path.waypoints[w - 1].config, &after = path.waypoints[w].config;
      const double turn = (after - before).lpNorm<Eigen::Infinity>();
      const int looks = linkage.has_loops() ? 1 : std::max(1, static_cast<int>(std::ceil(turn / kSeenEvery)));
      for (int i = 1; i < looks; ++i)
        poses_.push_back(folding_map(linkage, before + static_cast<double>(i) / looks * (after - before)));
      poses_.push_back(folding_map(linkage, after));
    }
  }

  Vec2 at_end(int face, const Vec2& p) const { return (poses_.back()[face] * Vec3(p.x(), p.y(), 0)).head<2>(); }

  // In the middle of the widest piece that both have, in the folded sheet.
  std::optional<Vec2> place_in_common(int f, int g) const {
    double widest = thinnest_;
    std::optional<Vec2> place;
    for (const Triangle2& s : triangles_[f])
      for (const Triangle2& t : triangles_[g]) {
        const std::vector<Vec2> piece = clipped(placed(f, s), upright(placed(g, t)));
        const double width = width_of(piece);
        if (!(width > widest)) continue;
        widest = width;
        Vec2 sum = Vec2::Zero();
        for (const Vec2& p : piece) sum += p;
        place = sum / static_cast<double>(piece.size());
      }
    return place;
  }

  // About; of a rectangle more than a third of its shorter side.
  static double width_of(const std::vector<Vec2>& piece) {
    double around = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) around += (piece[(i + 1) % piece.size()] - piece[i]).norm();
    return around > 0 ? 2 * std::abs(signed_area(piece)) / around : 0;
  }

  std::vector<Vec2> placed(int face, const Triangle2& t) const {
    return {at_end(face, t[0]), at_end(face, t[1]), at_end(face, t[2])};
  }
  static Triangle2 upright(const std::vector<Vec2>& t) {
    return signed_area(t) > 0 ? Triangle2{t[0], t[1], t[2]} : Triangle2{t[0], t[2], t[1]};
  }

  // 1 when f is on the side that the front of g faces, when they were last apart; 0: they never were.
  int side_of(int f, int g, const Vec2& at) const {
    const Vec3 place(at.x(), at.y(), poses_.back()[g].translation().z());
    const Vec3 on_g = poses_.back()[g].inverse() * place, on_f = poses_.back()[f].inverse() * place;
    for (auto poses = poses_.rbegin(); poses != poses_.rend(); ++poses) {
      const Pose seen = (*poses)[g].inverse() * (*poses)[f];  // f from g, whose front looks along z
      const Vec3 normal = seen.linear().col(2);
      if (std::abs(normal.z()) < kNearlyFlat) return 0;
      const double height = normal.dot(seen * Vec3(on_f.x(), on_f.y(), 0) - Vec3(on_g.x(), on_g.y(), 0)) / normal.z();
      if (std::abs(height) > kFlush * diagonal_) return height > 0 ? 1 : -1;
    }
    return 0;
  }

  const CreasePattern& sheet_;
  double diagonal_, thinnest_;
  std::vector<std::vector<Pose>> poses_;
  std::vector<std::vector<Triangle2>> triangles_;
  std::vector<Eigen::AlignedBox2d> boxes_;  // folded
};

}  // namespace

CreasePattern end_of_motion(const CreasePattern& sheet, const Linkage& linkage, const Configuration& end) {
  CreasePattern folded = sheet;
  for (int h = 0; h < linkage.num_hinges(); ++h) {
    Crease& crease = folded.edges[linkage.hinges[h].edge];
    crease.fold_angle = is_closed_fold(end[h]) ? std::copysign(kPi, end[h]) : std::abs(end[h]) < kFlatEnd ? 0 : end[h];
    crease.assignment = assignment_of(crease.fold_angle);
  }
  return folded;
}

EndLayers end_layers(const CreasePattern& sheet, const Linkage& linkage, const FoldingPath& path) {
  EndLayers layers;
  const Configuration& end = path.waypoints.back().config;
  bool any = false;
  for (int h = 0; h < end.size(); ++h) {
    if (is_closed_fold(end[h]))
      any = true;
    else if (!(std::abs(end[h]) < kFlatEnd))
      return layers;
  }
  if (!any) return layers;
  if (sheet.num_faces() > kMostEndLayered) {
    layers.flat = true;
    layers.why = fmt::format("{} panels, at most {} are put in order", sheet.num_faces(), kMostEndLayered);
    return layers;
  }
  layers = LayerReader(sheet, linkage, path).run();
  if (layers.orders.empty()) {
    layers.why = "no two panels could be told apart";
    return layers;
  }
  const FlatLayersVerdict verdict = check_flat_layers(end_of_motion(sheet, linkage, end), layers.orders);
  layers.places = verdict.places;
  if (verdict.valid) return layers;
  layers.why = fmt::format("the order read off the motion does not stand the check: {}", verdict.why);
  layers.orders.clear();
  return layers;
}

}  // namespace plico
