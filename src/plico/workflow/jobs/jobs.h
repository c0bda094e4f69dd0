// All jobs: what Plico does, from options and files to a report and files. The command line runs them, and so can any
// program. One function a job; each lives in the file of its name.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "plico/workflow/jobs/job.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

Job craft_job();
Job info_job();
Job check_job();
Job simplify_job();
Job unfold_job();
Job edit_job();
Job segment_job();
Job shell_job();
Job inflate_job();
Job sample_job();
Job export_job();
Job fold_job();
Job verify_job();
Job voxelize_job();
Job stack_job();
Job origami_make_job();
Job origami_info_job();
Job origami_gallery_job();
Job origami_settle_job();
Job origami_assign_job();
Job print_job();

/// In the order of --help. Each call makes new ones, with all options at their defaults.
std::vector<Job> all_jobs();

/// Options by name, with or without dashes, as on the command line: {"mesh", "bird.obj"}, {"height", "20cm"}.
using Values = std::vector<std::pair<std::string, std::string>>;

struct JobResult {
  int exit_code = kDone;
  std::string report;  // one JSON object, as --json prints it
  std::vector<Message> messages;
};

/// Runs a job: `files` holds its inputs and receives its results. Throws as the library does: InvalidOption on an
/// unknown job or option, a missing or bad value; InvalidInput; FileError.
JobResult run_job(const std::string& name, const Values& values, JobFiles& files, const Run& run = {});

/// All jobs with their options as JSON: [{"name", "summary", "examples", "options": [{"name", "value", "unit",
/// "default", "choices", "help", "required", "repeatable", "positional"}]}], for forms and packages in other languages.
std::string describe_jobs();

}  // namespace plico::jobs
