// A motion as a table, for controllers and spreadsheets.
#pragma once
#include <string>

#include "plico/fold/folding_path.h"

namespace plico {

// A header, then one row a waypoint: time in [0, 1], then the fold angle of every hinge in degrees, valley positive.
// Between rows angles change linearly.
std::string write_trajectory_csv(const FoldingPath& path);

}  // namespace plico
