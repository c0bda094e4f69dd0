// Reading any bytes as labels or as groups of an OBJ file either gives every face one of the names, each of which has a
// face, or throws InvalidInput.
#include <cstdint>
#include <cstdlib>
#include <set>

#include "plico/base/error.h"
#include "plico/io/mesh/face_groups.h"

namespace {

void expect_sound(const plico::FaceGroups& groups) {
  std::set<int> used(groups.of_face.begin(), groups.of_face.end());
  if (used.size() != groups.names.size()) std::abort();
  if (!used.empty() && (*used.begin() != 0 || *used.rbegin() + 1 != static_cast<int>(used.size()))) std::abort();
  if (std::set<std::string>(groups.names.begin(), groups.names.end()).size() != groups.names.size()) std::abort();
}

template <class Read>
void expect_sound_or_refused(Read&& read) {
  try {
    expect_sound(read());
  } catch (const plico::InvalidInput&) {
    return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  expect_sound_or_refused([&] { return plico::read_face_labels(bytes, "labels"); });
  expect_sound_or_refused([&] { return plico::read_obj_groups(bytes, "mesh.obj"); });
  plico::has_obj_groups(bytes);
  return 0;
}
