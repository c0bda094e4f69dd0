// A job at a terminal: results go to files or standard output, talk and progress to standard error, Ctrl-C stops.
#pragma once
#include <memory>

#include "plico/workflow/jobs/session.h"
#include "stop_signal.h"

namespace plico::cli {

class Terminal {
 public:
  // From here on Ctrl-C and SIGTERM ask the run to stop; a second one ends the program at once.
  explicit Terminal(jobs::SharedOptions shared);

  Run run() const;
  void tell(const jobs::Message& message) const;
  void end_progress();  // erases its line

 private:
  bool uses_stdout() const;

  jobs::SharedOptions shared_;
  StopSignal signal_;
  std::unique_ptr<Progress> progress_;
};

}  // namespace plico::cli
