// The joints of a kit on paper and in reports.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "plico/fabricate/fabricate.h"
#include "plico/workflow/kit.h"

namespace plico {

// Both facets of every joint, on the panels of `net`. Joints are numbered from 1; the text names the part that is
// glued on, as "to B: 3". `pieces` has the pieces of the net of every part, `titles` one entry for each piece.
std::vector<JointFacet> joint_facets(const Mesh& mesh, const Unfolding& net, const std::vector<Joint>& joints,
                                     const std::vector<std::vector<int>>& pieces, const std::vector<PartTitle>& titles);

// One object a joint: number, parts (names), faces (of the mesh), area, polygon. Units are the mesh's.
nlohmann::json joints_json(const Kit& kit);

}  // namespace plico
