// Reading any bytes either gives a sheet whose panels can be told apart, and that can be written, or throws
// InvalidInput.
#include <cstdint>
#include <cstdlib>

#include "plico/base/error.h"
#include "plico/io/pattern/cp.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const plico::CreasePattern sheet = plico::read_cp({reinterpret_cast<const char*>(data), size}).sheet;
    if (sheet.faces.empty() || plico::edge_sides(sheet).size() != sheet.edges.size()) std::abort();
    if (plico::write_cp(sheet).empty()) std::abort();
  } catch (const plico::InvalidInput&) {
    return 0;
  }
  return 0;
}
