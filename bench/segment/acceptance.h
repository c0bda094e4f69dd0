// What parts must be, row by row: goal, value, reached or not.
#pragma once
#include "table.h"

namespace plico::bench {

// Prints the table for seeds 1 to 3, only 1 when quick; true when every goal is reached. Needs the folder of meshes.
bool acceptance(const Arguments& arguments);

}  // namespace plico::bench
