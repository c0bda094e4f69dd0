// How commands that unfold read meshes: as files are, with what has one harmless remedy done and told.
#pragma once
#include <string>

#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/mesh.h"
#include "plico/mesh/paint.h"
#include "plico/workflow/jobs/job.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

// Adds --repair safe|full|none.
Job& add_repair_option(Job& job, std::string& repair);

// Says every repair on standard error and in the report ("repairs"). Throws InvalidInput for what remains wrong, with
// its place in the file when nothing was repaired before.
Mesh read_mesh(const std::string& path, const std::string& repair, Session& session);

// The same with the colours and pictures of the file and of files beside it; what of them is left out is told.
struct PaintedMesh {
  Mesh mesh;
  Paint paint;
};
PaintedMesh read_painted_mesh(const std::string& path, const std::string& repair, Session& session);
Paint read_paint_of(const std::string& path, Session& session);  // of a file that was read already

// Warns at once of a mesh that nobody can fold by hand: what it takes, and how to make it smaller.
inline constexpr int kFarTooMany = 20'000;  // faces
void warn_of_many_faces(const Mesh& mesh, const std::string& path, Session& session);

// The format of a mesh that is written to this path, OBJ for standard output. Throws InvalidOption.
MeshFormat output_format(const std::string& path);

// Neighbouring faces that lie in one plane as one (mesh/flat_regions.h), said and in the report ("flat_regions"); the
// mesh as it is where there are none, or where that would make no surface.
Mesh with_flat_regions_whole(Mesh mesh, Session& session);

// The mesh that a net of so many panels is held against: as the file is, or as craft takes it, with flat regions whole.
Mesh read_mesh_of_net(const std::string& path, const std::string& repair, int panels, Session& session);

}  // namespace plico::jobs
