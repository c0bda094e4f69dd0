#include "commands.h"

#include "help.h"
#include "plico/workflow/jobs/jobs.h"

namespace plico::cli {

std::vector<Job> all_commands() {
  std::vector<Job> commands = jobs::all_jobs();
  commands.push_back(studio_command());
  commands.push_back(man_command());
  commands.push_back(completions_command());
  return commands;
}

std::vector<std::pair<std::string, std::string>> program_examples() {
  return {{"plico craft bird.obj -o bird", "from a mesh to printable pages, all in one folder"},
          {"plico unfold bird.obj -o bird.fold", "only the net, in a FOLD file"},
          {"plico man | man -l -", "everything there is to know"}};
}

}  // namespace plico::cli
