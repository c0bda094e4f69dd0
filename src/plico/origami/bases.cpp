#include "plico/origami/bases.h"

#include <array>
#include <utility>

#include "plico/fold/planar_faces.h"

namespace plico {
namespace {

struct Fold {
  int a, b;
  double degrees;  // of the goal
};

CreasePattern pattern(std::vector<Vec2> vertices, const std::vector<int>& outline, const std::vector<Fold>& folds) {
  CreasePattern sheet;
  sheet.vertices = std::move(vertices);
  for (const Fold& fold : folds) {
    const double angle = radians(fold.degrees);
    sheet.edges.push_back({fold.a, fold.b, assignment_of(angle), angle});
  }
  for (std::size_t i = 0; i < outline.size(); ++i)
    sheet.edges.push_back({outline[i], outline[(i + 1) % outline.size()], Assignment::Boundary, 0});
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

// Creases from the centre of [-1, 1]^2 in the eight directions that are multiples of 45 degrees; 0 for no crease.
CreasePattern spokes(const std::array<double, 8>& goal_degrees) {
  std::vector<Vec2> vertices = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {0, 0}};
  std::vector<int> outline;
  std::vector<Fold> folds;
  for (int k = 0; k < 8; ++k) {
    outline.push_back(k);
    if (goal_degrees[k] != 0) folds.push_back({8, k, goal_degrees[k]});
  }
  return pattern(std::move(vertices), outline, folds);
}

}  // namespace

CreasePattern l() {
  return pattern({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}}, {0, 1, 2, 3, 4, 5, 6, 7},
                 {{1, 6, 180}, {2, 5, 90}});
}

CreasePattern l2() { return spokes({180, 0, 90, 0, 180, 0, -90, 0}); }
CreasePattern waterbomb_base() { return spokes({90, -180, 90, -180, 90, -180, 90, -180}); }
CreasePattern diamond() { return spokes({-180, 180, -180, 0, -180, 180, -180, 0}); }
CreasePattern box1() { return spokes({90, 0, 90, 0, 90, -180, 180, 0}); }
CreasePattern fly1() { return spokes({-90, 180, -90, 180, -90, 180, -90, 180}); }

CreasePattern box2() {
  const int p = 10, q = 11;
  return pattern({{0, 0}, {1, 0}, {5, 0}, {6, 0}, {6, 1}, {6, 2}, {5, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}, {5, 1}},
                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                 {{p, q, 90},
                  {q, 2, 180},
                  {q, 3, -180},
                  {q, 4, 90},
                  {q, 6, 90},
                  {p, 7, 180},
                  {p, 8, -180},
                  {p, 9, 90},
                  {p, 1, 90}});
}

CreasePattern fly2() {
  const int o = 10, p = 11;
  return pattern(
      {{0, 0}, {6, 0}, {9, 0}, {12, 0}, {12, 3}, {12, 6}, {12, 12}, {6, 12}, {0, 12}, {0, 6}, {6, 6}, {9, 3}},
      {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
      {{o, 5, -90},
       {o, 6, 180},
       {o, 7, -90},
       {o, 8, 180},
       {o, 9, -90},
       {o, 0, 180},
       {o, 1, -90},
       {o, p, 180},
       {p, 2, 180},
       {p, 3, -180},
       {p, 4, 180}});
}

CreasePattern sailboat() {
  return pattern(
      {{12, 12}, {18, 12}, {15, 15}, {12, 18}, {6, 12}, {9, 9},  {12, 6}, {6, 6},  {4, 4},
       {24, 12}, {24, 24}, {12, 24}, {6, 24},  {0, 24}, {0, 18}, {0, 12}, {0, 8},  {0, 0},
       {8, 0},   {12, 0},  {18, 0},  {24, 0},  {24, 6}, {3, 21}, {6, 18}, {18, 6}, {21, 3}},
      {17, 18, 19, 20, 21, 22, 9, 10, 11, 12, 13, 14, 15, 16},
      {{0, 1, 180},   {0, 2, -180},  {0, 3, 180},   {0, 4, 180},    {0, 5, -180},   {0, 6, 180},   {1, 9, 180},
       {1, 2, 180},   {1, 6, -180},  {2, 10, -180}, {2, 3, -180},   {3, 11, 180},   {3, 4, 180},   {4, 15, 180},
       {4, 5, -180},  {5, 7, -180},  {5, 6, 180},   {6, 19, 180},   {7, 15, -180},  {7, 8, -180},  {7, 19, 180},
       {8, 16, 180},  {8, 17, -180}, {8, 18, -180}, {23, 12, -180}, {23, 14, -180}, {24, 11, 180}, {24, 15, 180},
       {25, 19, 180}, {25, 9, 180},  {26, 20, 180}, {26, 22, 180}});
}

CreasePattern plane() { return spokes({-90, 0, 180, 0, -90, 180, 0, 180}); }

// Sectors at each corner of the inner square: 90, 45, 90, 135 degrees. Around the square each crease's half-angle
// tangent is the same multiple of the one before, so only 0 and 180 degrees close.
CreasePattern square_twist() {
  return pattern({{3, 0},
                  {3, 3},
                  {1, 3},
                  {0, 3},
                  {-3, 3},
                  {-3, 1},
                  {-3, 0},
                  {-3, -3},
                  {-1, -3},
                  {0, -3},
                  {3, -3},
                  {3, -1},
                  {1, 0},
                  {0, 1},
                  {-1, 0},
                  {0, -1}},
                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                 {{12, 13, -180},
                  {13, 14, -180},
                  {14, 15, -180},
                  {15, 12, -180},
                  {12, 2, 180},
                  {12, 0, -180},
                  {13, 5, 180},
                  {13, 3, -180},
                  {14, 8, 180},
                  {14, 6, -180},
                  {15, 11, 180},
                  {15, 9, -180}});
}

// The flaps are as wide as the middle, so together they would run into each other halfway; and the bend can start only
// when both lie flat.
CreasePattern letter() {
  return pattern({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}, {2, 1}},
                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                 {{1, 10, 180}, {10, 7, 180}, {2, 11, 180}, {11, 6, 180}, {9, 10, 90}, {10, 11, -90}, {11, 4, 90}});
}

}  // namespace plico
