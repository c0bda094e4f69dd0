// A chain of thick squares moved and watched by the plainest means, to hold the proof against: each hinge is the three
// axes of R11 written down once more, and two panels overlap when an edge or a diagonal of one runs through the other.
// No folding map, no separating axes, no bounds: nothing of what is tested.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "plico/base/vec.h"
#include "plico/stack/lattice.h"

namespace plico {

class BruteChain {
 public:
  // Squares of side 1, trimmed by their thickness; each face moves inwards by `air` thicknesses. Every hinge turns
  // evenly from one angle to the other; two panels are watched when one between them does.
  BruteChain(const Headings& headings, double thickness, double air, const std::vector<double>& from,
             const std::vector<double>& to)
      : thickness_(thickness), half_(0.5 - thickness, 0.5 - thickness, (0.5 - air) * thickness), from_(from), to_(to) {
    places_.resize(headings.size() + 1);
    for (std::size_t h = 0; h < headings.size(); ++h) {
      const double step = index(headings[h]) < 2 ? 1 : -1;
      ahead_.push_back(along_x(headings[h]) ? Vec3(step, 0, 0) : Vec3(0, step, 0));
      joints_.push_back(joint(h, from[h]));
    }
    for (std::size_t b = 0; b < places_.size(); ++b) {
      bool turns = false;
      for (std::size_t a = b; a-- > 0;) {
        turns = turns || from[a] != to[a];
        if (turns && a + 1 < b) pairs_.emplace_back(a, b);
      }
    }
  }

  // At a time from 0 to 1.
  void place_at(double time) {
    for (std::size_t h = 0; h < joints_.size(); ++h) {
      if (from_[h] != to_[h]) joints_[h] = joint(h, (1 - time) * from_[h] + time * to_[h]);
      const Place& before = places_[h];
      places_[h + 1] = {before.center + before.axes * joints_[h].center, before.axes * joints_[h].axes};
    }
  }

  // Do some two panels that are watched overlap there when each is larger by `grow` on all sides?
  bool overlaps(double grow) const {
    const double near = 4 * half_.squaredNorm() + 0.01;
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const auto& pair) {
      const Place &a = places_[pair.first], &b = places_[pair.second];
      return (a.center - b.center).squaredNorm() < near && (runs_through(a, b, grow) || runs_through(b, a, grow));
    });
  }

 private:
  struct Place {
    Vec3 center = Vec3::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };

  // A panel as the one before it sees it: up to a right angle about the crease in the middle of the thickness, the rest
  // about the edge that then touches.
  Place joint(std::size_t hinge, double angle) const {
    const Vec3 &ahead = ahead_[hinge], up = Vec3::UnitZ();
    const double first = std::clamp(angle, -kPi / 2, kPi / 2), rest = angle - first;
    const Vec3 crease = ahead / 2, edge = crease + thickness_ / 2 * (angle < 0 ? Vec3(-up - ahead) : Vec3(up - ahead));
    const auto turned = [&](double by) {  // in the plane across the hinge
      const Vec3 along = ahead.cross(up);
      Eigen::Matrix3d m = along * along.transpose();
      m += (std::cos(by) * ahead + std::sin(by) * up) * ahead.transpose();
      m += (std::cos(by) * up - std::sin(by) * ahead) * up.transpose();
      return m;
    };
    const Vec3 center = crease + turned(first) * (ahead / 2);
    return {edge + turned(rest) * (center - edge), turned(angle)};
  }

  // Does an edge or a diagonal through the middle of `a` run through `b`?
  bool runs_through(const Place& a, const Place& b, double grow) const {
    const Eigen::Matrix3d across = b.axes.transpose() * a.axes;
    const Vec3 center = b.axes.transpose() * (a.center - b.center), box = half_ + Vec3::Constant(grow);
    if (((center.cwiseAbs() - across.cwiseAbs() * box - box).array() >= 0).any()) return false;
    std::array<Vec3, 8> corners;
    for (int i = 0; i < 8; ++i)
      corners[i] =
          center + across * Vec3(i & 1 ? box.x() : -box.x(), i & 2 ? box.y() : -box.y(), i & 4 ? box.z() : -box.z());
    for (int i = 0; i < 8; ++i) {
      for (int bit : {1, 2, 4})
        if ((i & bit) == 0 && cuts(corners[i], corners[i | bit], box)) return true;
      if (i < 4 && cuts(corners[i], corners[7 - i], box)) return true;
    }
    return false;
  }

  // Does the segment share a point with the open box around the origin?
  static bool cuts(const Vec3& from, const Vec3& to, const Vec3& box) {
    double enter = 0, leave = 1;
    for (int i = 0; i < 3; ++i) {
      const double step = to[i] - from[i];
      if (std::abs(step) < 1e-300) {
        if (std::abs(from[i]) >= box[i]) return false;
        continue;
      }
      const double one = (-box[i] - from[i]) / step, other = (box[i] - from[i]) / step;
      enter = std::max(enter, std::min(one, other));
      leave = std::min(leave, std::max(one, other));
    }
    return enter < leave;
  }

  double thickness_;
  Vec3 half_;
  std::vector<double> from_, to_;
  std::vector<Vec3> ahead_;  // over each hinge, as the strip lies flat
  std::vector<Place> joints_, places_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace plico
