#include "plico/workflow/jobs/jobs.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "plico/base/error.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/shared_options.h"

namespace plico::jobs {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kTetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

MemoryFiles with_tetrahedron() {
  MemoryFiles files;
  files.files["t.off"] = kTetrahedron;
  return files;
}

TEST(RunJob, MakesTheFilesAndTheReportWithoutATerminal) {
  MemoryFiles files = with_tetrahedron();
  const JobResult net = run_job("unfold", {{"mesh", "t.off"}, {"output", "t.fold"}}, files);
  EXPECT_EQ(net.exit_code, kDone);
  const json report = json::parse(net.report);
  EXPECT_EQ(report["faces"], 4);
  EXPECT_EQ(report["verified"], true);
  EXPECT_EQ(report["outputs"], json::array({"t.fold"}));
  EXPECT_EQ(report["command_line"], "plico unfold t.off -o t.fold --seed 1");
  EXPECT_THAT(net.messages, testing::Contains(testing::Field(&Message::text, HasSubstr("4 faces: 1 part"))));
  const JobResult pages = run_job("print", {{"net", "t.fold"}, {"-o", "t.svg"}, {"--height", "5cm"}}, files);
  EXPECT_EQ(pages.exit_code, kDone);
  EXPECT_THAT(files.files["t.svg"], HasSubstr("<svg"));
}

TEST(RunJob, TheSameRequestGivesTheSameBytes) {
  const auto made = [] {
    MemoryFiles files = with_tetrahedron();
    run_job("craft", {{"mesh", "t.off"}, {"output", "kit"}}, files);
    return files.files;
  };
  const auto first = made();
  EXPECT_EQ(first, made());
  EXPECT_TRUE(first.contains("kit/index.html"));
  EXPECT_TRUE(first.contains("kit/t.pdf"));
}

TEST(RunJob, RefusesWhatNoJobOrOptionIsCalled) {
  MemoryFiles files = with_tetrahedron();
  EXPECT_THROW(run_job("unfodl", {}, files), InvalidOption);
  EXPECT_THROW(run_job("unfold", {{"mesh", "t.off"}, {"roundz", "3"}}, files), InvalidOption);
  EXPECT_THROW(run_job("unfold", {}, files), InvalidOption);
  EXPECT_THROW(run_job("unfold", {{"mesh", "t.off"}, {"starts", "many"}}, files), InvalidOption);
  EXPECT_THROW(run_job("unfold", {{"mesh", "none.off"}}, files), FileError);
  EXPECT_EQ(files.files.size(), 1u);
}

TEST(RunJob, AnyoneMayStopIt) {
  MemoryFiles files = with_tetrahedron();
  std::stop_source stop;
  stop.request_stop();
  plico::Run run;
  run.stop = stop.get_token();
  EXPECT_EQ(run_job("craft", {{"mesh", "t.off"}, {"output", "kit"}}, files, run).exit_code, kInterrupted);
}

TEST(DescribeJobs, NamesEveryOptionOnceWithWhatAFormNeeds) {
  const json all = json::parse(describe_jobs());
  EXPECT_EQ(all.size(), all_jobs().size());
  for (const json& job : all) {
    EXPECT_GE(job["examples"].size(), 1u) << job["name"];
    std::set<std::string> names;
    for (const json& option : job["options"]) {
      EXPECT_TRUE(names.insert(option["name"]).second) << job["name"] << " " << option["name"];
      EXPECT_FALSE(option["help"].get<std::string>().empty()) << job["name"] << " " << option["name"];
    }
  }
  const auto length = std::ranges::find(all[0]["options"], "--height", [](const json& o) { return o["name"]; });
  EXPECT_EQ((*length)["unit"], "mm");
  EXPECT_EQ((*length)["exclusiveMinimum"], 0);
  EXPECT_FALSE((*length).contains("maximum"));
}

// The values on either side of a bound, in the option's unit; a whole step further for whole numbers.
std::vector<std::pair<double, bool>> around_bounds(const Range& range) {
  std::vector<std::pair<double, bool>> values;
  if (std::isfinite(range.least))
    values.insert(values.end(), {{range.least - 1, false}, {range.least, range.with_least}});
  if (std::isfinite(range.most)) values.insert(values.end(), {{range.most, range.with_most}, {range.most + 1, false}});
  return values;
}

void expect_range_kept(const Job& job, const Option& option) {
  for (const auto& [value, taken] : around_bounds(option.range)) {
    const std::string text = fmt::format("{:.17g}", value);
    try {
      const std::vector<Option> table{option};
      set_options(job, table, {{&table.front(), text}});
      EXPECT_TRUE(taken) << job.name << " " << option.long_name() << " " << text;
    } catch (const InvalidOption& error) {
      EXPECT_FALSE(taken) << error.what();
      EXPECT_TRUE(std::string(error.what()).starts_with(option.long_name())) << error.what();
    }
  }
}

TEST(Options, TakeTheirBoundsOnlyIfTheRangeDoesAndNothingBeyond) {
  int ranges = 0;
  SharedOptions shared;
  for (const Job& job : all_jobs()) {
    for (const Option& option : with_shared_options(job, shared)) {
      if (!option.range.is_bounded()) continue;
      ++ranges;
      expect_range_kept(job, option);
    }
  }
  EXPECT_GT(ranges, 60);
}

TEST(Options, WithANumberOutOfRangeAreRefusedBeforeAFileIsRead) {
  MemoryFiles files;
  try {
    run_job("stack", {{"mesh", "none.off"}, {"thickness", "0.5"}}, files);
    FAIL() << "a thickness of half a side was taken";
  } catch (const InvalidOption& error) {
    EXPECT_STREQ(error.what(), "--thickness: 0.5 must be in (0, 0.5)");
  }
}

}  // namespace
}  // namespace plico::jobs
