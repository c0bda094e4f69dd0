// How commands that unfold read meshes: as files are, with what has one harmless remedy done and told.
#pragma once
#include <string>

#include "command.h"
#include "plico/mesh/mesh.h"
#include "session.h"

namespace plico::cli {

// Adds --repair safe|full|none.
Command& add_repair_option(Command& command, std::string& repair);

// Says every repair on standard error and in the report ("repairs"). Throws InvalidInput for what remains wrong, with
// its place in the file when nothing was repaired before.
Mesh read_mesh(const std::string& path, const std::string& repair, Session& session);

}  // namespace plico::cli
