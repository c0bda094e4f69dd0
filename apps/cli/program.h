// The whole program behind main(): finds the command, reads its options, runs it, turns errors into exit codes.
#pragma once
#include <string>
#include <vector>

#include "plico/workflow/jobs/job.h"

namespace plico::cli {

// `words` is the command line without the program's name. Returns the exit code (session.h).
int run_program(const std::vector<jobs::Job>& commands, const std::vector<std::string>& words);

}  // namespace plico::cli
