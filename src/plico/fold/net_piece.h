// The pieces of a net as nets of their own. Pieces fold by themselves, so the motion of a net is that of its pieces.
#pragma once
#include <optional>
#include <vector>

#include "plico/fold/folding_path.h"
#include "plico/fold/unfolding.h"

namespace plico {

struct NetPiece {
  Unfolding net;  // in its place on the sheet, one part; panels, vertices and edges in the order of the whole net
  std::vector<int> panel, vertex, edge;  // their numbers in the whole net
  std::vector<int> hinge;                // of each of its hinges, the number in the linkage of the whole net
};

// One piece for each number in net.part. Edges that are glued to other pieces have no mate. Throws InvalidInput
// ("fold/piece") when two pieces are joined by a fold. O(n).
std::vector<NetPiece> pieces_of(const Unfolding& net);

// What one piece does while the whole net moves.
FoldingPath path_of_piece(const NetPiece& piece, const FoldingPath& whole);

// All pieces at the same time, one path each; a piece without one goes straight to its goal. A stop of one piece is a
// waypoint of all. `whole` is the linkage of the net. O(waypoints * hinges).
FoldingPath joined_path(const Linkage& whole, const std::vector<NetPiece>& pieces,
                        const std::vector<std::optional<FoldingPath>>& paths);

}  // namespace plico
