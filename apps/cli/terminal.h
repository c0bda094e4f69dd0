// A job at a terminal: results go to files or standard output, talk and progress to standard error, Ctrl-C stops.
#pragma once
#include <memory>

#include "plico/workflow/jobs/session.h"
#include "progress.h"
#include "stop_signal.h"

namespace plico::cli {

class Terminal {
 public:
  // From here on Ctrl-C and SIGTERM ask the run to stop; a second one ends the program at once, and so does a job that
  // works on for a second without having begun to write.
  explicit Terminal(jobs::SharedOptions shared);
  ~Terminal();

  Run run() const;
  jobs::JobFiles& files();
  void tell(const jobs::Message& message) const;
  void end_work();  // the job is done: its progress line is erased, and it is not given up any more

 private:
  class Files;

  bool uses_stdout() const;
  void give_up(jobs::ExitCode exit_code);

  jobs::SharedOptions shared_;
  std::unique_ptr<Files> files_;
  std::unique_ptr<ShownProgress> progress_;
  StopSignal signal_;
};

}  // namespace plico::cli
