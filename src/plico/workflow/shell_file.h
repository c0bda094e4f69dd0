// The squares around a solid of voxels as a FOLD file, and back: what was voxelized once, or made elsewhere.
#pragma once
#include <string>
#include <string_view>

#include "plico/workflow/voxel_mesh.h"

namespace plico {

// The squares as faces of a folded form, counter-clockwise seen from outside; how squares are joined where four meet
// stands under plico:shell, with `report` (one JSON object, may be empty) under plico:report.
std::string write_shell_file(const VoxelMesh& voxels, const std::string& report = {});

// Does this look like a FOLD file, not like one of a mesh?
bool is_shell_file(std::string_view bytes, const std::string& name);

// Any FOLD file whose faces are equal squares along the axes, in one lattice, that bound a solid; then every voxel is
// cut into refine x refine x refine. `pairing` is for files that do not say theirs. Throws InvalidInput ("shell/...")
// with the face at fault; `name` is for messages. O(faces + voxels).
VoxelPieces read_shell_file(std::string_view bytes, const std::string& name, int refine, Pairing pairing);

}  // namespace plico
