#include "plico/workflow/jobs/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "plico/base/error.h"
#include "plico/workflow/jobs/shared_options.h"

namespace plico::jobs {
namespace {

using testing::HasSubstr;

// A session of an unfold job with a mesh and one option of its own, as run_job makes it.
class UnfoldSession {
 public:
  UnfoldSession(JobFiles& files, const std::vector<std::pair<std::string, std::string>>& values) {
    job_.positional("mesh", "a mesh", mesh_).option("--rounds", "N", "how many", rounds_);
    table_ = with_shared_options(job_, shared_);
    std::vector<Given> wanted;
    for (const auto& [name, value] : values) wanted.push_back({&named(name), value});
    session_.emplace(shared_, "unfold", set_options(job_, table_, wanted), Surroundings{files, {}, {}});
  }
  Session* operator->() { return &*session_; }

 private:
  const Option& named(const std::string& name) const {
    return *std::ranges::find_if(
        table_, [&](const Option& option) { return std::ranges::find(option.names, name) != option.names.end(); });
  }

  std::string mesh_;
  int rounds_ = 3;
  Job job_{"unfold", "Unfold"};
  SharedOptions shared_;
  std::vector<Option> table_;
  std::optional<Session> session_;
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

using Pairs = std::vector<std::pair<std::string, std::string>>;

TEST(Session, RepeatsTheRunWithItsSeed) {
  MemoryFiles files;
  UnfoldSession session(files, {{"mesh", "my mesh.obj"}, {"-o", "it's.fold"}, {"--rounds", "5"}, {"-q", "true"}});
  EXPECT_EQ(session->repeat_command(), "plico unfold 'my mesh.obj' --rounds 5 -o 'it'\\''s.fold' -q");
  session->seed();
  EXPECT_THAT(session->repeat_command(), HasSubstr(" --seed 1"));
}

TEST(Session, ARunCutByTimeRepeatsByItsLength) {
  MemoryFiles files;
  UnfoldSession session(files, {{"mesh", "a.obj"}, {"--time-limit", "1s"}, {"--rounds", "1000"}});
  session->repeat_with("--rounds", "17");
  EXPECT_EQ(session->repeat_command(), "plico unfold a.obj --rounds 17");
}

TEST(Session, ProvenanceDoesNotDependOnHowTheRunWasWatched) {
  MemoryFiles files;
  files.files["a.obj"] = "abc";
  const auto provenance = [&](Pairs values) {
    values.insert(values.begin(), {{"mesh", "a.obj"}, {"--rounds", "5"}});
    UnfoldSession session(files, values);
    session->seed();
    session->read("a.obj");
    return session->provenance().dump();
  };
  const std::string plain = provenance({});
  EXPECT_EQ(plain, provenance({{"--threads", "2"},
                               {"-o", "x"},
                               {"-f", "true"},
                               {"--time-limit", "9s"},
                               {"--progress", "none"},
                               {"-v", "true"}}));
  EXPECT_NE(plain, provenance({{"--seed", "2"}}));
  EXPECT_THAT(plain, HasSubstr("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
}

// The same rules on disk and in memory; on disk a folder must also be there.
void refuses_to_overwrite_before_the_work(JobFiles& files, const std::string& old, const std::string& fresh) {
  files.write(old, "old", false);
  EXPECT_THROW(UnfoldSession(files, {{"mesh", "a.obj"}, {"-o", old}})->outputs(""), FileError);
  EXPECT_EQ(UnfoldSession(files, {{"mesh", "a.obj"}, {"-o", old}, {"-f", "true"}})->outputs(""),
            std::vector<std::string>{old});
  EXPECT_EQ(UnfoldSession(files, {{"mesh", "a.obj"}})->outputs("-"), std::vector<std::string>{"-"});
  EXPECT_TRUE(UnfoldSession(files, {{"mesh", "a.obj"}})->outputs("").empty());
  EXPECT_EQ(UnfoldSession(files, {{"mesh", "a.obj"}, {"-o", fresh}})->output_folder("default"), fresh);
  files.write(fresh + "/old", "old", false);
  EXPECT_EQ(files.names_in(fresh), std::vector<std::string>{"old"});
  EXPECT_THROW(UnfoldSession(files, {{"mesh", "a.obj"}, {"-o", fresh}})->output_folder("default"), FileError);
  EXPECT_EQ(UnfoldSession(files, {{"mesh", "a.obj"}, {"-o", fresh}, {"-f", "true"}})->output_folder("default"), fresh);
}

TEST(Session, RefusesToOverwriteBeforeTheWork) {
  MemoryFiles memory;
  refuses_to_overwrite_before_the_work(memory, "old.fold", "a/b");
  const Folder folder;
  DiskFiles disk;
  refuses_to_overwrite_before_the_work(disk, folder / "old.fold", folder / "a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  EXPECT_THROW(UnfoldSession(disk, {{"mesh", "a.obj"}, {"-o", folder / "no/such.fold"}})->outputs(""), FileError);
  EXPECT_THROW(UnfoldSession(disk, {{"mesh", "a.obj"}, {"-o", folder / "old.fold"}})->output_folder(""), FileError);
}

TEST(Session, TheTimeLimitIsADeadline) {
  MemoryFiles files;
  UnfoldSession session(files, {{"mesh", "a.obj"}, {"--time-limit", "1ms"}, {"--threads", "3"}});
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const plico::Run run = session->run();
  EXPECT_TRUE(run.over());
  EXPECT_EQ(Session::exit_code(run.ending()), 5);
  EXPECT_EQ(run.threads, 3);
  EXPECT_FALSE(UnfoldSession(files, {{"mesh", "a.obj"}})->run().deadline.has_value());
}

}  // namespace
}  // namespace plico::jobs
