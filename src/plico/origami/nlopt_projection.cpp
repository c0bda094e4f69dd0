#include "plico/origami/nlopt_projection.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/origami/loop_walk.h"

namespace plico {
namespace {

void check(const NloptOptions& o, Eigen::Index creases) {
  require(o.tolerance > 0, "tolerance", o.tolerance, "above 0");
  require(o.first_step > 0, "first step", o.first_step, "above 0");
  require(o.max_evaluations >= 1, "max evaluations", o.max_evaluations, "at least 1");
  for (const Configuration* limit : {&o.low, &o.high})
    if (limit->size() != 0 && limit->size() != creases)
      throw InvalidInput("origami/limits", fmt::format("{} limits for {} creases", limit->size(), creases));
}

// Eq. 3.1. A rotation by r differs from the identity by 2 sqrt 2 sin(r / 2) in the Frobenius norm.
class Objective {
 public:
  Objective(const std::vector<RealVertex>& vertices, const Configuration& start, const NloptOptions& options)
      : vertices_(vertices),
        config_(start),
        squares_(options.algorithm == NloptAlgorithm::Slsqp),
        tolerance_(options.tolerance),
        most_(options.max_evaluations) {}

  static double call(unsigned n, const double* x, double* gradient, void* self) {
    return static_cast<Objective*>(self)->evaluate(n, x, gradient);
  }
  void stop_at(nlopt_opt optimizer) { optimizer_ = optimizer; }

  // The best so far by its worst residual, which decides whether it closes.
  const Configuration& best() const { return best_; }
  int evaluations() const { return evaluations_; }

 private:
  double evaluate(unsigned n, const double* x, double* gradient) {
    config_ = Eigen::Map<const Configuration>(x, n);
    const double here = value();
    if (!gradient) return here;
    constexpr double kStep = 1e-6;
    for (unsigned k = 0; k < n; ++k) {
      config_[k] = x[k] + kStep;
      const double ahead = value();
      config_[k] = x[k] - kStep;
      gradient[k] = (ahead - value()) / (2 * kStep);
      config_[k] = x[k];
    }
    return here;
  }

  double value() {
    double sum = 0, worst = 0;
    for (const RealVertex& loop : vertices_) {
      Eigen::Matrix<double, 6, 1> open = Eigen::Matrix<double, 6, 1>::Zero();
      write_residual(loop, walk_around(loop, config_, [](std::size_t, const Vec3&, const Vec3&) {}), open.data());
      const double turn = 2 * std::sqrt(2.0) * plico::sin(open.head<3>().norm() / 2), gap = open.tail<3>().norm();
      sum += squares_ ? turn * turn + gap * gap : turn + gap;
      worst = std::max(worst, open.norm());
    }
    if (evaluations_++ == 0 || worst < best_worst_) best_worst_ = worst, best_ = config_;
    if (best_worst_ <= tolerance_ || evaluations_ >= most_) nlopt_force_stop(optimizer_);
    return sum;
  }

  const std::vector<RealVertex>& vertices_;
  Configuration config_, best_;
  bool squares_;
  double tolerance_, best_worst_ = 0;
  int most_, evaluations_ = 0;
  nlopt_opt optimizer_ = nullptr;
};

}  // namespace

Projection project_by_nlopt(const std::vector<RealVertex>& vertices, const Configuration& start,
                            const NloptOptions& options) {
  check(options, start.size());
  const Configuration low = options.low.size() ? options.low : Configuration::Constant(start.size(), -kPi);
  const Configuration high = options.high.size() ? options.high : Configuration::Constant(start.size(), kPi);
  Projection result;
  result.config = start.cwiseMax(low).cwiseMin(high);
  result.closure = closure(vertices, result.config);  // throws when angles are missing, which nothing inside NLopt may
  result.steps = 1;
  if (result.closure.worst > options.tolerance) {
    const auto algorithm = options.algorithm == NloptAlgorithm::Slsqp ? NLOPT_LD_SLSQP : NLOPT_LN_COBYLA;
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimizer(
        nlopt_create(algorithm, static_cast<unsigned>(start.size())), &nlopt_destroy);
    PLICO_ASSERT(optimizer);
    Objective objective(vertices, result.config, options);
    objective.stop_at(optimizer.get());
    nlopt_set_min_objective(optimizer.get(), &Objective::call, &objective);
    nlopt_set_lower_bounds(optimizer.get(), low.data());
    nlopt_set_upper_bounds(optimizer.get(), high.data());
    nlopt_set_initial_step1(optimizer.get(), options.first_step);
    nlopt_set_xtol_abs1(optimizer.get(), options.tolerance / 100);
    Configuration at = result.config;
    double value = 0;
    nlopt_optimize(optimizer.get(), at.data(), &value);  // how it ended does not matter: the best is judged below
    if (objective.evaluations() > 0) result.config = objective.best().cwiseMax(low).cwiseMin(high);
    result.steps += objective.evaluations();
    result.closure = closure(vertices, result.config);
  }
  result.closed = result.closure.worst <= options.tolerance;
  return result;
}

}  // namespace plico
