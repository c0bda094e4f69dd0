// Judges a finished net from scratch: is this really the mesh, cut open and laid flat without overlap? Shares no code
// with the layout or the searches that make nets.
#pragma once
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/verify/overlap.h"

namespace plico {

struct NetCheckOptions {
  double tolerance = 1e-9;            // lengths and positions, relative to the mesh's diagonal
  double angle_tolerance_deg = 1e-6;  // fold angles against the mesh's
  OverlapOptions overlap;
};

// Something that is wrong, for programs ("net/not-congruent") and for people.
struct Defect {
  std::string code, message;
};

struct NetVerdict {
  int panels = 0, parts = 0, fold_edges = 0;
  double scale = 1;             // net lengths over mesh lengths
  double congruence_error = 0;  // worst length of a panel, relative to the diagonal
  double mate_error = 0;        // worst difference of two glued lengths, relative to the diagonal
  double angle_error = 0;       // worst fold angle, radians
  double closing_error = 0;     // worst distance of a folded vertex from the mesh's, relative to the diagonal
  Overlaps overlaps;            // panel numbers
  std::vector<Defect> defects;  // empty when the claim holds; of one kind the first few and a count
  bool complete = true;         // false when the run was over before every check was done

  bool valid() const { return complete && defects.empty(); }
  bool is_net() const { return valid() && parts == 1; }  // R15
};

// Checks that
//   - every mesh face stands once as a panel with its corners in order, congruent to it;
//   - edges name exactly the sides of panels, one panel beside a B, two on opposite sides beside a fold;
//   - the panels of a part form a tree, and parts are its connected pieces, numbered 0..k-1;
//   - mates are the two copies of one mesh edge, equally long, and no copy is without its mate;
//   - fold angles and letters are the mesh's, and folding by them puts every vertex where the mesh has it;
//   - no two panels share an interior point (find_overlaps: exact for the coordinates as written).
// A net may be the mesh scaled by any one factor. Works for any number of parts. O(n log n) for layouts, see
// find_overlaps. Never throws for a wrong net: it says what is wrong.
NetVerdict verify_net(const Unfolding& net, const Mesh& mesh, const NetCheckOptions& options = {}, const Run& run = {});

}  // namespace plico
