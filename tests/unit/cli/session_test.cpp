#include "session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "plico/base/error.h"
#include "shared_options.h"

namespace plico::cli {
namespace {

using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

// A session of "plico unfold" with a mesh and one option of its own, as run_program makes it.
class UnfoldSession {
 public:
  explicit UnfoldSession(const std::vector<std::string>& words) {
    command_.positional("mesh", "a mesh", mesh_).option("--rounds", "N", "how many", rounds_);
    table_ = with_shared_options(command_, shared_);
    std::vector<Given> given = parse(command_, table_, words);
    session_ = std::make_unique<Session>(shared_, "unfold", std::move(given));
  }
  Session* operator->() { return session_.get(); }

 private:
  std::string mesh_;
  int rounds_ = 3;
  Command command_{"unfold", "Unfold"};
  SharedOptions shared_;
  std::vector<Option> table_;
  std::unique_ptr<Session> session_;
};

// An empty folder that is gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "plico-session-XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

TEST(Session, RepeatsTheRunWithItsSeed) {
  UnfoldSession session({"my mesh.obj", "-o", "it's.fold", "--rounds", "5", "-q"});
  EXPECT_EQ(session->repeat_command(), "plico unfold 'my mesh.obj' --rounds 5 -o 'it'\\''s.fold' -q");
  session->seed();
  EXPECT_THAT(session->repeat_command(), HasSubstr(" --seed 1"));
}

TEST(Session, ARunCutByTimeRepeatsByItsLength) {
  UnfoldSession session({"a.obj", "--time-limit", "1s", "--rounds", "1000"});
  session->repeat_with("--rounds", "17");
  EXPECT_EQ(session->repeat_command(), "plico unfold a.obj --rounds 17");
}

TEST(Session, ProvenanceDoesNotDependOnHowTheRunWasWatched) {
  const Folder folder;
  const std::string mesh = folder / "a.obj";
  std::ofstream(mesh) << "abc";
  const auto provenance = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {mesh, "--rounds", "5"});
    UnfoldSession session(words);
    session->seed();
    session->read(mesh);
    return session->provenance().dump();
  };
  const std::string plain = provenance({});
  EXPECT_EQ(plain, provenance({"--threads", "2", "-o", "x", "-f", "--time-limit", "9s", "--progress", "none", "-v"}));
  EXPECT_NE(plain, provenance({"--seed", "2"}));
  EXPECT_THAT(plain, HasSubstr("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
}

TEST(Session, RefusesToOverwriteBeforeTheWork) {
  const Folder folder;
  const std::string old = folder / "old.fold";
  std::ofstream(old) << "old";
  EXPECT_THROW(UnfoldSession({"a.obj", "-o", old})->outputs(""), FileError);
  EXPECT_EQ(UnfoldSession({"a.obj", "-o", old, "-f"})->outputs(""), std::vector<std::string>{old});
  EXPECT_THROW(UnfoldSession({"a.obj", "-o", folder / "no/such.fold"})->outputs(""), FileError);
  EXPECT_EQ(UnfoldSession({"a.obj"})->outputs("-"), std::vector<std::string>{"-"});
  EXPECT_TRUE(UnfoldSession({"a.obj"})->outputs("").empty());
}

TEST(Session, AnOutputFolderIsMadeAndMustBeEmpty) {
  const Folder folder;
  const std::string made = folder / "a/b";
  EXPECT_EQ(UnfoldSession({"a.obj", "-o", made})->output_folder("default"), made);
  EXPECT_TRUE(std::filesystem::is_directory(made));
  std::ofstream(made + "/old") << "old";
  EXPECT_THROW(UnfoldSession({"a.obj", "-o", made})->output_folder("default"), FileError);
  EXPECT_EQ(UnfoldSession({"a.obj", "-o", made, "-f"})->output_folder("default"), made);
  EXPECT_THROW(UnfoldSession({"a.obj", "-o", made + "/old"})->output_folder("default"), FileError);
}

TEST(Session, TheFirstInterruptAsksToStop) {
  UnfoldSession session({"a.obj"});
  const plico::Run run = session->run();
  EXPECT_FALSE(run.over());
  kill(getpid(), SIGINT);
  for (int i = 0; i < 1000 && !run.over(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(run.ending(), Ending::Stopped);
  EXPECT_EQ(Session::exit_code(run.ending()), 130);
}

TEST(Session, TheTimeLimitIsADeadline) {
  UnfoldSession session({"a.obj", "--time-limit", "1ms", "--threads", "3"});
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const plico::Run run = session->run();
  EXPECT_TRUE(run.over());
  EXPECT_EQ(Session::exit_code(run.ending()), 5);
  EXPECT_EQ(run.threads, 3);
  EXPECT_FALSE(UnfoldSession({"a.obj"})->run().deadline.has_value());
}

TEST(Session, HumanTextNeverMixesWithResultsOnStandardOutput) {
  CaptureStdout();
  CaptureStderr();
  UnfoldSession({"a.obj"})->print("one\n");
  UnfoldSession({"a.obj", "--json"})->print("two\n");
  UnfoldSession({"a.obj", "-o", "-"})->print("three\n");
  UnfoldSession({"a.obj", "-q"})->say("four");
  EXPECT_EQ(GetCapturedStdout(), "one\n");
  EXPECT_EQ(GetCapturedStderr(), "three\n");
}

TEST(Session, ProgressIsOneJsonObjectALine) {
  CaptureStderr();
  UnfoldSession session({"a.obj", "--progress", "json"});
  session->run().report("growing", 1, 4, "2 overlaps");
  session->run().report("growing", 2, 4);  // too soon after the first
  session->run().report("growing", 4, 4);  // the last is always told
  EXPECT_EQ(GetCapturedStderr(),
            "{\"done\":1,\"note\":\"2 overlaps\",\"phase\":\"growing\",\"total\":4}\n"
            "{\"done\":4,\"phase\":\"growing\",\"total\":4}\n");
}

TEST(Session, QuietSilencesProgress) {
  EXPECT_EQ(UnfoldSession({"a.obj", "-q", "--progress", "plain"})->run().progress, nullptr);
}

}  // namespace
}  // namespace plico::cli
