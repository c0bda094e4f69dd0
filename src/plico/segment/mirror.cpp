#include "plico/segment/mirror.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

#include "plico/geom/box_tree.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/mirror_plane.h"

namespace plico {
namespace {

using FaceSet = std::vector<int>;  // ascending

constexpr double kSymmetric = 1e-5;  // of the diagonal: files are rounded

Vec3 surface_center(const Mesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (FaceId f : mesh.faces()) sum += area(mesh, f) * center(mesh, f);
  return sum / surface_area(mesh);
}

// The image of every point, empty when one has none.
std::vector<int> images_of_points(const std::vector<Vec3>& points, const BoxTree& tree, const Vec3& middle,
                                  const Vec3& across, double tolerance) {
  std::vector<int> image;
  for (const Vec3& p : points) {
    const Vec3 other = p - 2 * across.dot(p - middle) * across;
    double least = std::numeric_limits<double>::infinity();
    int nearest = -1;
    tree.nearest(other, [&](int i) {
      const double distance = (points[i] - other).norm();
      if (distance < least) least = distance, nearest = i;
      return distance;
    });
    if (!(least <= tolerance)) return {};
    image.push_back(nearest);
  }
  return image;
}

std::optional<std::vector<int>> images_of_faces(const Mesh& mesh, const std::vector<int>& point_image) {
  std::map<std::vector<int>, int> face_of;
  const auto corners = [&](FaceId f, bool mirrored) {
    std::vector<int> result;
    for (HalfedgeId h : mesh.halfedges(f)) result.push_back(mirrored ? point_image[mesh.from(h)] : int(mesh.from(h)));
    std::sort(result.begin(), result.end());
    return result;
  };
  for (FaceId f : mesh.faces()) face_of[corners(f, false)] = f;
  std::vector<int> image;
  for (FaceId f : mesh.faces()) {
    const auto at = face_of.find(corners(f, true));
    if (at == face_of.end()) return std::nullopt;
    image.push_back(at->second);
  }
  for (std::size_t f = 0; f < image.size(); ++f)
    if (image[image[f]] != static_cast<int>(f)) return std::nullopt;
  return image;
}

FaceSet without(const FaceSet& a, const FaceSet& b) {
  FaceSet rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

// Sides that are cut off a part, one or two, and how good that is.
struct MirroredCut {
  double score = std::numeric_limits<double>::infinity();
  std::vector<FaceSet> sides;
};

class MirroredCutter {
 public:
  MirroredCutter(const DualGraph& graph, const std::vector<int>& image, const NeckOptions& options)
      : graph_(graph), image_(image), options_(options) {}

  FaceSet mirrored(const FaceSet& side) const {
    FaceSet result;
    for (int f : side) result.push_back(image_[f]);
    std::sort(result.begin(), result.end());
    return result;
  }

  MirroredCut best(const FaceSet& faces) const {
    MirroredCut cut;
    const std::optional<Neck> neck = best_neck(graph_, faces, options_);
    if (!neck) return cut;
    if (mirrored(faces) != faces) return {neck->score, {neck->side}};
    const FaceSet other = mirrored(neck->side);
    FaceSet all, both;
    std::set_union(neck->side.begin(), neck->side.end(), other.begin(), other.end(), std::back_inserter(all));
    std::set_intersection(neck->side.begin(), neck->side.end(), other.begin(), other.end(), std::back_inserter(both));
    consider_pair(faces, without(neck->side, other), cut);
    consider_single(faces, all, cut);
    consider_single(faces, both, cut);
    return cut;
  }

 private:
  // A side and its image, which leave something connected, or nothing.
  void consider_pair(const FaceSet& faces, const FaceSet& side, MirroredCut& cut) const {
    const std::optional<Neck> one = neck_at(graph_, faces, side, options_);
    if (!one || one->score >= cut.score) return;
    const FaceSet other = mirrored(one->side), rest = without(faces, one->side);
    if (without(one->side, other).size() != one->side.size()) return;
    if (other == rest) {
      cut = {one->score, {one->side}};
      return;
    }
    const std::optional<Neck> two = neck_at(graph_, rest, other, options_);
    if (two && (two->side == other || without(rest, two->side) == other)) cut = {one->score, {one->side, other}};
  }

  void consider_single(const FaceSet& faces, const FaceSet& side, MirroredCut& cut) const {
    if (side.empty() || side.size() == faces.size()) return;
    const std::optional<Neck> neck = neck_at(graph_, faces, side, options_);
    if (neck && neck->score < cut.score && mirrored(neck->side) == neck->side) cut = {neck->score, {neck->side}};
  }

  const DualGraph& graph_;
  const std::vector<int>& image_;
  const NeckOptions& options_;
};

std::vector<FaceSet> sides_of(const std::vector<int>& part) {
  std::vector<FaceSet> parts;
  for (std::size_t f = 0; f < part.size(); ++f) {
    if (part[f] >= static_cast<int>(parts.size())) parts.resize(part[f] + 1);
    parts[part[f]].push_back(static_cast<int>(f));
  }
  return parts;
}

}  // namespace

std::optional<std::vector<int>> mirror_images(const Mesh& mesh) {
  const double tolerance = kSymmetric * diagonal(mesh);
  const std::vector<Vec3>& points = mesh.soup().points;
  if (mesh.num_faces() == 0 || !(surface_area(mesh) > 0)) return std::nullopt;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Vec3& p : points) boxes.emplace_back(p);
  const BoxTree tree(boxes);
  const Vec3 middle = surface_center(mesh);
  for (const Vec3& across : candidates_across(mesh, middle)) {
    const std::vector<int> of_points = images_of_points(points, tree, middle, across, tolerance);
    if (of_points.empty()) continue;
    if (auto image = images_of_faces(mesh, of_points)) return image;
  }
  return std::nullopt;
}

std::vector<int> cut_mirrored(const DualGraph& graph, std::vector<int> part, const std::vector<int>& image,
                              const NeckCutOptions& options, const Run& run) {
  const MirroredCutter cutter(graph, image, options.neck);
  std::vector<FaceSet> parts = sides_of(part);
  std::vector<MirroredCut> cuts;
  for (const FaceSet& faces : parts) cuts.push_back(cutter.best(faces));
  while (!run.over()) {
    const int count = static_cast<int>(parts.size());
    int best = -1;
    const auto adds = [&](int p) {
      return cutter.mirrored(parts[p]) != parts[p] ? 2 : static_cast<int>(cuts[p].sides.size());
    };
    for (int p = 0; p < count; ++p)
      if (cuts[p].score < options.worst_score && !cuts[p].sides.empty() && count + adds(p) <= options.max_parts)
        if (best < 0 || cuts[p].score < cuts[best].score) best = p;
    if (best < 0) break;
    const std::vector<FaceSet> sides = cuts[best].sides;
    const FaceSet twin = cutter.mirrored(parts[best]);
    const auto cut_off = [&](int p, const FaceSet& side) {
      parts[p] = without(parts[p], side);
      cuts[p] = cutter.best(parts[p]);
      parts.push_back(side);
      cuts.push_back(cutter.best(side));
    };
    if (twin != parts[best])
      cut_off(static_cast<int>(std::find(parts.begin(), parts.end(), twin) - parts.begin()),
              cutter.mirrored(sides.front()));
    for (const FaceSet& side : sides) cut_off(best, side);
    run.report("cutting at necks and their images", static_cast<long>(parts.size()), options.max_parts);
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (int f : parts[p]) part[f] = static_cast<int>(p);
  return part;
}

std::vector<int> mirror_partners(const std::vector<int>& part, const std::vector<int>& image) {
  std::vector<int> partner;
  for (const FaceSet& faces : sides_of(part)) {
    const int other = part[image[faces.front()]];
    const auto size = std::count(part.begin(), part.end(), other);
    const bool whole = size == static_cast<long>(faces.size()) &&
                       std::all_of(faces.begin(), faces.end(), [&](int f) { return part[image[f]] == other; });
    partner.push_back(whole ? other : -1);
  }
  return partner;
}

}  // namespace plico
