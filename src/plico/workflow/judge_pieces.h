// What the pieces of a kit claim one by one: a flat net and, where there is one, a motion that folds it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/verify/path.h"
#include "plico/workflow/judge_motion.h"

namespace plico {

struct PieceVerdict {
  std::string title;
  int panels = 0, hinges = 0, waypoints = 0;  // no waypoints: no motion
  FileVerdict claims;                         // of the motion, beside freedom of collision
  std::optional<PathProof> proof;             // none without a motion

  bool moves() const { return proof.has_value(); }
  bool complete() const { return claims.complete && !(proof && proof->interrupted); }
  bool valid() const {
    return claims.complete && claims.defects.empty() && (!proof || proof->verdict == PathVerdict::Free);
  }
};

// One verdict a piece of `kit`, which is judged like a sheet by itself (judge_motion) and proven (prove_path) with
// `clearance`, 0 for the default of each. Nets are held against the mesh elsewhere (verify/parts.h), since that is one
// for all.
std::vector<PieceVerdict> judge_pieces(const FoldFile& kit, double clearance = 0, const Run& run = {});

}  // namespace plico
