#include "plico/segment/necks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <set>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/segment/eigenvectors.h"
#include "plico/segment/min_cut.h"

namespace plico {
namespace {

constexpr double kBand = 0.35;  // half its width, in roots of the smaller side's area
constexpr int kBins = 6;        // stretches of a sweep that give a cut each

enum Mark { kOutside = 0, kRest = 1, kSide = 2 };

// One part while its cuts are looked at.
class NeckSearch {
 public:
  NeckSearch(const DualGraph& graph, const std::vector<int>& faces, const NeckOptions& options)
      : graph_(graph), faces_(faces), options_(options), mark_(graph.num_faces(), kOutside) {
    for (int f : faces) area_ += graph.area(f);
  }

  std::optional<Neck> best() {
    std::vector<Neck> cuts = swept_cuts();
    std::sort(cuts.begin(), cuts.end(), better);
    std::optional<Neck> best;
    int refined = 0;
    std::set<std::vector<int>> seen;
    for (const Neck& cut : cuts) {
      if (!seen.insert(cut.side).second) continue;
      if (refined++ == options_.refined) break;
      const Neck neck = refine(cut);
      if (!best || better(neck, *best)) best = neck;
    }
    return best;
  }

  std::optional<Neck> judge(const std::vector<int>& side) {
    mark_all(side);
    std::vector<std::vector<int>> pieces = pieces_of(kSide), rest = pieces_of(kRest);
    if (pieces.empty() || rest.empty()) return std::nullopt;
    // The largest piece of each side keeps it; the other side's first, since it then may take up loose ones of its own.
    keep_largest(rest, kSide);
    pieces = pieces_of(kSide);
    keep_largest(pieces, kRest);
    return neck_of_marks();
  }

  // The minimum cut in a band around a cut, again while that helps.
  Neck refine(Neck neck) {
    for (int round = 0; round < 3; ++round) {
      const std::optional<Neck> moved = cut_in_band(neck);
      if (!moved || !better(*moved, neck)) return neck;
      neck = *moved;
    }
    return neck;
  }

  // Every connected piece of a set of faces is a cut of its own.
  void add_pieces(const std::vector<int>& set, std::vector<Neck>& cuts) {
    mark_all(set);
    for (const std::vector<int>& piece : pieces_of(kSide))
      if (std::optional<Neck> neck = judge(piece)) cuts.push_back(std::move(*neck));
  }

 private:
  static bool better(const Neck& a, const Neck& b) { return a.score != b.score ? a.score < b.score : a.side < b.side; }

  double area_of(const std::vector<int>& faces) const {
    double sum = 0;
    for (int f : faces) sum += graph_.area(f);
    return sum;
  }

  void mark_all(const std::vector<int>& side) {
    for (int f : faces_) mark_[f] = kRest;
    for (int f : side) mark_[f] = kSide;
  }

  std::vector<std::vector<int>> pieces_of(Mark mark) const {
    std::vector<std::vector<int>> pieces;
    std::vector<char> seen(mark_.size(), 0);
    for (int first : faces_) {
      if (mark_[first] != mark || seen[first]) continue;
      std::vector<int>& piece = pieces.emplace_back(1, first);
      seen[first] = 1;
      for (std::size_t i = 0; i < piece.size(); ++i)
        for (const DualGraph::Arc& arc : graph_.arcs(piece[i]))
          if (mark_[arc.to] == mark && !seen[arc.to]) seen[arc.to] = 1, piece.push_back(arc.to);
    }
    return pieces;
  }

  void keep_largest(const std::vector<std::vector<int>>& pieces, Mark others) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i)
      if (area_of(pieces[i]) > area_of(pieces[largest])) largest = i;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (i != largest)
        for (int f : pieces[i]) mark_[f] = others;
  }

  std::optional<Neck> neck_of_marks() const {
    std::vector<int> side, rest;
    for (int f : faces_) (mark_[f] == kSide ? side : rest).push_back(f);
    if (side.empty() || rest.empty()) return std::nullopt;
    const double one = area_of(side), smaller = std::min(one, area_ - one), whole = graph_.total_area();
    if (!(smaller >= options_.min_area * whole)) return std::nullopt;
    Neck neck;
    neck.cost = cut_cost(graph_, side, mark_, kRest);
    if (neck.cost >= graph_.held_cost()) return std::nullopt;
    neck.score = neck.cost / std::sqrt(whole) / plico::pow(smaller / whole, options_.area_power);
    neck.side = one <= area_ - one ? std::move(side) : std::move(rest);
    std::sort(neck.side.begin(), neck.side.end());
    return neck;
  }

  std::vector<Neck> swept_cuts() {
    std::vector<Neck> cuts;
    for (const std::vector<double>& values : low_eigenvectors(graph_, faces_, options_.eigenvectors))
      sweep(values, cuts);
    return cuts;
  }

  // Adds the faces to a side by rising value; the best moment of each stretch gives a cut.
  void sweep(const std::vector<double>& values, std::vector<Neck>& cuts) {
    std::vector<int> order(faces_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return values[i] != values[j] ? values[i] < values[j] : i < j; });
    mark_all({});
    std::vector<double> least(kBins, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> moment(kBins, 0);
    double cost = 0, area = 0;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      const int f = faces_[order[i]];
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (mark_[arc.to] != kOutside) cost += mark_[arc.to] == kRest ? arc.cost : -arc.cost;
      mark_[f] = kSide;
      area += graph_.area(f);
      const double smaller = std::min(area, area_ - area);
      if (smaller < options_.min_area * graph_.total_area() || smaller <= 0) continue;
      const double score = cost / plico::pow(smaller, options_.area_power);
      const int bin = std::min(kBins - 1, static_cast<int>(kBins * area / area_));
      if (score < least[bin]) least[bin] = score, moment[bin] = i + 1;
    }
    for (std::size_t end : moment) {
      if (end == 0) continue;
      std::vector<int> side;
      for (std::size_t i = 0; i < end; ++i) side.push_back(faces_[order[i]]);
      add_pieces(side, cuts);
    }
  }

  // How far every face is from the seam, over the faces of the part.
  std::vector<double> distances_from_seam() const {
    using Entry = std::pair<double, int>;
    std::vector<double> distance(mark_.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (int f : faces_)
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (mark_[arc.to] != kOutside && mark_[arc.to] != mark_[f] && arc.distance / 2 < distance[f])
          distance[f] = arc.distance / 2, queue.emplace(distance[f], f);
    while (!queue.empty()) {
      const auto [d, f] = queue.top();
      queue.pop();
      if (d > distance[f]) continue;
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (mark_[arc.to] == mark_[f] && d + arc.distance < distance[arc.to])
          distance[arc.to] = d + arc.distance, queue.emplace(distance[arc.to], arc.to);
    }
    return distance;
  }

  std::optional<Neck> cut_in_band(const Neck& neck) {
    mark_all(neck.side);
    const std::vector<double> distance = distances_from_seam();
    const double width = kBand * std::sqrt(area_of(neck.side));
    std::vector<int> node(mark_.size(), -1);
    MinCut cut(static_cast<int>(faces_.size()));
    for (std::size_t i = 0; i < faces_.size(); ++i) node[faces_[i]] = static_cast<int>(i);
    for (Mark mark : {kSide, kRest}) {
      int farthest = -1;
      for (int f : faces_) {
        if (mark_[f] != mark) continue;
        if (distance[f] > width) set_terminal(cut, node[f], mark);
        if (farthest < 0 || distance[f] > distance[farthest]) farthest = f;
      }
      set_terminal(cut, node[farthest], mark);
    }
    for (int f : faces_)
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (arc.to > f && node[arc.to] >= 0) cut.add_edge(node[f], node[arc.to], arc.cost);
    cut.solve();
    std::vector<int> side;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (cut.on_source_side(static_cast<int>(i))) side.push_back(faces_[i]);
    return judge(side);
  }

  static void set_terminal(MinCut& cut, int node, Mark mark) {
    if (mark == kSide)
      cut.make_source(node);
    else
      cut.make_sink(node);
  }

  const DualGraph& graph_;
  const std::vector<int>& faces_;
  const NeckOptions& options_;
  std::vector<int> mark_;  // of every face of the mesh
  double area_ = 0;
};

}  // namespace

void check(const NeckOptions& options) {
  require(options.min_area >= 0 && options.min_area <= 0.5, "min-area", options.min_area, "in [0, 0.5]");
  require(options.eigenvectors >= 1, "eigenvectors", options.eigenvectors, "at least 1");
  require(options.refined >= 1, "refined", options.refined, "at least 1");
  require(options.area_power >= 0 && options.area_power <= 1, "area-power", options.area_power, "in [0, 1]");
}

std::optional<Neck> best_neck(const DualGraph& graph, const std::vector<int>& faces, const NeckOptions& options) {
  return NeckSearch(graph, faces, options).best();
}

std::vector<int> cut_at_necks(const DualGraph& graph, std::vector<int> part, const NeckCutOptions& options,
                              const Run& run) {
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < graph.num_faces(); ++f) {
    if (part[f] >= static_cast<int>(faces.size())) faces.resize(part[f] + 1);
    faces[part[f]].push_back(f);
  }
  std::vector<std::optional<Neck>> necks(faces.size());
  const auto look_at = [&](int p) { necks[p] = best_neck(graph, faces[p], options.neck); };
  parallel_for(run, static_cast<int>(faces.size()), look_at);
  while (static_cast<int>(faces.size()) < options.max_parts && !run.over()) {
    int best = -1;
    for (std::size_t p = 0; p < faces.size(); ++p)
      if (necks[p] && (best < 0 || necks[p]->score < necks[best]->score)) best = static_cast<int>(p);
    if (best < 0 || necks[best]->score >= options.worst_score) break;
    const int next = static_cast<int>(faces.size());
    faces.push_back(necks[best]->side);
    for (int f : faces.back()) part[f] = next;
    std::erase_if(faces[best], [&](int f) { return part[f] == next; });
    necks.emplace_back();
    parallel_for(run, 2, [&](int i) { look_at(i == 0 ? best : next); });
    run.report("cutting at necks", next + 1, options.max_parts);
  }
  return part;
}

std::optional<Neck> neck_at(const DualGraph& graph, const std::vector<int>& faces, const std::vector<int>& side,
                            const NeckOptions& options) {
  return NeckSearch(graph, faces, options).judge(side);
}

std::optional<Neck> smoothed_neck(const DualGraph& graph, const std::vector<int>& faces, const std::vector<int>& side,
                                  const NeckOptions& options) {
  NeckSearch search(graph, faces, options);
  std::optional<Neck> neck = search.judge(side);
  return neck ? search.refine(std::move(*neck)) : neck;
}

}  // namespace plico
