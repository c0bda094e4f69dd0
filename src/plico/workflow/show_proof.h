// What a page with a motion shows of its proof.
#pragma once
#include "plico/io/motion/viewer.h"
#include "plico/verify/chain_motion.h"
#include "plico/verify/path.h"

namespace plico {

// Sets the status of the proof and marks the collision it found. A proof that was cut short has checked nothing to rely
// on.
void show_proof(ViewerInput& page, const PathProof& proof);

// The same for a chain of thick squares, with a note on how it was proven.
void show_proof(ViewerInput& page, const ChainMotionVerdict& verdict);

}  // namespace plico
