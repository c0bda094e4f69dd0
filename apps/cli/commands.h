// One function a command; each lives in the file of its name. commands.cpp lists them in the order of --help.
#pragma once
#include <vector>

#include "command.h"

namespace plico::cli {

std::vector<Command> all_commands();

}  // namespace plico::cli
