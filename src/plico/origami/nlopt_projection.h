// FindFoldable as the dissertation has it: minimize how far the loops are open, without the structure of the problem.
// Source: [Xi17] 3.1.1, eq. 3.1 read as R4. For comparison; Projector is faster by orders of magnitude and exact.
#pragma once
#include "plico/origami/projector.h"

namespace plico {

// [Xi17] does not name its algorithm. Its 280 evaluations a configuration on a Miura of twelve creases look like one
// without derivatives.
enum class NloptAlgorithm { Cobyla, Slsqp };

struct NloptOptions {
  NloptAlgorithm algorithm = NloptAlgorithm::Cobyla;
  double tolerance = 1e-4;            // radians, of the worst residual; above 0
  double first_step = 0.05;           // radians, of the first simplex of Cobyla; above 0
  int max_evaluations = 2000;         // of the objective, at least 1; Slsqp: with the derivatives, by differences
  Configuration low = {}, high = {};  // limits of each fold angle, radians, or empty for [-pi, pi]
};

// The same as Projector::project, `steps` counts evaluations. The objective is the sum of the Frobenius norms of
// (product of the folding matrices - identity), to which a hole adds its gap; Slsqp takes the sum of their squares,
// which is smooth where the norms are not. Throws InvalidOption, and InvalidInput when sizes differ.
Projection project_by_nlopt(const std::vector<RealVertex>& vertices, const Configuration& start,
                            const NloptOptions& options = {});

}  // namespace plico
