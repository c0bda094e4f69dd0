// glTF 2.0, binary (.glb) and as text (.gltf): the triangles of all nodes of the scene, where their nodes put them.
// Materials, skins, animations and everything else are passed over.
#pragma once
#include <string>
#include <string_view>

#include "plico/io/mesh/mesh_source.h"

namespace plico {

bool is_glb(std::string_view bytes);

// Corners at equal places are one point, within the mesh of a node. Buffers are in the file, as the binary chunk or as
// a data URI in base64. Throws InvalidInput for buffers in other files, compressed meshes, and anything malformed.
// O(bytes) for each node.
MeshSource read_gltf(std::string_view bytes, const std::string& name = "input.glb");

}  // namespace plico
