#include "plico/workflow/jobs/shared_options.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico::jobs {

std::vector<Option> shared_options(SharedOptions& shared) {
  Job table("", "");
  table
      .option("-o,--output", "FILE", "write the result here; the extension says the kind, - is standard output",
              shared.outputs)
      .flag("-f,--force", "overwrite files that exist", shared.force)
      .flag("--json", "print the report as one JSON object on standard output", shared.json)
      .option("--report", "FILE", "also write the report, as JSON, to this file", shared.report_file)
      .choice("--progress", "how progress is shown on standard error", shared.progress,
              {"auto", "bar", "plain", "json", "none"})
      .flag("-q,--quiet", "say nothing but errors", shared.quiet)
      .count("-v,--verbose", "say more; twice for still more", shared.verbose)
      .option("--seed", "N", "seed of everything random: same seed, same bytes", shared.seed)
      .option("--threads", "N", "threads to use, 0 for all cores; never changes results", shared.threads, at_least(0))
      .duration("--time-limit", "stop after this long and write the best so far: 30s, 2m, 1h", shared.time_limit);
  return table.options;
}

std::vector<Option> with_shared_options(const Job& job, SharedOptions& shared) {
  std::vector<Option> table = job.options;
  const auto used = [&](const Option& option) {
    return std::ranges::any_of(job.options, [&](const Option& own) {
      return std::ranges::find_first_of(own.names, option.names) != own.names.end();
    });
  };
  for (Option& option : shared_options(shared))
    if (!used(option)) table.push_back(std::move(option));
  return table;
}

void check(const SharedOptions& shared) {
  require(shared.threads >= 0, "--threads", shared.threads, "at least 0");
  const auto to_stdout = std::ranges::count(shared.outputs, "-") + (shared.report_file == "-") + shared.json;
  if (to_stdout > 1)
    throw InvalidOption("only one of -o -, --report - and --json can use standard output",
                        "write one of them to a file");
  for (auto path = shared.outputs.begin(); path != shared.outputs.end(); ++path)
    if (std::find(shared.outputs.begin(), path, *path) != path)
      throw InvalidOption(fmt::format("--output {} is given twice", *path), "give each output once");
  if (shared.quiet && shared.verbose > 0) throw InvalidOption("--quiet and --verbose contradict each other");
}

}  // namespace plico::jobs
