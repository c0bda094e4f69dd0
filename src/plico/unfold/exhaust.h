// All nets of a small mesh, tried one by one: finds one or proves that there is none.
#pragma once
#include <optional>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/unfold/flat_faces.h"

namespace plico {

struct ExhaustResult {
  // Found: `net` holds one. Exhausted with `decided`: no spanning tree of the dual graph is free of overlaps.
  Ending ending = Ending::Exhausted;
  bool decided = false;
  FoldForest net;
  long nodes = 0;  // partial nets looked at
};

// Grows nets of the connected mesh of `faces` from face 0, taking or leaving one dual edge after another; a partial net
// that overlaps, or that cannot reach all faces any more, is given up with all that contain it. Looks at no more than
// `max_nodes` partial nets. Exponential; meant for up to some thirty faces.
ExhaustResult try_all_nets(const FlatFaces& faces, long max_nodes, const Run& run = {});

}  // namespace plico
