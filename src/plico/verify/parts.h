// Judges a mesh in parts from scratch: is this really the mesh, cut into these parts, each with its net, with seams
// that say on both sides where to glue? Shares no code with what makes parts and numbers seams.
#pragma once
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/unfolding.h"
#include "plico/verify/joints.h"
#include "plico/verify/net.h"

namespace plico {

// What a file says about its parts.
struct PartsClaim {
  std::vector<std::string> names;        // of each part
  std::vector<std::vector<int>> faces;   // mesh faces of each part
  std::vector<std::vector<int>> pieces;  // of each part: numbers in net.part of the connected pieces its net has
  std::vector<int> seam;                 // number of each sheet edge, 0 for none
  std::vector<int> steps;                // of each part: when it is put to the others, from 1; empty: nothing is said
  std::vector<char> folds;               // of each part: is it said to have a free motion? Empty: nothing is said
  struct Piece {
    std::string title;
    bool moves = false;  // has it a motion of its own?
  };
  std::vector<Piece> alone;        // of each piece of the net, as it stands alone in the file; empty: none does
  std::vector<JointClaim> joints;  // facets that are glued face to face
};

struct PartsVerdict {
  NetVerdict net;  // of all parts: closing says that each part, folded, is its place in the mesh
  int parts = 0, in_one_piece = 0;
  int seam_edges = 0;           // mesh edges between two parts
  double seam_length = 0;       // units of the mesh
  int joints = 0;               // facets that are glued face to face
  std::vector<Defect> defects;  // of the parts; of one kind the first few

  bool valid() const { return net.valid() && defects.empty(); }
};

// Checks the net as verify_net does, and that
//   - every part has a name of its own and a face, every mesh face is in exactly one part, and parts are connected;
//   - every piece of the net belongs to the part that names it, and to no other;
//   - an edge between two parts has exactly two copies, mates, equally long, with one number that no other edge has;
//     no other edge has a number;
//   - a piece that stands alone is called after its part, and has a motion when its part is said to;
//   - the order of assembly has every part once;
//   - facets to glue are of the parts that are named, and are shared as verify_joints() says.
// Never throws for wrong parts: it says what is wrong. O(n log n), and the net.
PartsVerdict verify_parts(const PartsClaim& claim, const Unfolding& net, const Mesh& mesh, const Run& run = {});

}  // namespace plico
