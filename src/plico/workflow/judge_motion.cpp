#include "plico/workflow/judge_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/verify/deformation.h"
#include "plico/verify/overlap.h"

namespace plico {
namespace {

constexpr double kPlace = 1e-7;            // of the diagonal of the sheet
constexpr double kStart = 1e-6;            // radians
constexpr double kGoal = radians(0.5);     // a goal rounded in a file is moved by up to this (workflow/plan_origami.h)
constexpr double kShare = 1e-6;            // of the way to the goal: what a file may round
constexpr double kNoFold = radians(1e-6);  // what cannot turn is not turned

double diagonal_of(const CreasePattern& sheet) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : sheet.vertices) box.extend(p);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

// How much of the way to the goal a motion goes, as its file says.
std::optional<double> claimed_share(const std::string& report) {
  const nlohmann::json root = nlohmann::json::parse(report, nullptr, false);
  if (!root.is_object() || !root.contains("motion") || !root["motion"].is_object()) return {};
  const nlohmann::json& motion = root["motion"];
  if (!motion.contains("progress") || !motion["progress"].is_number()) return {};
  return motion["progress"].get<double>();
}

// By how much edges may change their length, as the file says; 0 when it says nothing that can be.
double claimed_deformation(const std::string& report) {
  const nlohmann::json root = nlohmann::json::parse(report, nullptr, false);
  const nlohmann::json::json_pointer place("/motion/deformation/allowed");
  if (!root.is_object() || !root.contains(place) || !root[place].is_number()) return 0;
  const double allowed = root[place].get<double>();
  return allowed > 0 && allowed <= kMostDeformation ? allowed : 0;
}

class MotionJudge {
 public:
  MotionJudge(const FoldFile& file, const Linkage& linkage, const std::optional<Mesh>& mesh, const Run& run)
      : file_(file), linkage_(linkage), mesh_(mesh), run_(run) {
    diagonal_ = diagonal_of(file.net.sheet);
  }

  FileVerdict run() {
    judge_sheet();
    judge_letters();
    judge_start();
    judge_goal();
    judge_limits();
    judge_points();
    judge_deformation();
    return std::move(verdict_);
  }

 private:
  template <class... Values>
  void defect(const char* code, fmt::format_string<Values...> message, Values&&... values) {
    verdict_.defects.push_back({code, fmt::format(message, std::forward<Values>(values)...)});
  }

  // A net is held against its mesh, everything else against itself.
  void judge_sheet() {
    if (file_.net.mesh_face.empty() || file_.net.mesh_vertex.empty()) return judge_overlap();
    if (!mesh_ && file_.folded.empty()) {
      verdict_.unchecked.emplace_back("whether it is a net of its mesh: the file has no folded form, give the mesh");
      return judge_overlap();
    }
    try {
      const NetVerdict net = verify_net(file_.net, mesh_ ? *mesh_ : folded_mesh(file_), {}, run_);
      verdict_.defects.insert(verdict_.defects.end(), net.defects.begin(), net.defects.end());
      verdict_.complete = verdict_.complete && net.complete;
    } catch (const InvalidInput& error) {  // a folded form that is no surface
      defect("net/folded-form", "{}", error.what());
    }
    if (!mesh_) return;
    if (std::optional<Defect> found = judge_folded_form(file_, *mesh_)) verdict_.defects.push_back(std::move(*found));
  }

  void judge_overlap() {
    const Overlaps overlaps = find_overlaps(file_.net.sheet, {}, run_);
    verdict_.complete = verdict_.complete && overlaps.complete;
    if (overlaps.count > 0)
      defect("sheet/overlap", "{} pairs of panels overlap, the first {} and {}", overlaps.count,
             overlaps.listed.front().a, overlaps.listed.front().b);
  }

  // An edge between two panels that is called border or cut does not turn, so it must not ask to.
  void judge_letters() {
    const CreasePattern& sheet = file_.net.sheet;
    const std::vector<EdgeSides> sides = edge_sides(sheet);
    for (int e = 0; e < sheet.num_edges(); ++e) {
      const Crease& edge = sheet.edges[e];
      if (is_hinge(edge, sides[e]) || std::abs(edge.fold_angle) <= kNoFold) continue;
      defect("sheet/assignment", "edge {} folds by {:.6g} degrees but is called {}", e, degrees(edge.fold_angle),
             static_cast<char>(edge.assignment));
    }
  }

  void worst_angle(const char* code, const char* what, const Configuration& off, double most) {
    Eigen::Index at = 0;
    if (off.size() == 0 || !(off.cwiseAbs().maxCoeff(&at) > most)) return;
    const Hinge& hinge = linkage_.hinges[at];
    defect(code, "{}: the fold of panels {} and {} is off by {:.4g} degrees", what, hinge.left, hinge.right,
           degrees(std::abs(off[at])));
  }

  void judge_start() {
    worst_angle("motion/start", "it does not start flat", file_.path->waypoints.front().config, kStart);
  }

  void judge_goal() {
    const Configuration& end = file_.path->waypoints.back().config;
    verdict_.share = share_of_way(linkage_, end);
    const std::optional<double> claimed = claimed_share(file_.report);
    verdict_.is_partial = claimed && *claimed < 1 && std::abs(*claimed - verdict_.share) <= kShare;
    if (!verdict_.is_partial) worst_angle("motion/goal", "it does not reach the goal", end - goal(linkage_), kGoal);
  }

  void judge_limits() {
    for (const Waypoint& waypoint : file_.path->waypoints) {
      const int h = hinge_beyond_limits(linkage_, waypoint.config, kStart);
      if (h < 0) continue;
      const Hinge& hinge = linkage_.hinges[h];
      return defect("motion/limit",
                    "at t = {:.4g} the fold of panels {} and {} is at {:.6g} degrees, its limit is {:.6g}",
                    waypoint.time, hinge.left, hinge.right, degrees(waypoint.config[h]), degrees(hinge.high));
    }
  }

  void judge_points() {
    FoldFile placed;
    placed.net.sheet = file_.net.sheet;
    set_path(placed, linkage_, *file_.path);
    for (std::size_t w = 0; w < placed.path_points.size(); ++w) {
      for (std::size_t v = 0; v < placed.path_points[w].size(); ++v) {
        const double off = (placed.path_points[w][v] - file_.path_points[w][v]).norm();
        if (off <= kPlace * diagonal_) continue;
        return defect("motion/points", "waypoint {} draws vertex {} {:.3g} from where its fold angles put it", w, v,
                      off);
      }
    }
  }

  void judge_deformation() {
    verdict_.may_deform = claimed_deformation(file_.report);
    if (verdict_.may_deform == 0) return;
    const Deformation measured = measure_deformation(file_.net.sheet, linkage_, *file_.path);
    verdict_.deformation = measured.worst;
    if (measured.worst > verdict_.may_deform)
      defect("motion/deformation", "at waypoint {} edge {} changes its length by {:.3g} %, the file allows {:.3g} %",
             measured.waypoint, measured.edge, 100 * measured.worst, 100 * verdict_.may_deform);
  }

  const FoldFile& file_;
  const Linkage& linkage_;
  const std::optional<Mesh>& mesh_;
  const Run& run_;
  double diagonal_ = 0;
  FileVerdict verdict_;
};

}  // namespace

std::optional<Defect> judge_folded_form(const FoldFile& file, const Mesh& mesh) {
  const double slack = kPlace * diagonal_of(file.net.sheet);
  for (std::size_t v = 0; v < std::min(file.folded.size(), file.net.mesh_vertex.size()); ++v) {
    const int at = file.net.mesh_vertex[v];
    if (at >= mesh.num_vertices()) return {};  // verify_net says so
    const double off = (file.folded[v] - mesh.point(VertexId(at))).norm();
    if (!(off <= slack))
      return Defect{"net/folded-form",
                    fmt::format("vertex {} of the folded form is {:.3g} from vertex {} of the mesh", v, off, at)};
  }
  return {};
}

FileVerdict judge_motion(const FoldFile& file, const Linkage& linkage, const std::optional<Mesh>& mesh,
                         const Run& run) {
  PLICO_ASSERT(file.path.has_value());
  return MotionJudge(file, linkage, mesh, run).run();
}

}  // namespace plico
