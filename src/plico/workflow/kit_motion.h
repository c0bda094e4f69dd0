// The motions of all pieces of a kit as one motion of the sheet that holds their nets.
#pragma once
#include <optional>

#include "plico/fold/net_piece.h"
#include "plico/mesh/mesh.h"
#include "plico/workflow/kit.h"

namespace plico {

// The motion of each piece of kit.net, proven or not; none where its part has none, or nothing turns.
std::vector<std::optional<FoldingPath>> paths_of_pieces(const Mesh& mesh, const Kit& kit,
                                                        const std::vector<NetPiece>& pieces);

// Every piece moves as its own motion says, all at the same time; a piece without one goes straight to its goal. The
// whole is proven again, as the motion of linkage_of(kit.net): each piece is free of itself, pieces are apart. None
// when nothing moves. Its method is that of all pieces, or LazyPrm when they differ. O(waypoints * hinges) beside the
// proof.
std::optional<Motion> motion_of_pieces(const Mesh& mesh, const Kit& kit, const Run& run = {});

}  // namespace plico
