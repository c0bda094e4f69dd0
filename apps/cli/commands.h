// The commands: every job, and what only a command line has.
#pragma once
#include <vector>

#include "plico/workflow/jobs/job.h"

namespace plico::cli {

using jobs::Job;
using jobs::Option;
using jobs::Session;

Job studio_command();
Job man_command();
Job completions_command();

std::vector<Job> all_commands();  // in the order of --help

}  // namespace plico::cli
