#include "plico/segment/must_part.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "plico/segment/min_cut.h"

namespace plico {
namespace {

using FacePair = std::pair<int, int>;

// One group of pairs that hang together: its faces in two colours, as far as that goes.
struct Coloured {
  std::vector<int> colours[2];
};

std::vector<Coloured> colour(const std::vector<FacePair>& pairs) {
  std::map<int, std::vector<int>> against;
  for (const auto& [a, b] : pairs) against[a].push_back(b), against[b].push_back(a);
  std::map<int, int> colour_of;
  std::vector<Coloured> groups;
  for (const auto& [first, others] : against) {
    if (colour_of.contains(first)) continue;
    Coloured& group = groups.emplace_back();
    std::vector<int> queue{first};
    colour_of[first] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int own = colour_of[queue[i]];
      group.colours[own].push_back(queue[i]);
      for (int other : against[queue[i]])
        if (colour_of.try_emplace(other, 1 - own).second) queue.push_back(other);
    }
  }
  return groups;
}

// The minimum cut of a part with these faces on either side.
class PartCut {
 public:
  PartCut(const DualGraph& graph, const std::vector<int>& faces) : graph_(graph), faces_(faces) {
    for (std::size_t i = 0; i < faces.size(); ++i) node_[faces[i]] = static_cast<int>(i);
  }

  double solve(const std::vector<int>& sources, const std::vector<int>& sinks, std::vector<char>& on_source_side) {
    MinCut cut(static_cast<int>(faces_.size()));
    for (int f : sources) cut.make_source(node_.at(f));
    for (int f : sinks) cut.make_sink(node_.at(f));
    for (int f : faces_)
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (const auto at = node_.find(arc.to); arc.to > f && at != node_.end())
          cut.add_edge(node_.at(f), at->second, arc.cost);
    const double cost = cut.solve();
    on_source_side.assign(faces_.size(), 0);
    for (std::size_t i = 0; i < faces_.size(); ++i) on_source_side[i] = cut.on_source_side(static_cast<int>(i));
    return cost;
  }

 private:
  const DualGraph& graph_;
  const std::vector<int>& faces_;
  std::map<int, int> node_;
};

// Group by group the colour that is cheaper becomes the source; the first is free to choose.
std::vector<char> cheapest_side(const DualGraph& graph, const std::vector<int>& faces,
                                const std::vector<Coloured>& groups) {
  PartCut cut(graph, faces);
  std::vector<int> sources, sinks;
  std::vector<char> best_side;
  for (const Coloured& group : groups) {
    double least = std::numeric_limits<double>::infinity();
    int best = 0;
    for (int turned = 0; turned < (sources.empty() ? 1 : 2); ++turned) {
      std::vector<int> from = sources, to = sinks;
      from.insert(from.end(), group.colours[turned].begin(), group.colours[turned].end());
      to.insert(to.end(), group.colours[1 - turned].begin(), group.colours[1 - turned].end());
      std::vector<char> side;
      if (const double cost = cut.solve(from, to, side); cost < least)
        least = cost, best = turned, best_side = std::move(side);
    }
    sources.insert(sources.end(), group.colours[best].begin(), group.colours[best].end());
    sinks.insert(sinks.end(), group.colours[1 - best].begin(), group.colours[1 - best].end());
  }
  return best_side;
}

// Connected pieces of equal labels, numbered by first face.
std::vector<int> pieces_of_labels(const DualGraph& graph, const std::vector<int>& label) {
  std::vector<int> piece(label.size(), -1), queue;
  int count = 0;
  for (std::size_t first = 0; first < label.size(); ++first) {
    if (piece[first] >= 0) continue;
    piece[first] = count;
    queue.assign(1, static_cast<int>(first));
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const DualGraph::Arc& arc : graph.arcs(queue[i]))
        if (piece[arc.to] < 0 && label[arc.to] == label[first]) piece[arc.to] = count, queue.push_back(arc.to);
    ++count;
  }
  return piece;
}

// Joins pieces that were one part before, across the dearest seam first, where no pair lies in the union.
class Rejoin {
 public:
  Rejoin(const DualGraph& graph, const std::vector<int>& before, std::vector<int> piece,
         const std::vector<FacePair>& pairs)
      : graph_(graph), before_(before), piece_(std::move(piece)), pairs_(pairs) {}

  std::vector<int> run() {
    while (join_dearest()) {
    }
    return pieces_of_labels(graph_, piece_);
  }

 private:
  bool join_dearest() {
    std::map<FacePair, double> seams;
    for (std::size_t f = 0; f < piece_.size(); ++f)
      for (const DualGraph::Arc& arc : graph_.arcs(static_cast<int>(f)))
        if (piece_[f] < piece_[arc.to] && before_[f] == before_[arc.to]) seams[{piece_[f], piece_[arc.to]}] += arc.cost;
    for (const auto& [a, b] : pairs_) seams.erase(std::minmax(piece_[a], piece_[b]));
    if (seams.empty()) return false;
    const auto dearest =
        std::max_element(seams.begin(), seams.end(), [](const auto& s, const auto& t) { return s.second < t.second; });
    const auto [kept, gone] = dearest->first;
    std::replace(piece_.begin(), piece_.end(), gone, kept);
    return true;
  }

  const DualGraph& graph_;
  const std::vector<int>& before_;
  std::vector<int> piece_;
  const std::vector<FacePair>& pairs_;
};

}  // namespace

std::vector<int> part_pairs(const DualGraph& graph, std::vector<int> part, const std::vector<FacePair>& pairs) {
  while (true) {
    std::map<int, std::vector<FacePair>> inside;
    for (const FacePair& pair : pairs)
      if (part[pair.first] == part[pair.second]) inside[part[pair.first]].push_back(pair);
    if (inside.empty()) return part;
    const std::vector<int> before = part;
    int next = *std::max_element(part.begin(), part.end()) + 1;
    for (const auto& [p, held] : inside) {
      std::vector<int> faces;
      for (std::size_t f = 0; f < part.size(); ++f)
        if (before[f] == p) faces.push_back(static_cast<int>(f));
      const std::vector<char> side = cheapest_side(graph, faces, colour(held));
      for (std::size_t i = 0; i < faces.size(); ++i)
        if (side[i]) part[faces[i]] = next;
      ++next;
    }
    part = Rejoin(graph, before, pieces_of_labels(graph, part), pairs).run();
  }
}

}  // namespace plico
