#include "plico/io/mesh/mesh_source.h"

#include <fmt/core.h>

#include <algorithm>

namespace plico {

std::string MeshSource::place(int where) const {
  return binary ? fmt::format("{}: byte {}", name, where) : fmt::format("{}:{}", name, where);
}

int Looks::number_of(const std::string& material_name) {
  const auto at = std::ranges::find(materials, material_name, &Material::name) - materials.begin();
  if (at == std::ssize(materials)) materials.push_back({.name = material_name});
  return static_cast<int>(at);
}

}  // namespace plico
