#include "plico/mesh/segmentation.h"

#include <algorithm>
#include <map>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"

namespace plico {

std::vector<std::vector<FaceId>> faces_of_parts(const Segmentation& segmentation) {
  std::vector<std::vector<FaceId>> faces(segmentation.num_parts());
  for (std::size_t f = 0; f < segmentation.part.size(); ++f)
    faces[segmentation.part[f]].push_back(FaceId(static_cast<int>(f)));
  return faces;
}

std::vector<EdgeId> seams(const Mesh& mesh, const Segmentation& segmentation) {
  std::vector<EdgeId> between;
  for (EdgeId e : mesh.edges()) {
    if (mesh.is_boundary(e)) continue;
    const HalfedgeId h = mesh.halfedge(e);
    if (segmentation.part[mesh.face(h)] != segmentation.part[mesh.face(mesh.twin(h))]) between.push_back(e);
  }
  return between;
}

Segmentation segmentation_by_labels(const Mesh& mesh, const std::vector<int>& labels) {
  if (static_cast<int>(labels.size()) != mesh.num_faces())
    throw InvalidInput("segment/labels",
                       fmt::format("there are {} labels for {} faces", labels.size(), mesh.num_faces()), {},
                       "give one label for each face of this mesh");
  struct Part {
    double area = 0;
    int first = 0;  // face
    int label = 0;
  };
  std::map<int, Part> found;
  for (FaceId f : mesh.faces()) {
    Part& part = found.try_emplace(labels[f], Part{0, f, labels[f]}).first->second;
    part.area += area(mesh, f);
  }
  std::vector<Part> parts;
  for (const auto& [label, part] : found) parts.push_back(part);
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.area != b.area ? a.area > b.area : a.first < b.first; });
  std::map<int, int> number;
  Segmentation result;
  for (const Part& part : parts) {
    number[part.label] = static_cast<int>(number.size());
    result.names.push_back(part_name(result.num_parts()));
  }
  for (int label : labels) result.part.push_back(number[label]);
  return result;
}

std::string part_name(int n) {
  std::string name;
  for (int i = n; i >= 0; i = i / 26 - 1) name.insert(name.begin(), static_cast<char>('A' + i % 26));
  return name;
}

}  // namespace plico
