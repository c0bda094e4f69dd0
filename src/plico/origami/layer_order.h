// Which panel lies on which in a sheet that is folded flat.
#pragma once
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/face_order.h"

namespace plico {

inline constexpr int kMostLayered = 120;  // panels: conditions grow with their third power

struct LayerOrder {
  Ending ending = Ending::Exhausted;  // Exhausted: there is no order, or it was not asked for: see `why`
  std::vector<FaceOrder> orders;      // Found: of every two panels that lie on each other; ascending
  bool flat_goal = true;              // false: not asked for, since some fold is neither 0 nor 180 degrees
  std::string why;                    // Exhausted: a sentence
};

// An order of the layers of a sheet whose goal is flat (every fold 0 or 180 degrees), in which paper does not pass
// through paper: creases have the side that their letter says; what lies across a crease is not between its panels
// (taco-tortilla); of two creases in one place neither pair parts the other (taco-taco), nor do panels change places at
// a flat crease; panels with a place in common are stacked. By SAT. Drawings may be off by 1e-4 of the mean side.
// Deterministic. Source: the conditions of [BH96] in the form of today's layer solvers.
LayerOrder order_layers(const CreasePattern& sheet, const Run& run = {});

}  // namespace plico
