// One function a command; each lives in the file of its name. commands.cpp lists them in the order of --help.
#pragma once
#include <vector>

#include "command.h"

namespace plico::cli {

Command craft_command();
Command info_command();
Command check_command();
Command simplify_command();
Command unfold_command();
Command segment_command();
Command shell_command();
Command inflate_command();
Command sample_command();
Command export_command();
Command fold_command();
Command verify_command();
Command voxelize_command();
Command stack_command();
Command origami_make_command();
Command origami_info_command();
Command origami_gallery_command();
Command print_command();
Command man_command();
Command completions_command();

std::vector<Command> all_commands();

}  // namespace plico::cli
