// Minima of smooth functions of many variables. Source: J. Nocedal, Updating Quasi-Newton Matrices with Limited Storage
// (1980).
#pragma once
#include <Eigen/Core>
#include <functional>

#include "plico/base/run.h"

namespace plico {

// The value at x, infinite where the function is not defined; fills the gradient, which has the size of x.
using SmoothFunction = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct MinimizeOptions {
  int max_iterations = 300;
  double tolerance = 1e-6;  // ends when no entry of the gradient is larger
  int memory = 12;          // steps remembered, at least 1
};

// Descends from x, where the function must be finite, by L-BFGS; the value falls with every step, so this always ends.
// Returns the number of steps. O(memory size) and about one evaluation a step.
int minimize(const SmoothFunction& f, Eigen::VectorXd& x, const MinimizeOptions& options = {}, const Run& run = {});

}  // namespace plico
