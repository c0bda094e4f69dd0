// The tables of bench_stack, one source each.
#pragma once
#include <string>
#include <vector>

#include "table.h"

namespace plico::bench {

// Stacks: table 6.2 of the dissertation, many meshes at three thicknesses, growth. `meshes` may be empty.
std::vector<Table> stack_tables(const std::string& meshes, bool quick);

}  // namespace plico::bench
