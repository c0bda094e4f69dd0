#include "plico/inflate/minimize.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

namespace plico {
namespace {

struct Step {
  Eigen::VectorXd move, change;  // of x and of the gradient
  double inverse = 0;            // 1 / (move . change)
};

// The two-loop recursion: the gradient times what is known of the inverse Hessian.
Eigen::VectorXd quasi_newton(const std::deque<Step>& steps, const Eigen::VectorXd& gradient) {
  Eigen::VectorXd d = gradient;
  std::vector<double> alpha(steps.size());
  for (std::size_t i = steps.size(); i-- > 0;) {
    alpha[i] = steps[i].inverse * steps[i].move.dot(d);
    d -= alpha[i] * steps[i].change;
  }
  if (!steps.empty()) d /= steps.back().inverse * steps.back().change.squaredNorm();
  for (std::size_t i = 0; i < steps.size(); ++i)
    d += (alpha[i] - steps[i].inverse * steps[i].change.dot(d)) * steps[i].move;
  return d;
}

struct Point {
  Eigen::VectorXd x, gradient;
  double value = 0;
};

// Halves the step until the value falls by a share of what the slope promises; false when no step does.
bool descend(const SmoothFunction& f, Point& at, const Eigen::VectorXd& direction, double step) {
  const double slope = at.gradient.dot(direction);
  Point next;
  next.gradient.resize(at.x.size());
  for (int halvings = 0; halvings < 40; ++halvings, step /= 2) {
    next.x = at.x + step * direction;
    next.value = f(next.x, next.gradient);
    if (!(next.value <= at.value + 1e-4 * step * slope)) continue;
    std::swap(at, next);
    return true;
  }
  return false;
}

void remember(std::deque<Step>& steps, Eigen::VectorXd move, Eigen::VectorXd change, int memory) {
  const double curvature = move.dot(change);
  if (curvature <= 1e-12 * move.norm() * change.norm()) return;  // not convex here: teaches nothing
  steps.push_back({std::move(move), std::move(change), 1 / curvature});
  if (static_cast<int>(steps.size()) > memory) steps.pop_front();
}

}  // namespace

int minimize(const SmoothFunction& f, Eigen::VectorXd& x, const MinimizeOptions& options, const Run& run) {
  Point at{x, Eigen::VectorXd(x.size()), 0};
  at.value = f(at.x, at.gradient);
  std::deque<Step> steps;
  int count = 0;
  while (count < options.max_iterations && at.gradient.lpNorm<Eigen::Infinity>() > options.tolerance && !run.over()) {
    Eigen::VectorXd direction = -quasi_newton(steps, at.gradient);
    if (at.gradient.dot(direction) >= 0) direction = -at.gradient;
    const Point before = at;
    const double first = steps.empty() ? std::min(1.0, 0.1 / direction.lpNorm<Eigen::Infinity>()) : 1;
    if (!descend(f, at, direction, first)) {
      if (steps.empty()) break;
      steps.clear();
      continue;
    }
    remember(steps, at.x - before.x, at.gradient - before.gradient, options.memory);
    ++count;
  }
  x = at.x;
  return count;
}

}  // namespace plico
