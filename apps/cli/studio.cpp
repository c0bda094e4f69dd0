// plico studio: where this program's page lies, and how a browser is asked to show it.
#include "plico/workflow/jobs/studio.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "commands.h"

namespace plico::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOpener =
#ifdef __APPLE__
    "open";
#else
    "xdg-open";
#endif

fs::path own_folder() {
  std::error_code failed;
  return fs::read_symlink("/proc/self/exe", failed).parent_path();
}

// As cmake --install leaves it, then as a build of the sources does: build/release/apps/cli and build/wasm.
jobs::StudioPlace studio_place() {
  const fs::path folder = own_folder();
  jobs::StudioPlace place;
  place.expected_at = (folder / "../share/plico/plico-studio.html").lexically_normal().string();
  for (const char* near : {"../share/plico", ".", "../../../wasm"}) {
    const fs::path page = (folder / near / "plico-studio.html").lexically_normal();
    std::error_code failed;
    if (fs::is_regular_file(page, failed)) {
      place.page = page.string();
      break;
    }
  }
  return place;
}

// The opener hands the page to a running browser and ends; what it says is nothing for the reader of ours.
bool open_in_browser(const std::string& path) {
  std::string opener = kOpener, absolute = fs::absolute(path).string();
  const std::array<char*, 3> words{opener.data(), absolute.data(), nullptr};
  posix_spawn_file_actions_t silent;
  posix_spawn_file_actions_init(&silent);
  for (int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silent, stream, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  int status = 0;
  const bool started = posix_spawnp(&child, kOpener, &silent, nullptr, words.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&silent);
  return started && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Job studio_command() {
  jobs::StudioPlace place = studio_place();
  place.show = open_in_browser;
  return jobs::studio_job(place);
}

}  // namespace plico::cli
