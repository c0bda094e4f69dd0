// The options that every command has, as rows of the same table as its own.
#pragma once
#include <vector>

#include "plico/workflow/jobs/job.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

// The shared rows; setting them fills `shared`, which must outlive them.
std::vector<Option> shared_options(SharedOptions& shared);

// The command's own rows, then the shared rows whose names it does not use itself.
std::vector<Option> with_shared_options(const Job& job, SharedOptions& shared);

// Throws InvalidOption when they contradict each other.
void check(const SharedOptions& shared);

}  // namespace plico::jobs
