// FOLD's faceOrders: which of two panels lies on which.
#pragma once
#include "plico/fold/crease_pattern.h"

namespace plico {

// Panel f lies on the side that the front of panel g faces (side = 1), or on the other (-1).
struct FaceOrder {
  int f = -1, g = -1, side = 0;
};

}  // namespace plico
