// A motion as a table, for controllers and spreadsheets.
#pragma once
#include <span>
#include <string>

#include "plico/fold/folding_path.h"
#include "plico/fold/linkage.h"

namespace plico {

// A header, then one row a waypoint: time in [0, 1], then the fold angle of every hinge in degrees, valley positive.
// Between rows angles change linearly. Columns are named by the vertices of the crease in the sheet, "crease_3_7_deg",
// where `hinges` tells them, else by number, "hinge_0_deg".
std::string write_trajectory_csv(const FoldingPath& path, std::span<const Hinge> hinges = {});

}  // namespace plico
