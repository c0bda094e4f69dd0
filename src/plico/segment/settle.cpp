#include "plico/segment/settle.h"

#include <optional>
#include <set>
#include <utility>

namespace plico {
namespace {

constexpr double kLengthShare = 0.2;  // 0.05 leaves seams where they are, with 0.5 they leave their valleys
constexpr int kRounds = 2;            // a seam that ends on another follows it

using PartPair = std::pair<int, int>;

std::set<PartPair> neighbours(const DualGraph& graph, const std::vector<int>& start, const std::vector<int>& part) {
  std::set<PartPair> pairs;
  for (int f = 0; f < graph.num_faces(); ++f)
    for (const DualGraph::Arc& arc : graph.arcs(f))
      if (part[f] < part[arc.to] && start[f] == start[arc.to]) pairs.emplace(part[f], part[arc.to]);
  return pairs;
}

void settle(const DualGraph& graph, const PartPair& pair, const NeckOptions& options, std::vector<int>& part) {
  const auto [a, b] = pair;
  std::vector<int> faces, side;
  for (int f = 0; f < graph.num_faces(); ++f) {
    if (part[f] == a || part[f] == b) faces.push_back(f);
    if (part[f] == b) side.push_back(f);
  }
  const std::optional<Neck> neck = smoothed_neck(graph, faces, side, options);
  if (!neck) return;
  // The smaller side is told; it keeps the number that most of it has.
  std::size_t in_b = 0;
  for (int f : neck->side) in_b += part[f] == b;
  const bool is_b = 2 * in_b > neck->side.size();
  for (int f : faces) part[f] = is_b ? a : b;
  for (int f : neck->side) part[f] = is_b ? b : a;
}

}  // namespace

void settle_seams(const DualGraph& graph, const std::vector<int>& start, std::vector<int>& part,
                  const NeckOptions& options) {
  const DualGraph longer = graph.with_length(kLengthShare);
  for (int round = 0; round < kRounds; ++round)
    for (const PartPair& pair : neighbours(longer, start, part)) settle(longer, pair, options, part);
}

}  // namespace plico
