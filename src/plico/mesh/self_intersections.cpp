#include "plico/mesh/self_intersections.h"

#include <algorithm>
#include <array>

#include "plico/geom/box_tree.h"
#include "plico/geom/predicates.h"
#include "plico/geom/triangle_intersection.h"
#include "plico/mesh/triangulate.h"
#include "plico/mesh/weld.h"

namespace plico {
namespace {

struct Piece {
  std::array<int, 3> corners{};  // welded
  int face = 0;
};

bool usable(const PolygonSoup& soup, int f) {
  const auto face = soup.face(f);
  return face.size() >= 3 && std::all_of(face.begin(), face.end(), [&](int v) {
           return v >= 0 && v < soup.num_points() && soup.points[v].allFinite();
         });
}

bool on_a_line(const Triangle3& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat = [axis](const Vec3& p) { return Vec2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
    if (orient2d(flat(t[0]), flat(t[1]), flat(t[2])) != 0) return false;
  }
  return true;
}

class Search {
 public:
  explicit Search(const PolygonSoup& soup) : soup_(soup) {
    const std::vector<int> welded = welded_points(soup.points);
    for (int f = 0; f < soup.num_faces(); ++f) {
      if (!usable(soup, f)) continue;
      for (auto corners : triangulate_face(soup, f)) {
        for (int& corner : corners) corner = welded[corner];
        if (!on_a_line(triangle(corners))) pieces_.push_back({corners, f});
      }
    }
  }

  std::vector<std::pair<int, int>> run(std::size_t limit) const {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Piece& piece : pieces_) {
      boxes.emplace_back();
      for (int v : piece.corners) boxes.back().extend(soup_.points[v]);
    }
    std::vector<std::pair<int, int>> found;
    BoxTree(boxes).overlapping_pairs([&](int i, int j) {
      const Piece &s = pieces_[i], &t = pieces_[j];
      if (s.face != t.face && meet(s, t)) found.push_back(std::minmax(s.face, t.face));
      return found.size() < limit;
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  Triangle3 triangle(const std::array<int, 3>& corners) const {
    return {soup_.points[corners[0]], soup_.points[corners[1]], soup_.points[corners[2]]};
  }

  // Brings the shared corners to the front of both, then asks for more than those.
  bool meet(const Piece& s, const Piece& t) const {
    std::array<int, 3> a = s.corners, b = t.corners;
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto same = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
      if (same == b.end()) continue;
      std::iter_swap(b.begin() + static_cast<std::ptrdiff_t>(shared), same);
      std::swap(a[shared], a[i]);
      ++shared;
    }
    if (shared == 0) return triangles_meet(triangle(a), triangle(b));
    if (shared == 1) return triangles_meet_beyond_corner(triangle(a), triangle(b));
    return shared == 3 || triangles_meet_beyond_edge(triangle(a), triangle(b));
  }

  const PolygonSoup& soup_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const PolygonSoup& soup, std::size_t limit) {
  return Search(soup).run(limit);
}

}  // namespace plico
