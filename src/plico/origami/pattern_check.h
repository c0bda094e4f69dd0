// Everything that is wrong with a crease pattern, or worth knowing, before it is folded: is it a plane drawing, can its
// vertices fold at all, does its goal close.
#pragma once
#include <string>
#include <vector>

#include "plico/fold/crease_pattern.h"
#include "plico/mesh/check.h"

namespace plico {

// A crease pattern's vertex inside the sheet. Creases with a goal of 0 are in `edges` and `sectors` like all others.
struct VertexFacts {
  int vertex = -1;
  std::vector<int> edges;       // counter-clockwise around it, of the sheet
  std::vector<double> sectors;  // from each edge to the next one, radians; they add up to 2 pi
  int mountains = 0, valleys = 0;
  bool flat_folded = false;  // every mountain and valley has a goal of 180 degrees, and there is one
  double kawasaki = 0;       // by how much every other sector between mountains and valleys misses pi, radians
  double residual = 0;       // by how much the goal fails to close, radians, in [0, pi]
};

// Every real vertex, ascending. `kawasaki` is 0 for vertices with an odd number of mountains and valleys, for which it
// says nothing. Throws as real_vertices does. O(edges log edges).
std::vector<VertexFacts> vertex_facts(const CreasePattern& sheet);

struct PatternProblem {
  Severity severity = Severity::Error;
  std::string code;                  // "origami/crossing": stable, for programs; the table is in docs/guide/origami.md
  std::string message;               // one sentence with ids, counted from 0
  std::string where;                 // the element with its coordinates
  std::string suggestion;            // what to do about it; empty when nothing needs doing
  std::vector<int> edges, vertices;  // the elements it is about
};

struct PatternCheckOptions {
  double angle = 1e-6;  // radians that sectors and the goal's loops may be off; above 0
  double place = 1e-9;  // two vertices nearer than this are one, as part of the sheet's diagonal; at least 0
};

struct PatternReport {
  std::vector<PatternProblem> problems;  // errors first, then warnings, then notes; within these in order of the checks
  int count(Severity severity) const;
  bool usable() const { return count(Severity::Error) == 0; }
};

// Error: no rigid panels. Warning: it cannot fold as it says it does. Note: a fact.
// Vertices are looked at only when the drawing is plane, so one cause is reported once. O(edges log edges) when edges
// are short against the drawing.
PatternReport check_pattern(const CreasePattern& sheet, const PatternCheckOptions& options = {});

// How many ways the flat sheet can begin to move, to first order: hinges less the rank of the flat loop equations.
// Sparse QR: seconds for 10,000 hinges.
int num_first_order_motions(const CreasePattern& sheet);

}  // namespace plico
