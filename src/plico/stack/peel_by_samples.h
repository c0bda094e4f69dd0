// The search of peel() without its proof, to measure what the proof costs. What it finds may collide on the way.
#pragma once
#include "plico/stack/peel.h"

namespace plico {

// Looks every `apart` degrees, above 0, where peel() proves. Throws InvalidOption.
Peel peel_by_samples(const Linkage& chain, int sign, double apart, const PeelOptions& options = {},
                     const Run& run = {});

}  // namespace plico
