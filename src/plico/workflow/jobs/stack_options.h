// What plico stack is asked for, and what its words mean for a shape of voxels.
#pragma once
#include <string>

#include "plico/workflow/jobs/voxel_options.h"
#include "plico/workflow/stack_mesh.h"

namespace plico::jobs {

struct StackArgs : VoxelArgs {
  std::string base = "auto", box, motion, page = "A4", solid = "stack";
  std::string thickness = "0.1", trim;  // in voxel sides, or with a unit: of squares with sides of `side_mm`
  double side_mm = 25;
  bool all = false;  // a chain of each piece
};

// Adds all of them, those of voxels too.
Job& add_stack_options(Job& job, StackArgs& args);

// Thickness and trim in voxel sides; the base as given, or none for "auto". Throws InvalidOption for whatever is wrong
// before there are voxels.
StackMeshOptions stacking_of(const StackArgs& args, const Session& session);

// What a thickness in millimetres is in voxel sides, a line; empty when it was given so.
std::string thickness_text(const StackArgs& args, const StackMeshOptions& options);

// Sets the best base whose ideal stack fits into --box; how many layers do. Throws InvalidOption when none does.
int choose_base_in_box(const StackArgs& args, const VoxelMesh& voxels, StackMeshOptions& options);

}  // namespace plico::jobs
