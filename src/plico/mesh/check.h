// Everything that is wrong with a polygon soup, or worth knowing, before it becomes a Mesh.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

// Error: no surface that can be unfolded. Warning: can be unfolded, but is probably not what was meant. Note: a fact.
enum class Severity { Error, Warning, Note };
std::string_view name(Severity severity);  // "error", "warning", "note"

struct Problem {
  Severity severity = Severity::Error;
  std::string code;                  // "mesh/edge-faces": stable, for programs; the table is in docs/guide/meshes.md
  std::string message;               // one sentence with ids, counted from 0
  std::string where;                 // the element with its vertices and a coordinate; empty for the whole
  std::string suggestion;            // a command to try; empty when there is none
  std::vector<int> faces, vertices;  // the elements it is about
};

struct CheckOptions {
  double planarity = 1e-5;  // of the face's size: how far a corner may be off the plane; above 0
  double max_coordinate = kMaxCoordinate;
  int max_faces = 5'000'000;       // at least 1
  bool self_intersections = true;  // the only check that costs more than sorting
};

struct CheckReport {
  std::vector<Problem> problems;  // errors first, then warnings, then notes; within these in the order of the checks
  int count(Severity severity) const;
  bool usable() const { return count(Severity::Error) == 0; }
};

// Lists every problem. A face with an error in itself (index, corner twice, no area) takes no part in the checks of
// edges and vertices, so one cause is reported once. O(n log n).
CheckReport check_mesh(const PolygonSoup& soup, const CheckOptions& options = {});

// The mesh; throws the first error of check_mesh as InvalidInput. Warnings pass.
Mesh require_mesh(PolygonSoup soup, const CheckOptions& options = {});

// A face's farthest corner from its mean plane, divided by the greatest distance of a corner from the first one.
double warp(const PolygonSoup& soup, int face);

// Is the area zero, to within `least` of the square of its size?
bool is_degenerate(const PolygonSoup& soup, int face, double least = 1e-12);

// Does the outline of a polygon cross or touch itself, seen along its normal?
bool crosses_itself(const PolygonSoup& soup, int face);

}  // namespace plico
