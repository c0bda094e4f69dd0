// Facts about a mesh: angles, areas, components, genus, boundary.
#pragma once
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

Vec3 normal(const Mesh& mesh, FaceId face);           // unit, outward (Newell); zero for a face without area
double area(const Mesh& mesh, FaceId face);           // square units
double length(const Mesh& mesh, EdgeId edge);         // units
Vec3 center(const Mesh& mesh, FaceId face);           // mean of the corners
double corner_angle(const Mesh& mesh, HalfedgeId h);  // inside the face at from(h), radians, in [0, 2 pi)

// Away from flat at an edge, in (-pi, pi], valley > 0 > mountain (R1): a convex edge is a mountain. 0 on the boundary.
double fold_angle(const Mesh& mesh, EdgeId edge);

double angle_sum(const Mesh& mesh, VertexId v);  // of the face angles at v, radians
bool is_boundary(const Mesh& mesh, VertexId v);
bool is_hyperbolic(const Mesh& mesh, VertexId v);  // interior, angle sum above 2 pi (R7)

Eigen::AlignedBox3d bounding_box(const Mesh& mesh);
double diagonal(const Mesh& mesh);  // of the bounding box
double mean_edge_length(const Mesh& mesh);
double surface_area(const Mesh& mesh);
double volume(const Mesh& mesh);  // signed, by the divergence theorem; meaningful for closed meshes

// Component number of every face, 0..k-1, numbered by first face.
struct Components {
  std::vector<int> of_face;
  int count = 0;
};
Components components(const Mesh& mesh);

// Boundary loops, each a list of vertices with the surface on the left.
std::vector<std::vector<VertexId>> boundary_loops(const Mesh& mesh);

bool is_closed(const Mesh& mesh);  // no boundary, and at least one face

// Closed, in one piece, of genus 0, and no edge a valley (beyond 1e-9 radians).
bool is_convex(const Mesh& mesh);

// Sum over the components, by Euler's formula; vertices without faces do not count.
int genus(const Mesh& mesh);

}  // namespace plico
