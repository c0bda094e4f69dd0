// In which order the printed parts are glued together.
#pragma once
#include <vector>

#include "plico/fabricate/net_sides.h"

namespace plico {

struct AssemblyStep {
  int part = -1;
  std::vector<int> onto;  // parts of earlier steps that it is glued to, the one with the longest seam first
};

// One step a part. Given ranks, one a part, lower ones come first; otherwise part 0 begins, and the next is always the
// part with the longest seam to those that are there, so that nothing hangs loose while one builds. Where nothing is
// glued on, the lowest part left begins anew. O(parts * (parts + seams)).
std::vector<AssemblyStep> assembly_order(const NetSides& sides, const std::vector<int>& rank = {});

}  // namespace plico
