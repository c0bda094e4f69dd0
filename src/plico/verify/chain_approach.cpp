#include "plico/verify/chain_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plico {
namespace {

// Sine of the angle below which axes count as parallel, and what that may add to an acceleration, as a share of it.
constexpr double kParallel = 1e-9, kSkew = 1e-6;

// How far the box reaches in the direction.
double highest(const OrientedBox& box, const Vec3& direction) {
  return box.center.dot(direction) + (box.axes.transpose() * direction).cwiseAbs().dot(box.half);
}

// The least s > 0 with height + slope s - bend s^2 / 2 = 0, for a height above 0; infinite when there is none.
double time_down(double height, double slope, double bend) {
  const double speed = std::sqrt(slope * slope + 2 * bend * height) - slope;
  return speed > 0 ? 2 * height / speed : std::numeric_limits<double>::infinity();
}

}  // namespace

ChainApproach::ChainApproach(const ChainSegment& segment, int seen_by, const ChainBlock& block)
    : segment_(segment),
      seen_by_(seen_by),
      block_(block),
      speed_(segment.speed(seen_by, block)),
      changes_(segment.changes_of_axis(seen_by, block.group)) {}

OrientedBox ChainApproach::at(double time) const {
  return placed(block_.box, segment_.moved(seen_by_, block_.group, time));
}

double ChainApproach::next_change(double time) const {
  const auto next = std::upper_bound(changes_.begin(), changes_.end(), time);
  return next == changes_.end() ? 1 : *next;
}

ChainApproach::Corners ChainApproach::corners(double time) const {
  const ChainSegment::Turns now = segment_.turns(seen_by_, block_.group, time, next_change(time));
  Corners corners;
  corners.axis = now.turns.back().rate.normalized();
  corners.has_one_axis = std::ranges::all_of(now.turns, [&](const auto& turn) {
    return turn.rate.cross(corners.axis).norm() <= kParallel * turn.rate.norm();
  });
  const std::array<Vec3, 8> places = corners_of(placed(block_.box, now.pose));
  for (std::size_t c = 0; c < places.size(); ++c) {
    Corner& corner = corners.all[c] = {places[c], Vec3::Zero(), 0};
    double outer = 0;
    for (const ChainSegment::Turn& turn : now.turns) outer += turn.rate.norm();
    // From the last hinge to the first. A point is `arm` from its axis at most: the arms between axes keep their
    // length. Turns j and k add rate_j rate_k times the arm of the later one.
    Vec3 foot = places[c];
    double arm = 0;
    for (auto turn = now.turns.rbegin(); turn != now.turns.rend(); ++turn) {
      const double rate = turn->rate.norm(), along = (foot - turn->point).dot(turn->rate) / (rate * rate);
      const Vec3 on_axis = turn->point + along * turn->rate;
      arm += (foot - on_axis).norm();
      foot = on_axis;
      corner.velocity += turn->rate.cross(places[c] - turn->point);
      corner.acceleration += arm * rate * (2 * outer - rate);
      outer -= rate;
    }
  }
  return corners;
}

double ChainApproach::apart_for(const Corners& corners, const OrientedBox& box, const Vec3& direction) const {
  const double top = highest(box, direction);
  // About one axis nothing is accelerated along it.
  const double share = corners.has_one_axis ? std::min(1.0, direction.cross(corners.axis).norm() + kSkew) : 1;
  double least = std::numeric_limits<double>::infinity();
  for (const Corner& corner : corners.all) {
    const double height = corner.at.dot(direction) - top;
    if (height <= 0) return 0;
    least = std::min(least, time_down(height, corner.velocity.dot(direction), share * corner.acceleration));
  }
  return least;
}

double ChainApproach::apart_until(const OrientedBox& box, double time) const {
  const Corners now = corners(time);
  const OrientedBox there = at(time);
  const double limit = next_change(time);
  double longest = 0;
  // Outwards, as seen by the resting box.
  const auto look = [&](const Vec3& direction) {
    const bool outwards = direction.dot(there.center - box.center) >= 0;
    longest = std::max(longest, apart_for(now, box, outwards ? direction : Vec3(-direction)));
  };
  for (int i = 0; i < 3; ++i) {
    look(box.axes.col(i));
    look(there.axes.col(i));
  }
  for (int i = 0; i < 3 && time + longest < limit; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 direction = box.axes.col(i).cross(there.axes.col(j));
      if (const double length = direction.norm(); length > 1e-3) look(direction / length);
    }
  return std::min(limit, time + longest);
}

}  // namespace plico
