#include "plico/io/pattern/fold_pieces.h"

#include "plico/base/error.h"
#include "plico/fold/net_piece.h"

namespace plico {

void set_pieces(FoldFile& file, const std::vector<std::string>& titles,
                const std::vector<std::optional<FoldingPath>>& paths) {
  const std::vector<NetPiece> pieces = pieces_of(file.net);
  PLICO_ASSERT(titles.size() == pieces.size() && paths.size() == pieces.size());
  file.pieces.clear();
  file.path.reset();
  file.path_points.clear();
  file.end_orders.clear();
  bool moves = false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    FoldFile alone;
    alone.net = pieces[i].net;
    if (paths[i]) set_path(alone, make_linkage(alone.net.sheet), *paths[i]);
    file.pieces.push_back({titles[i], std::move(alone.path), std::move(alone.path_points), {}});
    moves = moves || paths[i];
  }
  if (moves) file.path = joined_path(make_linkage(file.net.sheet), pieces, paths);
}

std::vector<FoldFile> piece_files(const FoldFile& kit) {
  std::vector<NetPiece> pieces = pieces_of(kit.net);
  PLICO_ASSERT(pieces.size() == kit.pieces.size());
  std::vector<FoldFile> files(pieces.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    FoldFile& file = files[i];
    file.net = std::move(pieces[i].net);
    file.net.mesh_face.clear();
    file.net.mesh_vertex.clear();
    file.net.mesh_edge.clear();
    file.unit = kit.unit;
    file.path = kit.pieces[i].path;
    file.path_points = kit.pieces[i].points;
  }
  return files;
}

}  // namespace plico
