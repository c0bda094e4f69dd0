#include "plico/fabricate/assembly.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace plico {
namespace {

using SeamLengths = std::vector<std::map<int, double>>;  // of each part with others

SeamLengths seams_between(const NetSides& sides) {
  const Unfolding& net = sides.net();
  SeamLengths seams(net.num_parts());
  for (int e = 0; e < net.sheet.num_edges(); ++e) {
    const int mate = net.mate[e];
    if (mate < 0 || sides.side(e).panel < 0 || sides.side(mate).panel < 0) continue;
    const int here = sides.part(e), there = sides.part(mate);
    if (here != there) seams[here][there] += (sides.to(sides.side(e)) - sides.from(sides.side(e))).norm();
  }
  return seams;
}

// The part that is glued to those built along the greatest length; the lowest of equals, or when none is.
int next_part(const SeamLengths& seams, const std::vector<char>& built) {
  int best = -1;
  double longest = -1;
  for (int p = 0; p < static_cast<int>(seams.size()); ++p) {
    if (built[p]) continue;
    double length = 0;
    for (const auto& [other, seam] : seams[p]) length += built[other] ? seam : 0;
    if (length > longest * (1 + 1e-12)) best = p, longest = length;
  }
  return best;
}

}  // namespace

std::vector<AssemblyStep> assembly_order(const NetSides& sides, const std::vector<int>& rank) {
  const SeamLengths seams = seams_between(sides);
  const int count = static_cast<int>(seams.size());
  std::vector<int> by_rank(count);
  std::iota(by_rank.begin(), by_rank.end(), 0);
  if (!rank.empty()) std::stable_sort(by_rank.begin(), by_rank.end(), [&](int a, int b) { return rank[a] < rank[b]; });
  std::vector<char> built(count, 0);
  std::vector<AssemblyStep> steps;
  for (int i = 0; i < count; ++i) {
    AssemblyStep step{rank.empty() ? next_part(seams, built) : by_rank[i], {}};
    const auto& around = seams[step.part];
    for (const auto& [other, seam] : around)
      if (built[other]) step.onto.push_back(other);
    std::stable_sort(step.onto.begin(), step.onto.end(), [&](int a, int b) { return around.at(a) > around.at(b); });
    built[step.part] = 1;
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace plico
