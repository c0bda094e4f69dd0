// A stacked chain as files.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plico/workflow/jobs/stack_options.h"
#include "plico/workflow/stack_motion.h"

namespace plico::jobs {

// Throws InvalidOption for a kind of file that a chain has not.
void check_stack_output(const std::string& path);

struct StackFiles {
  const StackArgs& args;
  const VoxelMesh& voxels;
  const StackedChain& chain;
  const std::optional<StackMotion>& motion;
};

// The sheets to cut are judged before anything is written: false when they are not sound. Their figures go into
// `report`.
bool write_stack_files(const StackFiles& what, const std::vector<std::string>& paths, Session& session,
                       nlohmann::json& report);

}  // namespace plico::jobs
