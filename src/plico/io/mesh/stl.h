// STL: triangles without shared vertices, as text or binary.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/mesh/mesh_source.h"

namespace plico {

// Corners with exactly equal coordinates become one vertex, numbered by first appearance; normals are passed over. A
// file is binary when its size is what its triangle count says, or when it does not start with "solid". Throws
// InvalidInput with line or byte. O(bytes).
MeshSource read_stl(std::string_view bytes, const std::string& name = "input.stl");

// Is this a binary STL file whose size fits its triangle count?
bool is_binary_stl(std::string_view bytes);

// Binary; coordinates are rounded to 32-bit floats, polygons are cut into triangles. Throws InvalidInput when a
// coordinate is too large for a float. O(corners).
std::string write_stl(const PolygonSoup& soup);
// Text, with every digit of the doubles.
std::string write_stl_text(const PolygonSoup& soup);

}  // namespace plico
