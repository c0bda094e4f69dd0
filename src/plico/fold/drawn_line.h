// A line of a drawing, before it is known what it meets.
#pragma once
#include "plico/fold/crease_pattern.h"

namespace plico {

struct DrawnLine {
  Vec2 a, b;
  Assignment assignment = Assignment::Unassigned;
  double fold_angle = 0;  // radians, valley > 0
  int place = 0;          // where it was drawn, for messages: a line number or a byte
};

}  // namespace plico
