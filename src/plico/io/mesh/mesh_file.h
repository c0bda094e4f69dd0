// Meshes in files of any kind we know: OBJ, OFF, STL, PLY, and glTF to read.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "plico/io/mesh/mesh_source.h"
#include "plico/mesh/check.h"
#include "plico/mesh/mesh.h"

namespace plico {

enum class MeshFormat { Obj, Off, Stl, Ply, Gltf };
std::string_view name(MeshFormat format);                             // "OBJ"
std::optional<MeshFormat> mesh_format_of(const std::string& path);    // by the extension
std::optional<MeshFormat> sniff_mesh_format(std::string_view bytes);  // by the contents

// The polygons of a file in memory. Throws InvalidInput with file and line (or byte) when it is malformed.
PolygonSoup read_mesh(std::string_view bytes, MeshFormat format);
// The same with the places of all elements; the format by the extension of `name`, else by the contents.
MeshSource read_mesh_source(std::string_view bytes, const std::string& name);
MeshSource read_mesh_file(const std::string& path);  // "-" is standard input

// Where in the file the first element stands that a problem of source.soup is about: "bunny.obj:214".
std::string place_of(const MeshSource& source, const Problem& problem);

// The surface that every algorithm starts from: the first error that check_mesh finds is thrown as InvalidInput, with
// the place in the file and the command to try. What check_mesh only warns about is let through.
Mesh to_mesh(MeshSource source, const CheckOptions& options = {.self_intersections = false});
Mesh load_mesh(const std::string& path);

// The bytes of a file of that format; PLY binary, STL binary. Every format but STL keeps every double and every
// polygon; STL stores 32-bit floats and triangles. glTF is not written: throws InvalidOption.
std::string write_mesh(const PolygonSoup& soup, MeshFormat format);

}  // namespace plico
