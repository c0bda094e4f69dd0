#include "plico/workflow/jobs/motion_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace plico::jobs {

nlohmann::json defects_json(const std::vector<Defect>& defects) {
  nlohmann::json list = nlohmann::json::array();
  for (const Defect& defect : defects) list.push_back({{"code", defect.code}, {"message", defect.message}});
  return list;
}

nlohmann::json motion_json(const PathProof& proof) {
  nlohmann::json json{
      {"verdict", name(proof.verdict)}, {"clearance", proof.clearance},           {"touch", proof.touch},
      {"intervals", proof.intervals},   {"pair_intervals", proof.pair_intervals}, {"interrupted", proof.interrupted}};
  if (proof.loops.loops > 0)
    json["loops"] = {{"loop_hinges", proof.loops.loops},   {"residual", proof.loops.residual},
                     {"tear", proof.loops.tear},           {"gap", proof.loops.gap},
                     {"gap_share", proof.loops.gap_share}, {"twist", proof.loops.twist}};
  if (proof.verdict == PathVerdict::Free) return json;
  if (proof.verdict == PathVerdict::NotClosed) json["open_hinge"] = proof.loops.hinge;
  if (proof.too_coarse) json["too_coarse"] = true;
  json["from"] = proof.from;
  json["to"] = proof.to;
  if (proof.panel_a >= 0) json["panels"] = {proof.panel_a, proof.panel_b};
  if (proof.verdict == PathVerdict::Collides) json["depth"] = proof.depth;
  return json;
}

std::string motion_line(const PathProof& proof) {
  const std::string effort = fmt::format("{} pairs examined on {} intervals", proof.pair_intervals, proof.intervals);
  if (proof.verdict == PathVerdict::Free) return fmt::format("proven free of collision ({})", effort);
  if (proof.interrupted) return fmt::format("not decided from t = {:.4g} on ({})", proof.from, effort);
  if (proof.verdict == PathVerdict::NotClosed)
    return fmt::format("does not close: open by {:.3g} rad at hinge {} (panels {} and {}), waypoint {}, t = {:.4g}",
                       proof.loops.residual, proof.loops.hinge, proof.panel_a, proof.panel_b, proof.loops.waypoint,
                       proof.from);
  if (proof.verdict == PathVerdict::BeyondLimits)
    return fmt::format("folds panels {} and {} beyond their limit at t = {:.4g}", proof.panel_a, proof.panel_b,
                       proof.from);
  if (proof.too_coarse)
    return fmt::format(
        "add waypoints between t = {:.6g} and {:.6g}: the hinge of panels {} and {} may open by {:.3g}, "
        "more than the clearance of {:.3g}",
        proof.from, proof.to, proof.panel_a, proof.panel_b, proof.loops.gap, proof.clearance);
  const char* const what = proof.verdict == PathVerdict::Collides ? "collide" : "cannot be told apart";
  return fmt::format("panels {} and {} {} at t in [{:.9g}, {:.9g}] ({})", proof.panel_a, proof.panel_b, what,
                     proof.from, proof.to, effort);
}

std::string loops_line(const LoopReport& loops) {
  return fmt::format(
      "closed to {:.2g} rad at waypoints; hinges open by at most {:.2g} ({:.2g} of the diagonal) and "
      "twist by {:.2g} rad between them",
      loops.residual, loops.gap, loops.gap_share, loops.twist);
}

}  // namespace plico::jobs
