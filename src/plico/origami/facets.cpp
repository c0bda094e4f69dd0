#include "plico/origami/facets.h"

#include <array>
#include <limits>
#include <set>
#include <utility>

#include "plico/base/rng.h"
#include "plico/geom/predicates.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

constexpr double kSliver = 0.02;      // height over longest side: thinner facets are taken only when there is no other
constexpr double kNoTriangle = 1e-6;  // the same: such a facet has no plane
constexpr double kLocked = 10;        // times the longest side: a cut that leaves a vertex locked
constexpr double kLeastDrawn = 0.1, kMostDrawn = 4.1;  // times the length of a diagonal
constexpr double kNever = std::numeric_limits<double>::infinity();

// What each diagonal costs, by its corners i < j.
using CutCosts = std::vector<std::vector<double>>;

CutCosts cut_costs(const std::vector<Vec2>& corners, CutChoice choice, Rng rng) {
  const int size = static_cast<int>(corners.size());
  const double unit = (corners[1] - corners[0]).squaredNorm();  // costs stay lengths
  CutCosts costs(size, std::vector<double>(size, 0));
  for (int i = 0; i < size; ++i)
    for (int j = i + 1; j < size; ++j) {
      const double length = (corners[j] - corners[i]).norm();
      costs[i][j] = choice == CutChoice::Long ? unit / length : length;
      if (choice == CutChoice::Drawn) costs[i][j] *= rng.uniform(kLeastDrawn, kMostDrawn);
    }
  return costs;
}

// The cheapest triangulation of a simple polygon: best_[i][j] is the cost of what lies between corners i and j. A set
// of triangles that all turn left and whose outline is simple cannot overlap, so orientation is all that is asked.
class Triangulation {
 public:
  // `needs_cut`: the corners that stay locked when none of their panel's cuts ends there.
  Triangulation(std::vector<Vec2> corners, CutCosts costs, std::vector<char> needs_cut)
      : corners_(std::move(corners)),
        costs_(std::move(costs)),
        needs_cut_(std::move(needs_cut)),
        size_(static_cast<int>(corners_.size())),
        best_(size_, std::vector<double>(size_, 0)),
        apex_(size_, std::vector<int>(size_, -1)) {
    for (int width = 2; width < size_; ++width)
      for (int i = 0; i + width < size_; ++i) find_apex(i, i + width);
  }

  // Corners of each triangle; empty when there is none.
  std::vector<std::array<int, 3>> triangles() const {
    std::vector<std::array<int, 3>> result;
    if (size_ < 3 || best_[0][size_ - 1] == kNever) return result;
    std::vector<std::pair<int, int>> open = {{0, size_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j - i < 2) continue;
      const int k = apex_[i][j];
      result.push_back({i, k, j});
      open.emplace_back(k, j);
      open.emplace_back(i, k);
    }
    return result;
  }

 private:
  void find_apex(int i, int j) {
    best_[i][j] = kNever;
    const bool is_side = i == 0 && j == size_ - 1;
    for (int k = i + 1; k < j; ++k) {
      if (best_[i][k] == kNever || best_[k][j] == kNever) continue;
      const double cost = best_[i][k] + best_[k][j] + triangle_cost(i, k, j);
      if (cost >= best_[i][j]) continue;
      best_[i][j] = cost;
      apex_[i][j] = k;
    }
    if (!is_side) best_[i][j] += costs_[i][j];
  }

  // Of an ear: a triangle with two sides of the polygon, whose tip no cut reaches.
  double ear_cost(int i, int k, int j) const {
    const auto tip_cost = [&](int tip) { return needs_cut_[tip] ? kLocked : 0; };
    const bool is_last = i == 0 && j == size_ - 1;
    double cost = j - i == 2 ? tip_cost(k) : 0;
    if (is_last && k == 1) cost += tip_cost(i);
    if (is_last && k == j - 1) cost += tip_cost(j);
    return size_ > 3 ? cost : 0;
  }

  double triangle_cost(int i, int k, int j) const {
    const Vec2 &a = corners_[i], &b = corners_[k], &c = corners_[j];
    if (orient2d(a, b, c) <= 0) return kNever;
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const double height = cross(Vec2(b - a), Vec2(c - a)) / longest;
    if (height < kNoTriangle * longest) return kNever;
    return (ear_cost(i, k, j) + (height < kSliver * longest ? 100 : 0)) * longest;
  }

  std::vector<Vec2> corners_;
  CutCosts costs_;
  std::vector<char> needs_cut_;
  int size_;
  std::vector<std::vector<double>> best_;
  std::vector<std::vector<int>> apex_;
};

// Vertices inside the sheet where up to three creases meet, as on a curve drawn with straight creases: locked unless a
// cut on either side ends there.
std::vector<char> locked_vertices(const CreasePattern& sheet) {
  std::vector<char> locked(sheet.vertices.size(), 0);
  for (const RealVertex& vertex : real_vertices(sheet))
    if (!vertex.is_hole() && vertex.hinges.size() <= 3) locked[vertex.vertex] = 1;
  return locked;
}

bool has_equal_corners(const std::vector<int>& face) {
  return std::set<int>(face.begin(), face.end()).size() != face.size();
}

}  // namespace

Facets cut_into_facets(const CreasePattern& sheet, CutChoice choice, std::uint64_t seed) {
  Facets result;
  result.sheet.vertices = sheet.vertices;
  result.sheet.edges = sheet.edges;
  result.first_cut = sheet.num_edges();
  const std::vector<char> locked = locked_vertices(sheet);
  const Rng rng(seed);
  for (int f = 0; f < sheet.num_faces(); ++f) {
    const std::vector<int>& face = sheet.faces[f];
    std::vector<std::array<int, 3>> triangles;
    if (face.size() > 3 && !has_equal_corners(face)) {
      std::vector<char> needs_cut;
      for (int v : face) needs_cut.push_back(locked[v]);
      const std::vector<Vec2> corners = polygon(sheet, f);
      triangles = Triangulation(corners, cut_costs(corners, choice, rng.stream(f)), std::move(needs_cut)).triangles();
    }
    if (triangles.empty()) {
      result.sheet.faces.push_back(face);
      result.panel.push_back(f);
      continue;
    }
    const int last = static_cast<int>(face.size()) - 1;
    for (const auto& [i, k, j] : triangles) {
      result.sheet.faces.push_back({face[i], face[k], face[j]});
      result.panel.push_back(f);
      if (i != 0 || j != last) result.sheet.edges.push_back({face[i], face[j], Assignment::Flat, 0});
    }
  }
  return result;
}

CreasePattern with_flat_creases_held(CreasePattern sheet) {
  for (Crease& crease : sheet.edges)
    if (crease.fold_angle == 0 && (crease.assignment == Assignment::Flat || crease.assignment == Assignment::Join))
      crease.limit = 0;
  return sheet;
}

}  // namespace plico
