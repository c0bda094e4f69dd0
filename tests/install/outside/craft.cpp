// A job without a terminal: the same files as "plico craft bird.obj -o bird".
#include <cstdio>
#include <exception>

#include "plico/workflow/jobs/jobs.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    plico::jobs::DiskFiles files;
    const auto result = plico::jobs::run_job("craft", {{"mesh", argv[1]}, {"output", argv[2]}}, files);
    for (const auto& message : result.messages) std::printf("%s\n", message.text.c_str());
    return result.exit_code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
