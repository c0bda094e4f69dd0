#include "commands.h"

#include "help.h"

namespace plico::cli {

std::vector<Command> all_commands() {
  // clang-format off
  return {
      craft_command(),
      info_command(),
      check_command(),
      simplify_command(),
      unfold_command(),
      segment_command(),
      shell_command(),
      inflate_command(),
      export_command(),
      fold_command(),
      print_command(),
      voxelize_command(),
      stack_command(),
      sample_command(),
      origami_make_command(),
      origami_info_command(),
      origami_gallery_command(),
      verify_command(),
      man_command(),
      completions_command(),
  };
  // clang-format on
}

std::vector<std::pair<std::string, std::string>> program_examples() {
  return {{"plico craft bird.obj -o bird", "from a mesh to printable pages, all in one folder"},
          {"plico unfold bird.obj -o bird.fold", "only the net, in a FOLD file"},
          {"plico man | man -l -", "everything there is to know"}};
}

}  // namespace plico::cli
