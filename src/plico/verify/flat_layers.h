// Is an order of the layers of a sheet that is folded flat one that paper can take?
#pragma once
#include <string>
#include <vector>

#include "plico/fold/face_order.h"

namespace plico {

struct FlatLayersVerdict {
  bool valid = false;
  bool flat_goal = true;    // false: not judged, since some fold is neither 0 nor 180 degrees
  std::string why;          // not valid: a sentence
  Vec2 where{0, 0};         // then: in the folded sheet
  std::vector<int> panels;  // then: that are at fault there
  int places = 0;           // looked at
};

// Judged from the drawing and the orders alone, by walking: the sheet is folded by reflections, panel by panel. Every
// side of a panel is cut where others meet it; to the left and right of the middle of each piece lie two stacks. Their
// panels must all have an order without a circle; what folds back must enclose only what folds back between it, or
// ends there; what goes on must keep its order from one stack to the other; and folds must turn to the side of their
// letter. It shares no code with the search for an order. The goal must be flat. O(sides^2 * panels).
FlatLayersVerdict check_flat_layers(const CreasePattern& sheet, const std::vector<FaceOrder>& orders);

}  // namespace plico
