// The dissertation's own way to inflate: forces added up step by step. Source: [Xi17] eqs. 4.1-4.9, read as R8.
#pragma once
#include "plico/inflate/inflate.h"

namespace plico {

// P += dt f at options.pressure (1 where that is 0), until growth, hyperbolic vertices or steps end it, or the mesh
// bursts: the step is too long for the stiffest springs, or pressure too high for any. The last good points are
// returned. Pressure pushes a vertex along the sum of its faces' normals, each weighted by the angle at the vertex.
// The mesh is one that inflate() takes. O(steps n).
Inflation integrate(const Mesh& mesh, const InflateOptions& options, const Run& run);

}  // namespace plico
