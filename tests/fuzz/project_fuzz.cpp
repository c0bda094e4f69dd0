// Reading any bytes as a project either gives a value that is written and read back as it is, or throws InvalidInput.
#include <cstdint>
#include <cstdlib>

#include "plico/base/error.h"
#include "plico/project/project.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string once;
  try {
    once = plico::write_project(plico::read_project({reinterpret_cast<const char*>(data), size}));
  } catch (const plico::InvalidInput&) {
    return 0;
  }
  if (plico::write_project(plico::read_project(once)) != once) std::abort();
  return 0;
}
