#include "plico/segment/coarse.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "plico/geom/box_tree.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/simplify.h"
#include "plico/segment/given.h"
#include "plico/segment/rearrange.h"
#include "plico/segment/settle.h"
#include "plico/segment/thickness.h"

namespace plico {
namespace {

constexpr int kCoarseFaces = 700;

Mesh coarse_of(const Mesh& mesh) { return Mesh(simplified(Mesh(triangulated(mesh.soup())), {.faces = kCoarseFaces})); }

// Centres stand for their faces: they are small, and seams are moved afterwards. A face looks the other way than the
// one behind it, however thin the shape is.
class NearestFace {
 public:
  explicit NearestFace(const Mesh& mesh) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (FaceId f : mesh.faces()) {
      center_.push_back(center(mesh, f));
      normal_.push_back(normal(mesh, f));
      boxes.emplace_back(center_.back());
    }
    tree_.emplace(boxes);
  }

  int operator()(const Vec3& p, const Vec3& normal) const {
    double least = std::numeric_limits<double>::infinity();
    int nearest = 0;
    tree_->nearest(p, [&](int i) {
      const double distance = (center_[i] - p).norm();
      if (normal_[i].dot(normal) < 0) return std::numeric_limits<double>::infinity();
      if (distance < least) least = distance, nearest = i;
      return distance;
    });
    return nearest;
  }

 private:
  std::vector<Vec3> center_, normal_;
  std::optional<BoxTree> tree_;
};

// All but the largest piece of every part go to the neighbour they share most seam with, until none is loose.
std::vector<int> without_loose_pieces(const Mesh& mesh, const DualGraph& graph, std::vector<int> part) {
  while (true) {
    const std::vector<int> piece = connected_pieces(mesh, part);
    std::map<int, double> area;
    std::map<int, int> part_of, largest;
    for (int f = 0; f < graph.num_faces(); ++f) area[piece[f]] += graph.area(f), part_of[piece[f]] = part[f];
    for (const auto& [p, a] : area)
      if (const auto [at, is_new] = largest.try_emplace(part_of[p], p); !is_new && a > area[at->second]) at->second = p;
    std::map<int, std::map<int, double>> beside;  // of loose pieces: seam with each part
    for (int f = 0; f < graph.num_faces(); ++f)
      if (largest[part[f]] != piece[f])
        for (const DualGraph::Arc& arc : graph.arcs(f))
          if (piece[arc.to] != piece[f]) beside[piece[f]][part[arc.to]] += arc.distance;
    if (beside.empty()) return part;
    const auto& [loose, with] = *beside.begin();
    const int to = std::max_element(with.begin(), with.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
    for (int f = 0; f < graph.num_faces(); ++f)
      if (piece[f] == loose) part[f] = to;
  }
}

std::vector<int> limbs_of(const Mesh& mesh, const DualGraph& graph, const std::vector<int>& start,
                          const NeckCutOptions& options, const Run& run) {
  return cut_by_thickness(mesh, graph, cut_limbs(graph, start, options, run), options, run);
}

}  // namespace

std::vector<int> cut_limbs_of(const Mesh& mesh, const DualGraph& graph, const NeckCutOptions& options, const Run& run) {
  const Components whole = components(mesh);
  if (mesh.num_faces() < kCoarseFrom || whole.count > 1 || options.max_parts == 1)
    return limbs_of(mesh, graph, whole.of_face, options, run);
  run.report("looking at the shape with fewer faces", 0);
  const Mesh coarse = coarse_of(mesh);
  const std::vector<int> coarse_part = limbs_of(coarse, DualGraph(coarse), components(coarse).of_face, options, run);
  const NearestFace nearest(coarse);
  std::vector<int> part;
  for (FaceId f : mesh.faces()) part.push_back(coarse_part[nearest(center(mesh, f), normal(mesh, f))]);
  part = without_loose_pieces(mesh, graph, std::move(part));
  settle_seams(graph, whole.of_face, part, {.min_area = 0});
  return connected_pieces(mesh, part);
}

}  // namespace plico
