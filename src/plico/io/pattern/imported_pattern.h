// What readers of drawings give: a crease pattern, and in words everything that reading changed or assumed.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/crease_pattern.h"

namespace plico {

struct ImportedPattern {
  CreasePattern sheet;
  std::vector<std::string> notes;  // one sentence each; empty when the file was taken as it stands
};

}  // namespace plico
