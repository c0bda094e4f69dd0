// The joints of a kit on paper and in reports.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "plico/fabricate/fabricate.h"
#include "plico/workflow/kit.h"

namespace plico {

// Both facets of every joint, on the panels of kit.net. Joints are numbered from 1; the text names the part that is
// glued on, as "to B: 3". `titles` has one entry a piece of the net.
std::vector<JointFacet> joint_facets(const Mesh& mesh, const Kit& kit, const std::vector<PartTitle>& titles);

// One object a joint: number, parts (names), faces (of the mesh), area, polygon. Units are the mesh's.
nlohmann::json joints_json(const Kit& kit);

}  // namespace plico
