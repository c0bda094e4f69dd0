// Wavefront OBJ: `v` and `f` lines, and for the looks `vt`, `usemtl`, `mtllib` and the colours of `v` lines; everything
// else (normals, groups, lines) is passed over.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/mesh/mesh_source.h"

namespace plico {

// Indices count from 1, or backwards from the last vertex when negative; polygons of any size. Throws InvalidInput with
// "name:line" for a malformed line or an index without a vertex. O(bytes).
MeshSource read_obj(std::string_view bytes, const std::string& name = "input.obj");

// Shortest numbers that read back as the same doubles. O(corners).
std::string write_obj(const PolygonSoup& soup);

// Several objects in one file, each after a line "o NAME". Names are written as they are, without line breaks.
struct ObjObject {
  std::string name;
  PolygonSoup soup;
};
std::string write_obj(const std::vector<ObjObject>& objects);

}  // namespace plico
