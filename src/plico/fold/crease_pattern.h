// A flat sheet of panels that meet at creases: FOLD's key frame as a value. Nets, crease patterns and strips all carry
// one; what they add is where it came from.
#pragma once
#include <utility>
#include <vector>

#include "plico/base/vec.h"

namespace plico {

enum class Assignment : char {
  Boundary = 'B',
  Mountain = 'M',
  Valley = 'V',
  Flat = 'F',
  Unassigned = 'U',
  Cut = 'C',
  Join = 'J'
};

struct Crease {
  int a = -1, b = -1;  // vertices
  Assignment assignment = Assignment::Unassigned;
  double fold_angle = 0;  // target, radians in [-pi, pi], valley > 0 > mountain (R1)
  double limit = kPi;     // largest size of a fold angle that the material allows, radians in [0, pi]
};

struct CreasePattern {
  std::vector<Vec2> vertices;  // n x 2
  std::vector<Crease> edges;
  std::vector<std::vector<int>> faces;  // vertices of each panel, counter-clockwise, front up

  int num_vertices() const { return static_cast<int>(vertices.size()); }
  int num_edges() const { return static_cast<int>(edges.size()); }
  int num_faces() const { return static_cast<int>(faces.size()); }
};

// The panels beside each edge: `left` has the edge run a -> b along its boundary, `right` has it b -> a; -1 for none.
// Throws InvalidInput when an edge borders two panels on one side. O(n log n).
struct EdgeSides {
  int left = -1, right = -1;
};
std::vector<EdgeSides> edge_sides(const CreasePattern& pattern);

// The connected piece of every panel, 0..k-1, numbered by first panel. Throws as edge_sides does.
std::vector<int> parts_of(const CreasePattern& pattern);

// Corners of a panel in the plane.
std::vector<Vec2> polygon(const CreasePattern& pattern, int face);

// Fold angles of `valley` sign get 'V', of `mountain` sign 'M', those within `flat` radians of zero 'F'.
Assignment assignment_of(double fold_angle, double flat = 1e-9);

// What a letter alone asks for: mountain and valley are folded flat, -pi and pi; all others 0.
double flat_fold_angle(Assignment assignment);

// Do the panels beside an edge turn about it? Not at borders and cuts, even when panels touch there.
bool is_hinge(const Crease& edge, const EdgeSides& sides);

}  // namespace plico
