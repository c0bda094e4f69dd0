// How commands that make shells read a shape: as polygons of any kind, in parts.
#pragma once
#include <string>
#include <vector>

#include "plico/convex/shells.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

// What is a part: "groups" of an OBJ file, "components" that hang together, "labels" of another file; "auto": groups
// when there are several, else components.
std::vector<ShapePart> read_shape_parts(const std::string& shape, const std::string& by, const std::string& labels,
                                        Session& session);

}  // namespace plico::jobs
