// Left and right alike: the mirror images of faces, and parts that are images of each other or of themselves.
#pragma once
#include <optional>
#include <vector>

#include "plico/base/run.h"
#include "plico/mesh/mesh.h"
#include "plico/segment/necks.h"

namespace plico {

// The image of every face in a plane that maps the mesh onto itself, to 1e-5 of its diagonal; none when there is no
// such plane. Planes through the centre of the surface across an axis of space or a principal axis are tried, in this
// order. O(n log n).
std::optional<std::vector<int>> mirror_images(const Mesh& mesh);

// cut_at_necks() where the image of every cut is a cut too: necks on one side come with their images, those across the
// plane are made symmetric. `part` must map onto itself, as components do. max_parts may be missed by one, since
// pairs come together. The result maps onto itself.
std::vector<int> cut_mirrored(const DualGraph& graph, std::vector<int> part, const std::vector<int>& image,
                              const NeckCutOptions& options = {}, const Run& run = {});

// The part that is the image of each part, itself perhaps; -1 when its image is not a part.
std::vector<int> mirror_partners(const std::vector<int>& part, const std::vector<int>& image);

}  // namespace plico
