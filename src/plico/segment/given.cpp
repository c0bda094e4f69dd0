#include "plico/segment/given.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

void require_one_a_face(const Mesh& mesh, std::size_t labels) {
  if (static_cast<int>(labels) != mesh.num_faces())
    throw InvalidInput("segment/labels", fmt::format("there are {} labels for {} faces", labels, mesh.num_faces()), {},
                       "give one label for each face of this mesh");
}

// Pieces of one group are told apart by a number, parts without a group have the next free letter.
std::vector<std::string> names_of_pieces(const std::vector<int>& group_of_part, const std::vector<std::string>& names) {
  std::set<std::string> used(names.begin(), names.end());
  std::map<int, int> pieces;
  std::vector<std::string> result;
  int letter = 0;
  for (int group : group_of_part) {
    std::string name = names[group];
    int number = name.empty() ? 0 : ++pieces[group];
    if (name.empty()) {
      do name = part_name(letter++);
      while (used.contains(name));
    } else if (number > 1) {
      do name = fmt::format("{}-{}", names[group], number++);
      while (used.contains(name));
    }
    used.insert(name);
    result.push_back(name);
  }
  return result;
}

}  // namespace

Segmentation by_components(const Mesh& mesh) { return segmentation_by_labels(mesh, components(mesh).of_face); }

Segmentation by_groups(const Mesh& mesh, const std::vector<int>& group, const std::vector<std::string>& names) {
  require_one_a_face(mesh, group.size());
  Segmentation result = segmentation_by_labels(mesh, connected_pieces(mesh, group));
  std::vector<int> group_of_part(result.num_parts());
  for (FaceId f : mesh.faces()) group_of_part[result.part[f]] = group[f];
  result.names = names_of_pieces(group_of_part, names);
  return result;
}

Segmentation by_labels(const Mesh& mesh, const std::vector<int>& labels) {
  require_one_a_face(mesh, labels.size());
  return segmentation_by_labels(mesh, connected_pieces(mesh, labels));
}

std::vector<int> connected_pieces(const Mesh& mesh, const std::vector<int>& labels) {
  std::vector<int> piece(mesh.num_faces(), -1), queue;
  int count = 0;
  for (FaceId first : mesh.faces()) {
    if (piece[first] >= 0) continue;
    piece[first] = count;
    queue.assign(1, first);
    while (!queue.empty()) {
      const FaceId f(queue.back());
      queue.pop_back();
      for (HalfedgeId h : mesh.halfedges(f)) {
        const HalfedgeId twin = mesh.twin(h);
        if (!twin.valid() || piece[mesh.face(twin)] >= 0 || labels[mesh.face(twin)] != labels[f]) continue;
        piece[mesh.face(twin)] = count;
        queue.push_back(mesh.face(twin));
      }
    }
    ++count;
  }
  return piece;
}

}  // namespace plico
