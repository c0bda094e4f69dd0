#include <cstdint>

#include "plico/base/error.h"
#include "plico/io/mesh/mtl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    plico::read_mtl({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const plico::InvalidInput&) {
  }
  return 0;
}
