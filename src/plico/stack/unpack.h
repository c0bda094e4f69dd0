// The motion of a thick chain: from its stack to one pile, from the pile to the shape. Ours; [Xi17] leaves it open.
#pragma once
#include <vector>

#include "plico/fold/folding_path.h"
#include "plico/stack/lattice.h"
#include "plico/stack/peel.h"

namespace plico {

// The sign of hinge 0 in the one pile that the stack swings into (peel.h): folds keep their angles, flat hinges take
// the one that continues the alternation. 0 when folds do not alternate so: then the stack is not one of piles side by
// side.
int pile_sign(const std::vector<StackFold>& folds);

// The piles of a stack swung onto each other, the last one first: each turns by 180 degrees about the flat hinge by
// which it hangs, in its own lane. One configuration a swing, the stack first and the pile last. Free of collision when
// no earlier pile stands in the lane beyond a later one in the direction of its step (boustrophedon bases); that is for
// others to prove.
std::vector<Configuration> swings(const std::vector<StackFold>& folds);

// Stack, swings and peel as one motion: time 0 is the stack, time 1 the shape or, when the peel is not whole, as far as
// it goes. Times are by the angle that turns most.
FoldingPath unpacking(const Linkage& chain, const std::vector<StackFold>& folds, const Peel& peel);

// The mirror image: the stack grows down where it grew up.
std::vector<StackFold> upside_down(std::vector<StackFold> folds);

}  // namespace plico
