#include "plico/segment/seams.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "plico/mesh/measures.h"

namespace plico {
namespace {

using PartPair = std::pair<int, int>;

std::map<PartPair, std::vector<EdgeId>> seams_by_pair(const Mesh& mesh, const Segmentation& segmentation) {
  std::map<PartPair, std::vector<EdgeId>> by_pair;
  for (EdgeId e : seams(mesh, segmentation)) {
    const HalfedgeId h = mesh.halfedge(e);
    const auto [a, b] = std::minmax(segmentation.part[mesh.face(h)], segmentation.part[mesh.face(mesh.twin(h))]);
    by_pair[{a, b}].push_back(e);
  }
  return by_pair;
}

// Orders the edges between two parts along their chains: open ones from an end, closed ones from their first edge.
class SeamWalk {
 public:
  SeamWalk(const Mesh& mesh, const std::vector<EdgeId>& edges) : mesh_(mesh), edges_(edges) {
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (int v : ends(i)) at_[v].push_back(i);
  }

  std::vector<EdgeId> run() {
    done_.assign(edges_.size(), 0);
    for (const auto& [vertex, around] : at_)
      if (around.size() % 2 == 1) walk_from(vertex);
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (!done_[i]) walk_from(ends(i)[0]);
    return std::move(order_);
  }

 private:
  std::array<int, 2> ends(std::size_t i) const {
    const HalfedgeId h = mesh_.halfedge(edges_[i]);
    return {mesh_.from(h), mesh_.to(h)};
  }

  void walk_from(int vertex) {
    while (true) {
      const std::vector<std::size_t>& around = at_[vertex];
      const auto next = std::find_if(around.begin(), around.end(), [&](std::size_t i) { return !done_[i]; });
      if (next == around.end()) return;
      done_[*next] = 1;
      order_.push_back(edges_[*next]);
      const auto [a, b] = ends(*next);
      vertex = a == vertex ? b : a;
    }
  }

  const Mesh& mesh_;
  const std::vector<EdgeId>& edges_;
  std::map<int, std::vector<std::size_t>> at_;  // edges at a vertex
  std::vector<char> done_;
  std::vector<EdgeId> order_;
};

}  // namespace

std::vector<int> seam_numbers(const Mesh& mesh, const Segmentation& segmentation) {
  std::vector<int> number(mesh.num_edges(), 0);
  int next = 1;
  for (const auto& [parts, edges] : seams_by_pair(mesh, segmentation))
    for (EdgeId e : SeamWalk(mesh, edges).run()) number[e] = next++;
  return number;
}

std::vector<SeamLength> seam_lengths(const Mesh& mesh, const Segmentation& segmentation) {
  std::vector<SeamLength> lengths;
  for (const auto& [parts, edges] : seams_by_pair(mesh, segmentation)) {
    double sum = 0;
    for (EdgeId e : edges) sum += length(mesh, e);
    lengths.push_back({parts.first, parts.second, sum});
  }
  return lengths;
}

}  // namespace plico
