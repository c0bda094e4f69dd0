// PLY 1.0: text, binary little endian, binary big endian.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/mesh/mesh_source.h"

namespace plico {

// The elements `vertex` (x, y, z of any type) and `face` (a list vertex_indices or vertex_index); other elements and
// properties are passed over. Throws InvalidInput with line or byte. O(bytes).
MeshSource read_ply(std::string_view bytes, const std::string& name = "input.ply");

enum class PlyEncoding { Text, LittleEndian, BigEndian };

// Every double and every polygon is kept. O(corners).
std::string write_ply(const PolygonSoup& soup, PlyEncoding encoding = PlyEncoding::LittleEndian);

}  // namespace plico
