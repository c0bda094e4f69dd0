#include "terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "progress.h"

namespace plico::cli {

Terminal::Terminal(jobs::SharedOptions shared)
    : shared_(std::move(shared)), progress_(make_progress(shared_.quiet ? "none" : shared_.progress)) {}

Run Terminal::run() const {
  Run run;
  run.stop = signal_.token();
  run.progress = progress_.get();
  return run;
}

bool Terminal::uses_stdout() const {
  return shared_.json || shared_.report_file == "-" || std::ranges::find(shared_.outputs, "-") != shared_.outputs.end();
}

void Terminal::tell(const jobs::Message& message) const {
  switch (message.tone) {
    case jobs::Tone::Result:
      if (!uses_stdout())
        fmt::print(stdout, "{}", message.text);
      else if (!shared_.json && !shared_.quiet)
        fmt::print(stderr, "{}", message.text);
      return;
    case jobs::Tone::Detail:
      if (shared_.verbose > 0) fmt::print(stderr, "{}\n", message.text);
      return;
    case jobs::Tone::Line:
      if (!shared_.quiet) fmt::print(stderr, "{}\n", message.text);
      return;
    case jobs::Tone::Warning:
      if (!shared_.quiet) fmt::print(stderr, "plico: warning: {}\n", message.text);
      return;
  }
}

void Terminal::end_progress() { progress_.reset(); }

}  // namespace plico::cli
