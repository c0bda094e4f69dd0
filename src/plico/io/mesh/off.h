// Object File Format: OFF, and COFF, NOFF, STOFF and their mixtures, whose extra columns are passed over. Text only.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/mesh/mesh_source.h"

namespace plico {

// Indices count from 0; polygons of any size; colours after a face are passed over. Throws InvalidInput with
// "name:line" for a malformed line, counts that do not fit the lines, or an index without a vertex. O(bytes).
MeshSource read_off(std::string_view bytes, const std::string& name = "input.off");

// Shortest numbers that read back as the same doubles. O(corners).
std::string write_off(const PolygonSoup& soup);

}  // namespace plico
