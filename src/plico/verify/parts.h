// Judges a mesh in parts from scratch: is this really the mesh, cut into these parts, each with its net, with seams
// that say on both sides where to glue? Shares no code with what makes parts and numbers seams.
#pragma once
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/verify/net.h"

namespace plico {

// What a file says about its parts.
struct PartsClaim {
  std::vector<std::string> names;        // of each part
  std::vector<std::vector<int>> faces;   // mesh faces of each part
  std::vector<std::vector<int>> pieces;  // of each part: numbers in net.part of the connected pieces its net has
  std::vector<int> seam;                 // number of each sheet edge, 0 for none
};

struct PartsVerdict {
  NetVerdict net;  // of all parts: closing says that each part, folded, is its place in the mesh
  int parts = 0, in_one_piece = 0;
  int seam_edges = 0;           // mesh edges between two parts
  double seam_length = 0;       // units of the mesh
  std::vector<Defect> defects;  // of the parts; of one kind the first few

  bool valid() const { return net.valid() && defects.empty(); }
};

// Checks the net as verify_net does, and that
//   - every part has a name of its own and a face, every mesh face is in exactly one part, and parts are connected;
//   - every piece of the net belongs to the part that names it, and to no other;
//   - an edge between two parts has exactly two copies, mates, equally long, with one number that no other edge has;
//     no other edge has a number.
// Never throws for wrong parts: it says what is wrong. O(n log n), and the net.
PartsVerdict verify_parts(const PartsClaim& claim, const Unfolding& net, const Mesh& mesh, const Run& run = {});

}  // namespace plico
