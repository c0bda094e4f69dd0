// Judges facets that are to be glued face to face: do they touch where they claim to?
#pragma once
#include <vector>

#include "plico/mesh/mesh.h"
#include "plico/verify/net.h"

namespace plico {

struct JointClaim {
  int first_face = 0, second_face = 0;  // turned to each other
  std::vector<Vec3> polygon;            // where they touch: convex, counter-clockwise seen from outside the first
  int first = -1, second = -1;          // the parts that are said to have these faces; -1: nothing is said
};

// Empty when every polygon is convex and has an area, lies in both faces (which may be of any shape) and turns as the
// first does, within `tolerance` of the diagonal, and no two joints glue the same faces. Codes "joint/...".
// O(corners of the polygon * of the faces) for each joint.
std::vector<Defect> verify_joints(const Mesh& mesh, const std::vector<JointClaim>& joints, double tolerance = 1e-6);

}  // namespace plico
