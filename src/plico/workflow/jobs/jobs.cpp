#include "plico/workflow/jobs/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/workflow/jobs/shared_options.h"
#include "plico/workflow/jobs/suggest.h"

namespace plico::jobs {
namespace {

Job job_named(const std::string& name) {
  std::vector<std::string> known;
  for (Job& job : all_jobs()) {
    if (job.name == name) return job;
    known.push_back(job.name);
  }
  throw InvalidOption(fmt::format("'{}' is not a job{}", name, did_you_mean(nearest_word(name, known))));
}

bool is_called(const Option& option, const std::string& name) {
  const std::string& own = option.long_name();
  return std::ranges::find(option.names, name) != option.names.end() || own.substr(own.find_first_not_of('-')) == name;
}

std::vector<Given> wanted(const Job& job, const std::vector<Option>& table, const Values& values) {
  std::vector<Given> result;
  for (const auto& [name, value] : values) {
    const auto found =
        std::ranges::find_if(table, [&name = name](const Option& option) { return is_called(option, name); });
    if (found == table.end()) throw InvalidOption(fmt::format("'{}' is not an option of {}", name, job.name));
    result.push_back({&*found, value});
  }
  return result;
}

// With the words of JSON Schema for bounds.
void put_range(nlohmann::json& option, const Range& range) {
  if (std::isfinite(range.least)) option[range.with_least ? "minimum" : "exclusiveMinimum"] = range.least;
  if (std::isfinite(range.most)) option[range.with_most ? "maximum" : "exclusiveMaximum"] = range.most;
}

nlohmann::json option_json(const Option& option) {
  nlohmann::json json = {
      {"name", option.long_name()},           {"value", option.value},       {"unit", option.unit},
      {"default", option.shown_default},      {"choices", option.choices},   {"help", option.help},
      {"positional", option.is_positional()}, {"required", option.required}, {"repeatable", option.repeatable}};
  put_range(json, option.range);
  return json;
}

}  // namespace

std::vector<Job> all_jobs() {
  // clang-format off
  return {
      craft_job(),
      info_job(),
      check_job(),
      simplify_job(),
      unfold_job(),
      edit_job(),
      segment_job(),
      shell_job(),
      inflate_job(),
      export_job(),
      fold_job(),
      print_job(),
      voxelize_job(),
      stack_job(),
      sample_job(),
      origami_make_job(),
      origami_info_job(),
      origami_gallery_job(),
      origami_settle_job(),
      origami_assign_job(),
      verify_job(),
  };
  // clang-format on
}

JobResult run_job(const std::string& name, const Values& values, JobFiles& files, const Run& run) {
  const Job job = job_named(name);
  SharedOptions shared;
  const std::vector<Option> table = with_shared_options(job, shared);
  std::vector<Given> given = set_options(job, table, wanted(job, table, values));
  check(shared);
  JobResult result;
  const auto listen = [&](const Message& message) { result.messages.push_back(message); };
  Session session(shared, job.name, std::move(given), {files, listen, run});
  result.exit_code = job.run(session);
  session.finish(result.exit_code);
  result.report = session.report().dump(2) + "\n";
  return result;
}

std::string describe_jobs() {
  SharedOptions shared;
  nlohmann::json all = nlohmann::json::array();
  for (const Job& job : all_jobs()) {
    nlohmann::json options = nlohmann::json::array();
    for (const Option& option : with_shared_options(job, shared)) options.push_back(option_json(option));
    all.push_back({{"name", job.name}, {"summary", job.summary}, {"examples", job.examples}, {"options", options}});
  }
  return all.dump(2) + "\n";
}

}  // namespace plico::jobs
