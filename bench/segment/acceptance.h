// What parts must be, row by row: goal, value, reached or not.
#pragma once
#include "table.h"

namespace plico::bench {

// Prints the table for seeds `first` to `last`; true when every goal is reached. Needs the folder of meshes. What does
// not depend on the seed comes with seed 1.
bool acceptance(const Arguments& arguments, int first, int last);

}  // namespace plico::bench
