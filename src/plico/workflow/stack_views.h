// A chain of thick squares as people see it: a page with its motion, a picture of its stack, a sentence about both.
#pragma once
#include <string>

#include "plico/io/motion/viewer.h"
#include "plico/workflow/stack_motion.h"

namespace plico {

// Shown at the stack first; title and report are the caller's.
ViewerInput unpacking_page(const StackMotion& motion);

// The motion as an animated GLB, each thick hinge as three joints with one axis.
std::string unpacking_animation(const StackMotion& motion);

// PNG of the panels as they lie in the stack.
std::string stack_picture(const ChainClaim& claim);

// "from the stack to the shape, proven ..." or how far it goes.
std::string motion_text(const StackMotion& motion, bool to_shape);

// Are the points of some frame of the file's motion off (1e-7 of the side) from where its fold angles put them?
bool points_are_elsewhere(const FoldFile& file, const ChainClaim& claim);

}  // namespace plico
