#include "program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "plico/base/error.h"
#include "plico/workflow/jobs/session.h"

namespace plico::cli {
namespace {

using jobs::Job;
using jobs::kDone;
using jobs::kNo;
using jobs::Session;

using testing::HasSubstr;
using testing::StartsWith;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

struct Outcome {
  int exit_code;
  std::string out, err;
};

Outcome run(const std::vector<Job>& commands, const std::vector<std::string>& words) {
  CaptureStdout();
  CaptureStderr();
  const int exit_code = run_program(commands, words);
  return {exit_code, GetCapturedStdout(), GetCapturedStderr()};
}

Job acting(const std::string& name, std::function<int(Session&)> action) {
  return Job(name, "Act").example("plico " + name, "an example").action(std::move(action));
}

template <class Failure>
Job throwing(const Failure& failure) {
  return acting("act", [failure](Session&) -> int { throw failure; });
}

TEST(Program, EveryKindOfFailureHasItsExitCode) {
  EXPECT_EQ(run({throwing(InvalidOption("n = 0 must be at least 1"))}, {"act"}).exit_code, 2);
  EXPECT_EQ(run({throwing(InvalidInput("mesh/empty", "no faces"))}, {"act"}).exit_code, 3);
  EXPECT_EQ(run({throwing(FileError("file/read", "cannot read a.obj"))}, {"act"}).exit_code, 4);
  EXPECT_EQ(run({throwing(std::logic_error("internal error"))}, {"act"}).exit_code, 70);
  EXPECT_EQ(run({throwing(std::bad_alloc())}, {"act"}).exit_code, 71);
  EXPECT_THAT(run({throwing(std::bad_alloc())}, {"act"}).err, StartsWith("plico: system/memory: out of memory"));
  const std::system_error no_thread(std::make_error_code(std::errc::resource_unavailable_try_again));
  EXPECT_EQ(run({throwing(no_thread)}, {"act"}).exit_code, 71);
  EXPECT_EQ(run({acting("act", [](Session&) { return int{kNo}; })}, {"act"}).exit_code, 1);
}

TEST(Program, AFailureNamesCodePlaceAndWhatToTry) {
  const Job act = throwing(InvalidInput("mesh/fan", "two fans meet", "vertex 7 (near 1 2 3)", "plico check --repair"));
  const Outcome plain = run({act}, {"act"});
  EXPECT_EQ(plain.err,
            "plico: mesh/fan: two fans meet\n  where: vertex 7 (near 1 2 3)\n  try:   plico check --repair\n");
  EXPECT_EQ(plain.out, "");
  const Outcome json = run({act}, {"act", "--json"});
  const nlohmann::json object = nlohmann::json::parse(json.out);
  EXPECT_EQ(object["error"]["where"], "vertex 7 (near 1 2 3)");
  EXPECT_EQ(object["exit_code"], 3);
  EXPECT_EQ(json.err, plain.err);
}

TEST(Program, TheReportHasWhatTheCommandAdds) {
  const Job act = acting("act", [](Session& session) {
    session.report()["faces"] = 12;
    return int{kDone};
  });
  const nlohmann::json report = nlohmann::json::parse(run({act}, {"act", "--json"}).out);
  EXPECT_EQ(report["faces"], 12);
  EXPECT_EQ(report["command"], "act");
  EXPECT_EQ(report["exit_code"], 0);
}

TEST(Program, CommandsOfTwoWordsFormAGroup) {
  const auto done = [](int code) { return [code](Session&) { return code; }; };
  const std::vector<Job> commands = {acting("sheet info", done(0)), acting("sheet make", done(1)),
                                     acting("sheer", done(5))};
  EXPECT_EQ(run(commands, {"sheet", "make"}).exit_code, 1);
  EXPECT_EQ(run(commands, {"sheer"}).exit_code, 5);
  EXPECT_THAT(run(commands, {"sheet"}).err, HasSubstr("plico sheet needs one of: info, make\n"));
  EXPECT_THAT(run(commands, {"sheet", "mkae"}).err, HasSubstr("did you mean 'make'?"));
  EXPECT_THAT(run(commands, {"sheet", "--help"}).out, HasSubstr("sheet make"));
  EXPECT_THAT(run(commands, {"help", "sheet", "make"}).out,
              StartsWith("Examples:\n  # an example\n  plico sheet make\n"));
}

}  // namespace
}  // namespace plico::cli
