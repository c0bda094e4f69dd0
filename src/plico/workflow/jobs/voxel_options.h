// How fine voxels are and what they make of a mesh: the options that voxelize and stack share.
#pragma once
#include <string>

#include "plico/workflow/jobs/job.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/voxel_mesh.h"

namespace plico::jobs {

struct VoxelArgs {
  std::string mesh, pair = "solid";
  Resolution resolution;
};

// Adds the mesh and --cells, --size, --squares, --refine, --pair.
Job& add_voxel_options(Job& job, VoxelArgs& args);

VoxelPieces read_voxels(const VoxelArgs& args, Session& session);

}  // namespace plico::jobs
