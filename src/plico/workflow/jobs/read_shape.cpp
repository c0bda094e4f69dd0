#include "plico/workflow/jobs/read_shape.h"

#include "plico/convex/shape_parts.h"
#include "plico/io/mesh/face_groups.h"
#include "plico/io/mesh/mesh_file.h"

namespace plico::jobs {

std::vector<ShapePart> read_shape_parts(const std::string& shape, const std::string& by, const std::string& labels,
                                        Session& session) {
  const std::string bytes = session.read(shape);
  const MeshSource source = read_mesh_source(bytes, shape);
  const auto by_face = [&](const FaceGroups& groups) {
    return parts_by_groups(source.soup, groups.of_face, groups.names);
  };
  if (by == "labels") return by_face(read_face_labels(session.read(labels), labels));
  if (by == "groups") return by_face(read_obj_groups(bytes, shape));
  if (by == "auto" && has_obj_groups(bytes)) {
    const FaceGroups groups = read_obj_groups(bytes, shape);
    if (groups.names.size() > 1) return by_face(groups);
  }
  return parts_by_components(source.soup);
}

}  // namespace plico::jobs
