#include "terminal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace plico::cli {
namespace {

using jobs::SharedOptions;
using jobs::Tone;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

TEST(Terminal, TheFirstInterruptAsksToStop) {
  const Terminal terminal{SharedOptions{}};
  const plico::Run run = terminal.run();
  EXPECT_FALSE(run.over());
  kill(getpid(), SIGINT);
  for (int i = 0; i < 1000 && !run.over(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(run.ending(), Ending::Stopped);
}

SharedOptions with_json() {
  SharedOptions shared;
  shared.json = true;
  return shared;
}

SharedOptions with_output_on_stdout() {
  SharedOptions shared;
  shared.outputs = {"-"};
  return shared;
}

SharedOptions quiet(const std::string& progress = "auto") {
  SharedOptions shared;
  shared.quiet = true;
  shared.progress = progress;
  return shared;
}

TEST(Terminal, HumanTextNeverMixesWithResultsOnStandardOutput) {
  CaptureStdout();
  CaptureStderr();
  Terminal(SharedOptions{}).tell({Tone::Result, "one\n"});
  Terminal(with_json()).tell({Tone::Result, "two\n"});
  Terminal(with_output_on_stdout()).tell({Tone::Result, "three\n"});
  Terminal(quiet()).tell({Tone::Line, "four"});
  Terminal(SharedOptions{}).tell({Tone::Detail, "five"});
  Terminal(SharedOptions{}).tell({Tone::Warning, "six"});
  EXPECT_EQ(GetCapturedStdout(), "one\n");
  EXPECT_EQ(GetCapturedStderr(), "three\nplico: warning: six\n");
}

TEST(Terminal, ProgressIsOneJsonObjectALine) {
  CaptureStderr();
  SharedOptions shared;
  shared.progress = "json";
  const Terminal terminal(shared);
  terminal.run().report("growing", 1, 4, "2 overlaps");
  terminal.run().report("growing", 2, 4);  // too soon after the first
  terminal.run().report("growing", 4, 4);  // the last is always told
  EXPECT_EQ(GetCapturedStderr(),
            "{\"done\":1,\"note\":\"2 overlaps\",\"phase\":\"growing\",\"total\":4}\n"
            "{\"done\":4,\"phase\":\"growing\",\"total\":4}\n");
}

TEST(Terminal, QuietSilencesProgress) { EXPECT_EQ(Terminal(quiet("plain")).run().progress, nullptr); }

}  // namespace
}  // namespace plico::cli
