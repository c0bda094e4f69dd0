#include "motion_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace plico::cli {

nlohmann::json motion_json(const PathProof& proof) {
  nlohmann::json json{
      {"verdict", name(proof.verdict)}, {"clearance", proof.clearance},           {"touch", proof.touch},
      {"intervals", proof.intervals},   {"pair_intervals", proof.pair_intervals}, {"interrupted", proof.interrupted}};
  if (proof.verdict == PathVerdict::Free) return json;
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
  const char* const what = proof.verdict == PathVerdict::Collides ? "collide" : "cannot be told apart";
  return fmt::format("panels {} and {} {} at t in [{:.9g}, {:.9g}] ({})", proof.panel_a, proof.panel_b, what,
                     proof.from, proof.to, effort);
}

}  // namespace plico::cli
