// cut_by_convexity(): ridges apart, neighbours joined, seams shortened; several weights compared.
#include "plico/segment/convexity.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <set>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/segment/dual_graph.h"
#include "plico/segment/patch_cut.h"

namespace plico {
namespace {

using PartPair = std::pair<int, int>;  // ids, the smaller one first

enum class JoinOrder { Shallowest, LongestSeam };

// One way of going about it.
struct Manner {
  SeamWeight seam;
  double fine = 1;  // parts are cut to this share of the bound before they are joined
  JoinOrder order = JoinOrder::Shallowest;
};

// The first is for meshes of any size. Measured on the meshes of bench/segment: no other four of 144 made fewer parts.
constexpr std::array<Manner, 4> kManners{{{{.valley_fall = 0.35, .deep = 0}, 0.6, JoinOrder::Shallowest},
                                          {{.valley_fall = 0.35, .deep = 0.7}, 0.6, JoinOrder::LongestSeam},
                                          {{.valley_fall = 0, .deep = 0.7}, 0.4, JoinOrder::Shallowest},
                                          {{.valley_fall = 0.7, .deep = 0}, 0.6, JoinOrder::Shallowest}}};
constexpr double kLeastSaddle = 0.5;  // of the bound: ridges that join less deep are not parted
constexpr int kShorteningRounds = 5;  // of shortening
constexpr std::array<double, 4> kSeamBands{0.15, 0.3, 0.6, 1.0};  // around a seam, as shares of the farthest face

class ConvexityCut {
 public:
  ConvexityCut(const Mesh& mesh, const DualGraph& graph, double bound, const Manner& manner, const Run& run)
      : mesh_(mesh), graph_(graph), bound_(bound), manner_(manner), run_(run), part_(mesh.num_faces(), -1) {}

  void cut() {
    part_ridges();
    join_neighbours();
    shorten_seams();
    join_neighbours();
  }

  double price() const {
    double seam = 0;
    for (const auto& [pair, length] : seam_of_pairs()) seam += length;
    return seam / diagonal(mesh_) + kPricePerPart * static_cast<double>(parts_.size());
  }

  std::vector<int> labels() const {
    std::vector<int> label(part_.size());
    int next = 0;
    for (const auto& [id, faces] : parts_) {
      for (int f : faces) label[f] = next;
      ++next;
    }
    return label;
  }

 private:
  int add_part(std::vector<int> faces) {
    const int id = next_id_++;
    for (int f : faces) part_[f] = id;
    parts_.emplace(id, std::move(faces));
    return id;
  }

  void part_ridges() {
    const Components whole = components(mesh_);
    std::vector<std::vector<int>> todo(whole.count);
    for (int f = 0; f < mesh_.num_faces(); ++f) todo[whole.of_face[f]].push_back(f);
    while (!todo.empty()) {
      std::vector<int> faces = std::move(todo.back());
      todo.pop_back();
      const PatchVertices patch = hull_depths(mesh_, faces);
      const double bound = run_.over() ? bound_ : manner_.fine * bound_;
      if (patch.deepest() <= bound || faces.size() == 1) {
        add_part(std::move(faces));
        continue;
      }
      const std::vector<Side> side = part_at_fault(mesh_, faces, patch, kLeastSaddle * bound, manner_.seam);
      for (std::vector<int>& piece : connected_sides(mesh_, faces, side)) todo.push_back(std::move(piece));
    }
  }

  std::map<PartPair, double> seam_of_pairs() const {
    std::map<PartPair, double> seams;
    for (EdgeId e : mesh_.edges()) {
      if (mesh_.is_boundary(e)) continue;
      const HalfedgeId h = mesh_.halfedge(e);
      const int a = part_[mesh_.face(h)], b = part_[mesh_.face(mesh_.twin(h))];
      if (a != b) seams[std::minmax(a, b)] += length(mesh_, e);
    }
    return seams;
  }

  std::vector<int> together(PartPair pair) const {
    const std::vector<int>&a = parts_.at(pair.first), &b = parts_.at(pair.second);
    std::vector<int> all;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    return all;
  }

  // What is known of a pair stays true: an id stands for one set of faces.
  std::optional<double> depth_together(PartPair pair) {
    const auto [at, is_new] = joined_depth_.try_emplace(pair);
    if (is_new) at->second = depth_within(mesh_, together(pair), bound_);
    return at->second;
  }

  std::optional<PartPair> best_to_join() {
    std::optional<PartPair> best;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [pair, length] : seam_of_pairs()) {
      const std::optional<double> depth = depth_together(pair);
      if (!depth) continue;
      const double key = manner_.order == JoinOrder::Shallowest ? *depth : -length;
      if (key < least) best = pair, least = key;
    }
    return best;
  }

  void join_neighbours() {
    while (!run_.over()) {
      const std::optional<PartPair> pair = best_to_join();
      if (!pair) return;
      std::vector<int> faces = together(*pair);
      parts_.erase(pair->first);
      parts_.erase(pair->second);
      add_part(std::move(faces));
    }
  }

  void shorten_seams() {
    bool shorter = true;
    for (int round = 0; shorter && round < kShorteningRounds; ++round) {
      shorter = false;
      for (const auto& [pair, length] : seam_of_pairs()) {
        if (run_.over()) return;
        if (!parts_.contains(pair.first) || !parts_.contains(pair.second)) continue;  // made anew in this round
        if (cannot_shorten_.contains(pair)) continue;
        if (shorten(pair))
          shorter = true;
        else
          cannot_shorten_.insert(pair);
      }
    }
  }

  // The shortest seam that cuts in bands around the present one give, if it is shorter.
  bool shorten(PartPair pair) {
    const std::vector<int> faces = together(pair);
    const std::vector<double> away = distance_from_seam(pair);
    double least = seam_within(faces, [&](int f) { return part_[f]; });
    std::vector<std::vector<int>> best;
    for (double band : kSeamBands) {
      const std::vector<Side> given = outside_band(faces, pair, away, band);
      if (!both_given(given)) continue;
      const std::vector<Side> side = cut_patch(mesh_, faces, {}, given, {.valley_fall = 0, .deep = 0});
      const double seam = length_of_cut(faces, side);
      if (seam >= least * (1 - 1e-9)) continue;
      std::vector<std::vector<int>> pieces = connected_sides(mesh_, faces, side);
      if (pieces.size() != 2 || !depth_within(mesh_, pieces[0], bound_) || !depth_within(mesh_, pieces[1], bound_))
        continue;
      least = seam;
      best = std::move(pieces);
    }
    if (best.empty()) return false;
    parts_.erase(pair.first);
    parts_.erase(pair.second);
    for (std::vector<int>& piece : best) add_part(std::move(piece));
    return true;
  }

  // Length of the edges between faces of two kinds.
  template <class Kind>
  double seam_within(const std::vector<int>& faces, Kind&& kind) const {
    double sum = 0;
    for (int f : faces)
      for (HalfedgeId h : mesh_.halfedges(FaceId(f))) {
        if (!mesh_.twin(h).valid()) continue;
        const int g = mesh_.face(mesh_.twin(h));
        if (f < g && std::binary_search(faces.begin(), faces.end(), g) && kind(f) != kind(g))
          sum += length(mesh_, mesh_.edge(h));
      }
    return sum;
  }

  double length_of_cut(const std::vector<int>& faces, const std::vector<Side>& side) const {
    return seam_within(faces,
                       [&](int f) { return side[std::lower_bound(faces.begin(), faces.end(), f) - faces.begin()]; });
  }

  // Over the faces of both parts, from those on the seam; Dijkstra. Of every face of the mesh, infinite elsewhere.
  std::vector<double> distance_from_seam(PartPair pair) const {
    std::vector<double> away(part_.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
    const auto among = [&](int f) { return part_[f] == pair.first || part_[f] == pair.second; };
    for (int id : {pair.first, pair.second})
      for (int f : parts_.at(id))
        for (const DualGraph::Arc& arc : graph_.arcs(f))
          if (among(arc.to) && part_[arc.to] != id) away[f] = 0;
    for (int id : {pair.first, pair.second})
      for (int f : parts_.at(id))
        if (away[f] == 0) queue.emplace(0, f);
    while (!queue.empty()) {
      const auto [distance, f] = queue.top();
      queue.pop();
      if (distance > away[f]) continue;
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (among(arc.to) && distance + arc.distance < away[arc.to]) {
          away[arc.to] = distance + arc.distance;
          queue.emplace(away[arc.to], arc.to);
        }
    }
    return away;
  }

  std::vector<Side> outside_band(const std::vector<int>& faces, PartPair pair, const std::vector<double>& away,
                                 double band) const {
    double first = 0, second = 0;  // the farthest faces
    for (int f : faces) {
      double& farthest = part_[f] == pair.first ? first : second;
      farthest = std::max(farthest, away[f]);
    }
    std::vector<Side> given(faces.size(), Side::Free);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const bool is_first = part_[faces[i]] == pair.first;
      if (away[faces[i]] >= band * (is_first ? first : second)) given[i] = is_first ? Side::First : Side::Second;
    }
    return given;
  }

  const Mesh& mesh_;
  const DualGraph& graph_;
  double bound_;  // units
  const Manner& manner_;
  const Run& run_;
  std::vector<int> part_;  // id of each face
  std::map<int, std::vector<int>> parts_;
  int next_id_ = 0;
  std::map<PartPair, std::optional<double>> joined_depth_;
  std::set<PartPair> cannot_shorten_;
};

}  // namespace

void check(const ConvexityOptions& options) {
  require(options.concavity > 0, "concavity", options.concavity, "above 0");
}

std::vector<int> cut_by_convexity(const Mesh& mesh, const ConvexityOptions& options, const Run& run) {
  check(options);
  const double bound = options.concavity * diagonal(mesh);
  const DualGraph graph(mesh);
  const int tries = mesh.num_faces() <= kSmallMesh ? static_cast<int>(kManners.size()) : 1;
  std::vector<std::vector<int>> labels(tries);
  std::vector<double> price(tries, std::numeric_limits<double>::infinity());
  Run alone = run;
  alone.threads = 1;
  alone.progress = nullptr;  // side by side
  run.report("parting ridges", 0);
  parallel_for(run, tries, [&](int i) {
    if (i > 0 && run.over()) return;
    ConvexityCut attempt(mesh, graph, bound, kManners[i], alone);
    attempt.cut();
    price[i] = attempt.price();
    labels[i] = attempt.labels();
  });
  return std::move(labels[std::min_element(price.begin(), price.end()) - price.begin()]);
}

}  // namespace plico
