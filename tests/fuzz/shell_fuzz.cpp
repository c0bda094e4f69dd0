// Any OBJ file of a few parts either becomes shells that are convex and disjoint, exactly, and stay so when they are
// remeshed, or is refused with InvalidInput.
#include <cstdint>
#include <cstdlib>

#include "plico/base/error.h"
#include "plico/convex/shape_parts.h"
#include "plico/convex/shells.h"
#include "plico/io/mesh/obj.h"
#include "plico/workflow/shell_shape.h"

namespace {

using namespace plico;

// Coordinates up to 1e3 and few points: what is decided exactly is bounded, and so is the time.
bool is_small(const std::vector<ShapePart>& parts) {
  if (parts.size() > 4) return false;
  for (const ShapePart& part : parts) {
    if (part.points.size() > 24) return false;
    for (const Vec3& p : part.points)
      if (p.allFinite() && p.cwiseAbs().maxCoeff() > 1e3) return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::vector<ShapePart> parts =
        parts_by_components(read_obj({reinterpret_cast<const char*>(data), size}).soup);
    if (!is_small(parts)) return 0;
    const JudgedShells shells = shell_shape(parts, {.max_sweeps = 2}, {});
    for (const Defect& defect : shells.verdict.defects)
      if (defect.code != "shells/loss") std::abort();
    const JudgedRemeshing remeshed = remesh_shells(shells.shells, {.faces = 8, .regularize = 1}, {});
    if (!remeshed.verdict.valid()) std::abort();
  } catch (const InvalidInput&) {
    return 0;
  }
  return 0;
}
