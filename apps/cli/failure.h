// A failure as it is told to people and, with --json, to programs.
#pragma once
#include <string>

#include "plico/workflow/jobs/remedy.h"
#include "plico/workflow/jobs/session.h"

namespace plico::cli {

struct Failure {
  jobs::ExitCode exit_code = jobs::kInternal;
  std::string code, message, where, suggestion;
};

// The exception that is being handled, as a failure of `attempt`.
Failure current_failure(const jobs::Attempt& attempt = {});

// To standard error; with `json` also as one object to standard output.
void tell(const Failure& failure, bool json);

}  // namespace plico::cli
