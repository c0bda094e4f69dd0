// How fine voxels are and what they make of a mesh: the options that voxelize and stack share.
#pragma once
#include <string>

#include "command.h"
#include "plico/workflow/voxel_mesh.h"
#include "session.h"

namespace plico::cli {

struct VoxelArgs {
  std::string mesh, pair = "solid";
  Resolution resolution;
};

// Adds the mesh and --cells, --size, --squares, --refine, --pair.
Command& add_voxel_options(Command& command, VoxelArgs& args);

VoxelMesh read_voxels(const VoxelArgs& args, Session& session);

}  // namespace plico::cli
