#include "plico/stack/unpack.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {
namespace {

int sign_at(int sign, int hinge) { return hinge % 2 ? -sign : sign; }

StackFold opposite_fold(StackFold fold) { return static_cast<StackFold>(-static_cast<int>(fold)); }

FoldingPath timed(const std::vector<Configuration>& states) {
  FoldingPath path;
  double time = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i > 0) time += (states[i] - states[i - 1]).cwiseAbs().maxCoeff();
    path.waypoints.push_back({time, states[i]});
  }
  for (Waypoint& waypoint : path.waypoints) waypoint.time /= time;
  path.waypoints.back().time = 1;
  return path;
}

}  // namespace

int pile_sign(const std::vector<StackFold>& folds) {
  int sign = 0;
  for (int h = 0; h < static_cast<int>(folds.size()); ++h) {
    if (folds[h] == StackFold::Flat) continue;
    const int here = sign_at(static_cast<int>(folds[h]), h);
    if (sign != 0 && here != sign) return 0;
    sign = here;
  }
  return sign == 0 ? 1 : sign;
}

std::vector<Configuration> swings(const std::vector<StackFold>& folds) {
  const int sign = pile_sign(folds);
  PLICO_ASSERT(sign != 0);
  const std::vector<double> angles = fold_angles(folds);
  Configuration state = Eigen::Map<const Configuration>(angles.data(), static_cast<Eigen::Index>(angles.size()));
  std::vector<Configuration> states{state};
  for (int h = static_cast<int>(folds.size()) - 1; h >= 0; --h) {
    if (folds[h] != StackFold::Flat) continue;
    state[h] = sign_at(sign, h) * kPi;
    states.push_back(state);
  }
  return states;
}

FoldingPath unpacking(const Linkage& chain, const std::vector<StackFold>& folds, const Peel& peel) {
  PLICO_ASSERT(static_cast<int>(folds.size()) == chain.num_hinges());
  std::vector<Configuration> states = swings(folds);
  Configuration state = states.back();
  for (const PeelStep& step : peel.steps)
    for (std::size_t i = 1; i < step.angles.size(); ++i) {
      state.segment(step.first, step.angles[i].size()) = step.angles[i];
      states.push_back(state);
    }
  if (states.size() < 2) states.push_back(state);
  return timed(states);
}

std::vector<StackFold> upside_down(std::vector<StackFold> folds) {
  for (StackFold& fold : folds) fold = opposite_fold(fold);
  return folds;
}

}  // namespace plico
