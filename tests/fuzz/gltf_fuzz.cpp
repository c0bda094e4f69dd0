#include "mesh_reader_fuzz.h"
#include "plico/io/mesh/gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return plico::fuzz_mesh_reader(data, size, [](std::string_view bytes) { return plico::read_gltf(bytes); });
}
