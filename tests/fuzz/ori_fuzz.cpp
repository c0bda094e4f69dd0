// Reading any bytes either gives a sheet whose panels can be told apart, or throws InvalidInput; what follows the first
// zero byte is read as the sheet's motion.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "plico/base/error.h"
#include "plico/fold/linkage.h"
#include "plico/io/pattern/ori.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(bytes.find('\0'), size);
  try {
    const plico::OriFile ori = plico::read_ori(bytes.substr(0, end));
    if (ori.pattern.sheet.faces.empty() ||
        plico::edge_sides(ori.pattern.sheet).size() != ori.pattern.sheet.edges.size())
      std::abort();
    if (end == size) return 0;
    const plico::FoldingPath path = plico::read_trj(bytes.substr(end + 1), ori);
    const plico::Linkage linkage = plico::make_linkage(ori.pattern.sheet);
    for (const plico::Waypoint& w : path.waypoints)
      if (w.config.size() != linkage.num_hinges()) std::abort();
  } catch (const plico::InvalidInput&) {
    return 0;
  }
  return 0;
}
