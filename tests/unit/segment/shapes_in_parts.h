// Shapes whose parts everybody agrees on.
#pragma once
#include <cmath>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

// A closed surface of revolution: a ring of `n` corners at every (radius, height) but the first and the last, which are
// points on the axis. Faces come ring by ring from below, n in each.
inline Mesh turned(const std::vector<Vec2>& profile, int n) {
  PolygonSoup soup;
  soup.points.emplace_back(0, 0, profile.front().y());
  for (std::size_t r = 1; r + 1 < profile.size(); ++r)
    for (int i = 0; i < n; ++i) {
      const double turn = 2 * kPi * i / n;
      soup.points.emplace_back(profile[r].x() * std::cos(turn), profile[r].x() * std::sin(turn), profile[r].y());
    }
  soup.points.emplace_back(0, 0, profile.back().y());
  const auto at = [&](std::size_t ring, int i) { return 1 + static_cast<int>(ring) * n + i % n; };
  const std::size_t rings = profile.size() - 2;
  for (int i = 0; i < n; ++i) soup.add_face({0, at(0, i + 1), at(0, i)});
  for (std::size_t r = 0; r + 1 < rings; ++r)
    for (int i = 0; i < n; ++i) soup.add_face({at(r, i), at(r, i + 1), at(r + 1, i + 1), at(r + 1, i)});
  for (int i = 0; i < n; ++i) soup.add_face({at(rings - 1, i), at(rings - 1, i + 1), soup.num_points() - 1});
  return Mesh(std::move(soup));
}

// Two round bodies with a thin tube between them: rows 0 to 5 of faces are the lower body, 6 the tube, 7 to 12
// the upper.
inline Mesh dumbbell(int n = 12) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= 6; ++i) {
    const double angle = (kPi - 0.25) * i / 6;
    profile.emplace_back(std::sin(angle), -std::cos(angle));
  }
  const double end = profile.back().y();
  profile.emplace_back(profile.back().x(), end + 0.1);
  for (int i = 6; i >= 0; --i) profile.emplace_back(profile[i].x(), 2 * end + 0.1 - profile[i].y());
  profile.front().x() = profile.back().x() = 0;
  return turned(profile, n);
}

}  // namespace plico
