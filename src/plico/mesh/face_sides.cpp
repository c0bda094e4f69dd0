#include "plico/mesh/face_sides.h"

#include <algorithm>
#include <tuple>

namespace plico {

FaceSides::FaceSides(const PolygonSoup& soup, const std::vector<char>& include) {
  sides_.reserve(soup.corners.size());
  for (int f = 0; f < soup.num_faces(); ++f) {
    if (!include[f]) continue;
    const int first = soup.offsets[f], last = soup.offsets[f + 1];
    for (int c = first; c < last; ++c) {
      const int next = c + 1 == last ? first : c + 1;
      const int a = soup.corners[c], b = soup.corners[next];
      sides_.push_back({std::min(a, b), std::max(a, b), f, c, next, a < b});
    }
  }
  std::sort(sides_.begin(), sides_.end(), [](const FaceSide& s, const FaceSide& t) {
    return std::tie(s.low, s.high, s.corner) < std::tie(t.low, t.high, t.corner);
  });
}

}  // namespace plico
