// The tables of bench_stack, one source each.
#pragma once
#include <string>
#include <vector>

#include "table.h"

namespace plico::bench {

// Stacks: table 6.2 of the dissertation, many meshes at three thicknesses, growth. `meshes` may be empty.
std::vector<Table> stack_tables(const std::string& meshes, bool quick);

// From the stack to the shape: how many of own models and of a folder's meshes (may be empty) unpack, by thickness; 60
// s each. `quick` looks at every eighth mesh, 10 s each.
Table motions(const std::string& folder, bool quick);

}  // namespace plico::bench
