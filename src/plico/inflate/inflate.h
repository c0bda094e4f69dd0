// Dents of a mesh popped up by air, so that fewer of its vertices are hyperbolic and it unfolds and folds more easily.
// Source: [Xi17] 4.4.1, read as R8.
#pragma once
#include <string_view>
#include <utility>
#include <vector>

#include "plico/base/run.h"
#include "plico/inflate/energy.h"
#include "plico/mesh/mesh.h"

namespace plico {

enum class InflateMethod {
  Minimize,  // the skin's energy is minimized at each pressure: always ends, no step of time
  Explicit   // eq. 4.5 as printed, to compare with: P += dt f, at one pressure
};

struct InflateOptions {
  InflateMethod method = InflateMethod::Minimize;
  SkinOptions skin = {};
  // Multiples of skin.flattening that are tried as well, in this order, until one reaches until_hyperbolic; each above
  // 0. What helps depends on the mesh: of 44, each of the three is the best for some. Minimize only.
  std::vector<double> stronger = {8, 64};
  double max_growth = 0.05;       // how far the volume may change, either way, as a share of it; above 0
  int until_hyperbolic = 0;       // stop when no more vertices than this are hyperbolic; at least 0
  double pressure = 0;            // stop here; 0: whatever the other limits allow. Springs pull with 1 (SkinOptions)
  std::vector<FaceId> keep = {};  // faces that must not move
  std::vector<VertexId> keep_vertices = {};
  double time_step = 0.02;  // of Explicit, above 0
  int max_steps = 3000;     // of Explicit, at least 1
};
void check(const InflateOptions& options);  // throws InvalidOption

// Why the pressure rose no further. Settled: for many levels no vertex more became flat.
enum class InflateLimit { Hyperbolic, Growth, Pressure, Settled, Steps, Burst, Blocked, Time };
std::string_view name(InflateLimit limit);  // "hyperbolic", "growth", ...

struct Inflation {
  Ending ending = Ending::Exhausted;  // Found when until_hyperbolic is reached
  InflateLimit limit = InflateLimit::Growth;
  std::vector<Vec3> points;  // one a vertex, in the mesh's unit
  int hyperbolic_before = 0, hyperbolic = 0;
  double volume_before = 0, volume = 0;  // cubic units
  double excess_before = 0, excess = 0;  // sum of what face angles exceed 2 pi by at hyperbolic vertices, radians
  double flattening = 0;                 // of the skin that did best
  double pressure = 0;                   // at which it did
  int steps = 0;                         // of the minimizer, or of time
  std::vector<VertexId> held;            // vertices that stayed back, as a face there would have run into the surface
  std::vector<double> move;              // of each vertex, units
  double mean_move() const;
  double largest_move() const;
};

// Throws as inflate() does.
void check(const Mesh& mesh, const InflateOptions& options);

int count_hyperbolic(const Mesh& mesh);  // vertices; O(n)
double angle_excess(const Mesh& mesh);   // radians, as in Inflation; O(n)

// Inflates a closed triangle mesh.
//   - Its connectivity stays; no face meets another that it did not meet before, and none turns over.
//   - The volume grows or shrinks by no more than max_growth.
//   - Of all levels of pressure it is the one with the fewest hyperbolic vertices, then with the least change of
//   volume.
//   - Vertices of faces in `keep`, and those in `keep_vertices`, have the same coordinates to the last bit.
// With Minimize the pressure rises by half from level to level, each minimized from the one before; where a level would
// make faces meet, the vertices of these faces are held from there on. Always ends. Throws InvalidInput for a mesh that
// has a boundary, other faces than triangles or no positive volume. O(levels iterations n).
Inflation inflate(const Mesh& mesh, const InflateOptions& options = {}, const Run& run = {});

}  // namespace plico
