// Files that give every triangle corners of its own: which of them are one point.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "plico/io/mesh/mesh_source.h"

namespace plico {

// Gives equal points one number, of those it was shown: open addressing over the bits of the coordinates.
class PointWelder {
 public:
  PointWelder(MeshSource& source, std::size_t expected) : source_(source), first_(source.soup.points.size()) {
    table_.assign(std::bit_ceil(std::max<std::size_t>(16, 2 * expected)), -1);
  }

  int number_of(Vec3 p, int place) {
    for (int axis = 0; axis < 3; ++axis) p[axis] += 0.0;  // -0 and 0 are one place
    auto& points = source_.soup.points;
    std::size_t slot = hash(p) & (table_.size() - 1);
    while (table_[slot] >= 0 && !same(points[table_[slot]], p)) slot = (slot + 1) & (table_.size() - 1);
    if (table_[slot] < 0) {
      table_[slot] = static_cast<int>(points.size());
      points.push_back(p);
      source_.point_place.push_back(place);
      if (2 * (points.size() - first_) > table_.size()) return grow();
    }
    return table_[slot];
  }

 private:
  static bool same(const Vec3& a, const Vec3& b) {  // by bits, so that not-a-number is found again
    return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
  }
  static std::size_t hash(const Vec3& p) {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (int axis = 0; axis < 3; ++axis) {
      h = (h ^ std::bit_cast<std::uint64_t>(p[axis])) * 0xff51afd7ed558ccdu;
      h ^= h >> 32;
    }
    return h;
  }
  int grow() {  // returns the number of the newest point
    table_.assign(2 * table_.size(), -1);
    const auto& points = source_.soup.points;
    for (std::size_t i = first_; i < points.size(); ++i) {
      std::size_t slot = hash(points[i]) & (table_.size() - 1);
      while (table_[slot] >= 0) slot = (slot + 1) & (table_.size() - 1);
      table_[slot] = static_cast<int>(i);
    }
    return static_cast<int>(points.size()) - 1;
  }

  MeshSource& source_;
  std::size_t first_;  // of the points it was shown
  std::vector<int> table_;
};

}  // namespace plico
