// Everything that a file with a motion claims beside freedom of collision: that its sheet is flat without overlap, or a
// net of its mesh; that the motion starts flat and ends at the goal; that the points drawn are where the angles put
// them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/io/pattern/fold.h"
#include "plico/verify/net.h"

namespace plico {

struct FileVerdict {
  std::vector<Defect> defects;         // empty when all that was checked holds
  std::vector<std::string> unchecked;  // what the file gives no means to check, one sentence each
  double share = 1;                    // of the way to the goal (share_of_way) that the motion goes
  bool is_partial = false;             // the file says that its motion ends there, short of the goal, and it does
  double may_deform = 0;               // share of an edge's length, as the file says: loops are open on purpose
  double deformation = 0;              // then: measured
  bool complete = true;                // false when the run was over before every check was done
};

// `mesh` is the one the net was made from; without it the folded form in the file stands for it. Every claim but the
// proof of collision freedom (verify/path.h). Positions agree to 1e-7 of the sheet's diagonal, the start to 1e-6 rad,
// the end to half a degree, which goals rounded in a file may be off. A file may say that its motion ends
// short of the goal ("progress" of its report); then it must end just there. It may say that its loops do not close
// ("deformation"); then no edge may change its length by more than it says. O(waypoints * vertices) beside verify_net.
FileVerdict judge_motion(const FoldFile& file, const Linkage& linkage, const std::optional<Mesh>& mesh = {},
                         const Run& run = {});

// The folded form in the file against the mesh: the first vertex that stands elsewhere, none when all agree or the file
// has no folded form.
std::optional<Defect> judge_folded_form(const FoldFile& file, const Mesh& mesh);

}  // namespace plico
