// The paint of a mesh file: its colours, and the pictures that lie beside it or in it.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plico/io/mesh/mesh_source.h"
#include "plico/mesh/paint.h"

namespace plico {

// The bytes of the file of that name beside the mesh, nothing when there is none.
using FileBeside = std::function<std::optional<std::string>(const std::string& name)>;

struct PaintRead {
  Paint paint;                     // empty when the file says nothing of colours, or only one grey
  std::vector<std::string> notes;  // what could not be read and is left out; sentences
};

// Looks are never a reason to refuse a shape: what is missing or damaged is told, and its faces have the colour of
// their material, or white. Faces are cut into triangles as triangulate_face() does. O(bytes of pictures + corners).
PaintRead read_paint(const MeshSource& source, const FileBeside& file);

}  // namespace plico
