#include "plico/io/mesh/mesh_source.h"

#include <fmt/core.h>

namespace plico {

std::string MeshSource::place(int where) const {
  return binary ? fmt::format("{}: byte {}", name, where) : fmt::format("{}:{}", name, where);
}

}  // namespace plico
