#include "plico/mesh/repair.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "plico/base/disjoint_sets.h"
#include "plico/mesh/check.h"
#include "plico/mesh/face_sides.h"
#include "plico/mesh/triangulate.h"
#include "plico/mesh/weld.h"

namespace plico {
namespace {

std::vector<char> all_faces(const PolygonSoup& soup) {
  return std::vector<char>(static_cast<std::size_t>(soup.num_faces()), 1);
}

void reverse_face(PolygonSoup& soup, int f) {  // the first corner stays
  std::reverse(soup.corners.begin() + soup.offsets[f] + 1, soup.corners.begin() + soup.offsets[f + 1]);
}

class Repairer {
 public:
  Repairer(const PolygonSoup& soup, const RepairOptions& options) : options_(options) { result_.soup = soup; }

  Repaired run() { return options_.level == RepairLevel::Safe ? run_safely() : run_fully(); }

 private:
  Repaired run_fully() {
    weld();
    drop_faces("removed {} with a vertex number out of range", [&](int f) { return !in_range(f); });
    drop_faces("removed {} with a coordinate that is not finite or too large", [&](int f) { return !finite(f); });
    drop_repeated_corners();
    drop_faces("removed {} with fewer than three corners or a vertex twice", [&](int f) { return !distinct(f); });
    triangulate_bad_polygons();
    drop_faces("removed {} without area", [&](int f) { return is_degenerate(soup(), f, options_.least_area); });
    drop_duplicates();
    orient();
    turn_outward();
    take_apart();
    drop_unused_vertices();
    return std::move(result_);
  }

  Repaired run_safely() {
    if (!all_usable()) return std::move(result_);  // nothing that is done here would help
    Repairer welded(*this);
    welded.weld();
    welded.clean();
    clean();
    if (closes_more(welded.soup())) result_ = std::move(welded.result_);
    orient();
    turn_outward();
    if (!has_bad_edges()) split_bow_ties();
    if (!result_.done.empty()) drop_unused_vertices();
    return std::move(result_);
  }

  bool all_usable() {
    for (int f = 0; f < soup().num_faces(); ++f)
      if (!in_range(f) || !finite(f)) return false;
    return true;
  }

  struct EdgeCount {
    std::size_t open = 0, crowded = 0;  // edges of one face, of more than two
  };
  static EdgeCount count_edges(const PolygonSoup& soup) {
    EdgeCount count;
    FaceSides(soup, all_faces(soup)).for_each_edge([&](std::span<const FaceSide> sides) {
      count.open += sides.size() == 1;
      count.crowded += sides.size() > 2;
    });
    return count;
  }

  // Corners that coincide in a file are one point drawn twice when the faces then close up, and two points that touch
  // when edges would get more than two faces. Where both happen, most open edges must go.
  bool closes_more(const PolygonSoup& welded) {
    const EdgeCount apart = count_edges(soup()), joined = count_edges(welded);
    if (joined.crowded > apart.crowded) return 2 * joined.open <= apart.open && apart.open > 0;
    return joined.open < apart.open;
  }

  // What has no area or stands twice goes, what is not flat is cut.
  void clean() {
    drop_repeated_corners();
    drop_faces("removed {} with fewer than three corners", [&](int f) { return soup().face(f).size() < 3; });
    triangulate_bad_polygons();
    drop_faces("removed {} without area", [&](int f) { return is_degenerate(soup(), f, options_.least_area); });
    drop_duplicates();
  }

  bool has_bad_edges() {
    bool bad = false;
    FaceSides(soup(), all_faces(soup())).for_each_edge([&](std::span<const FaceSide> sides) {
      bad = bad || sides.size() > 2 || (sides.size() == 2 && sides[0].forward == sides[1].forward);
    });
    return bad;
  }

  PolygonSoup& soup() { return result_.soup; }
  void say(const std::string& text) { result_.done.push_back(text); }
  static std::string counted(std::size_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  }

  bool in_range(int f) {
    const auto face = soup().face(f);
    return std::all_of(face.begin(), face.end(), [&](int v) { return v >= 0 && v < soup().num_points(); });
  }
  bool finite(int f) {
    const auto face = soup().face(f);
    return std::all_of(face.begin(), face.end(),
                       [&](int v) { return (soup().points[v].array().abs() <= options_.max_coordinate).all(); });
  }
  bool distinct(int f) {
    const auto face = soup().face(f);
    return face.size() >= 3 && std::set<int>(face.begin(), face.end()).size() == face.size();
  }

  void weld() {
    const std::vector<int> first = welded_points(soup().points);
    std::size_t joined = 0;
    for (std::size_t v = 0; v < first.size(); ++v) joined += first[v] != static_cast<int>(v);
    if (joined == 0) return;
    for (int& corner : soup().corners)
      if (corner >= 0 && corner < soup().num_points()) corner = first[corner];
    say(fmt::format("joined {} {} to others with equal coordinates", joined, joined == 1 ? "vertex" : "vertices"));
  }

  // Keeps the faces for which `bad` is false.
  template <class Bad>
  void drop_faces(const char* sentence, Bad&& bad) {
    PolygonSoup kept;
    for (int f = 0; f < soup().num_faces(); ++f)
      if (!bad(f)) kept.add_face(soup().face(f));
    const auto dropped = static_cast<std::size_t>(soup().num_faces() - kept.num_faces());
    if (dropped == 0) return;
    kept.points = std::move(soup().points);
    soup() = std::move(kept);
    say(fmt::format(fmt::runtime(sentence), counted(dropped, "face")));
  }

  // A side that joining made a point; a face keeps its shape without it.
  void drop_repeated_corners() {
    PolygonSoup kept;
    std::size_t dropped = 0;
    for (int f = 0; f < soup().num_faces(); ++f) {
      std::vector<int> face;
      for (int v : soup().face(f))
        if (face.empty() || face.back() != v) face.push_back(v);
      while (face.size() > 1 && face.front() == face.back()) face.pop_back();
      dropped += soup().face(f).size() - face.size();
      kept.add_face(face);
    }
    if (dropped == 0) return;
    kept.points = std::move(soup().points);
    soup() = std::move(kept);
    say(fmt::format("removed {} of length zero", counted(dropped, "side")));
  }

  void triangulate_bad_polygons() {
    PolygonSoup kept;
    std::size_t cut = 0;
    for (int f = 0; f < soup().num_faces(); ++f) {
      const bool bad = soup().face(f).size() > 3 &&
                       (warp(soup(), f) > options_.planarity || is_degenerate(soup(), f) || crosses_itself(soup(), f));
      cut += bad;
      if (!bad) kept.add_face(soup().face(f));
      if (bad)
        for (const auto& triangle : triangulate_face(soup(), f)) kept.add_face(triangle);
    }
    if (cut == 0) return;
    kept.points = std::move(soup().points);
    soup() = std::move(kept);
    say(fmt::format("cut {} into triangles, since they are not flat or cross themselves", counted(cut, "polygon")));
  }

  void drop_duplicates() {
    std::set<std::vector<int>> seen;
    drop_faces("removed {} given twice", [&](int f) {
      std::vector<int> key(soup().face(f).begin(), soup().face(f).end());
      std::sort(key.begin(), key.end());
      return !seen.insert(std::move(key)).second;
    });
  }

  // Walks over edges with two faces and turns whoever disagrees with the face it is reached from; in every component
  // the larger number of faces stays as it was.
  void orient() {
    const int faces = soup().num_faces();
    std::vector<std::vector<std::pair<int, bool>>> neighbours(static_cast<std::size_t>(faces));  // face, agrees
    FaceSides(soup(), all_faces(soup())).for_each_edge([&](std::span<const FaceSide> sides) {
      if (sides.size() != 2) return;
      const bool agree = sides[0].forward != sides[1].forward;
      neighbours[sides[0].face].emplace_back(sides[1].face, agree);
      neighbours[sides[1].face].emplace_back(sides[0].face, agree);
    });
    std::vector<char> turned(static_cast<std::size_t>(faces), -1);
    std::size_t count = 0;
    for (int seed = 0; seed < faces; ++seed) {
      if (turned[seed] >= 0) continue;
      std::vector<int> component = {seed};
      turned[seed] = 0;
      std::size_t flips = 0;
      for (std::size_t i = 0; i < component.size(); ++i)
        for (const auto& [g, agree] : neighbours[component[i]]) {
          if (turned[g] >= 0) continue;
          turned[g] = static_cast<char>(agree ? turned[component[i]] : 1 - turned[component[i]]);
          flips += turned[g] == 1;
          component.push_back(g);
        }
      const char turn = 2 * flips > component.size() ? 0 : 1;
      for (int f : component)
        if (turned[f] == turn) {
          reverse_face(soup(), f);
          ++count;
        }
    }
    if (count > 0) say(fmt::format("turned over {} to agree with the neighbours", counted(count, "face")));
  }

  void turn_outward() {
    DisjointSets parts(static_cast<std::size_t>(soup().num_faces()));
    std::vector<char> open(static_cast<std::size_t>(soup().num_faces()), 0);
    FaceSides(soup(), all_faces(soup())).for_each_edge([&](std::span<const FaceSide> sides) {
      if (sides.size() == 2) parts.join(sides[0].face, sides[1].face);
      for (const FaceSide& side : sides)
        if (sides.size() != 2 || sides[0].forward == sides[1].forward) open[side.face] = 1;
    });
    std::vector<double> volume(open.size(), 0);
    std::vector<char> part_open(open.size(), 0);
    for (int f = 0; f < soup().num_faces(); ++f) {
      const int part = parts.find(f);
      if (open[f]) part_open[part] = 1;
      volume[part] +=
          (soup().points[soup().face(f)[0]] - soup().points[soup().face(part)[0]]).dot(twice_vector_area(soup(), f));
    }
    std::set<int> inside_out;
    for (int f = 0; f < soup().num_faces(); ++f) {
      const int part = parts.find(f);
      if (part_open[part] || volume[part] >= 0) continue;
      inside_out.insert(part);
      reverse_face(soup(), f);
    }
    if (!inside_out.empty()) say(fmt::format("turned {} outside out", counted(inside_out.size(), "component")));
  }

  // Gives every fan of corners a vertex of its own. Sides stay joined only across edges with two faces that agree. An
  // edge may still be bad when its faces hang together around both ends; then its later faces go.
  void take_apart() {
    while (true) {
      split_bow_ties();
      std::vector<char> bad(static_cast<std::size_t>(soup().num_faces()), 0);
      bool any = false;
      FaceSides(soup(), all_faces(soup())).for_each_edge([&](std::span<const FaceSide> sides) {
        if (sides.size() < 2 || (sides.size() == 2 && sides[0].forward != sides[1].forward)) return;
        for (const FaceSide& side : sides.subspan(1)) bad[side.face] = 1;
        any = true;
      });
      if (!any) return;
      drop_faces("removed {} at edges that cannot be taken apart", [&](int f) { return bad[f] != 0; });
    }
  }

  void split_bow_ties() {
    DisjointSets fans(soup().corners.size());
    FaceSides(soup(), all_faces(soup())).for_each_edge([&](std::span<const FaceSide> sides) {
      if (sides.size() != 2 || sides[0].forward == sides[1].forward) return;
      fans.join(sides[0].corner, sides[1].next);
      fans.join(sides[0].next, sides[1].corner);
    });
    split_vertices(fans);
  }

  void split_vertices(DisjointSets& fans) {
    std::vector<int> vertex(soup().corners.size(), -1);
    std::vector<char> taken(soup().points.size(), 0);
    std::size_t split = 0;
    for (int c = 0; c < static_cast<int>(soup().corners.size()); ++c) {
      const int root = fans.find(c);  // the smallest corner, so it has been seen
      if (root != c) {
        vertex[c] = vertex[root];
        continue;
      }
      vertex[c] = soup().corners[c];
      if (!taken[vertex[c]]) {
        taken[vertex[c]] = 1;
        continue;
      }
      const Vec3 p = soup().points[vertex[c]];
      vertex[c] = soup().num_points();
      soup().points.push_back(p);
      ++split;
    }
    soup().corners = std::move(vertex);
    if (split > 0)
      say(fmt::format("took the surface apart at bow-ties and edges with too many faces: {} more vertices", split));
  }

  void drop_unused_vertices() {
    std::vector<int> number(soup().points.size(), -1);
    for (int v : soup().corners) number[v] = 0;
    std::vector<Vec3> kept;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] < 0) continue;
      number[v] = static_cast<int>(kept.size());
      kept.push_back(soup().points[v]);
    }
    const std::size_t dropped = number.size() - kept.size();
    for (int& v : soup().corners) v = number[v];
    soup().points = std::move(kept);
    if (dropped > 0) say(fmt::format("dropped {} {} without faces", dropped, dropped == 1 ? "vertex" : "vertices"));
  }

  const RepairOptions& options_;
  Repaired result_;
};

}  // namespace

Repaired repair(const PolygonSoup& soup, const RepairOptions& options) { return Repairer(soup, options).run(); }

}  // namespace plico
