// Every crease pattern the library can make, under a name: what `plico origami make` offers, and what tests and
// benchmarks run on.
#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

struct NamedPattern {
  std::string name, description;
  bool has_size = false;       // made with as many columns and rows as asked for
  bool has_sector = false;     // its panels' acute angle can be chosen
  std::string angle = {};      // which creases' goal can be chosen; empty: none
  std::string diagonals = {};  // which flat creases can be added; empty: none
  int usual_columns = 0, usual_rows = 0;
};

const std::vector<NamedPattern>& named_patterns();

struct PatternOptions {
  int columns = 0, rows = 0;                                 // both 0: the pattern's own
  double angle = std::numeric_limits<double>::quiet_NaN();   // radians; not a number: the pattern's own
  double sector = std::numeric_limits<double>::quiet_NaN();  // radians; not a number: the pattern's own
  bool diagonals = false;                                    // with flat creases across the panels
};

// At unit size; the goal closes. Without an angle, the goal of a tessellation that rolls up stops short of closing into
// a tube. Throws InvalidOption for an unknown name, an option that the pattern does not have, or a value out of range.
// O(columns rows log(columns rows)).
CreasePattern make_pattern(std::string_view name, const PatternOptions& options = {});

}  // namespace plico
