#include "plico/io/pattern/fold_pieces.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/fold/net_piece.h"

namespace plico {
namespace {

using KitJson = nlohmann::json;

// Three squares in a row and, apart from them, two: what becomes of two L-shaped strips of a mesh.
Unfolding two_strips() {
  PolygonSoup soup;
  const auto strip = [&](double y, int squares) {
    const int first = soup.num_points();
    for (int i = 0; i <= squares; ++i) {
      soup.points.emplace_back(i, y, i == squares ? 0.5 : 0.0);
      soup.points.emplace_back(i, y + 1, i == squares ? 0.5 : 0.0);
    }
    for (int i = 0; i < squares; ++i) {
      const int a = first + 2 * i;
      soup.add_face(std::array<int, 4>{a, a + 2, a + 3, a + 1});
    }
  };
  strip(0, 3);
  strip(5, 2);
  const Mesh mesh(soup);
  FoldForest all{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges())
    all.is_fold[e] = mesh.face(mesh.halfedge(e)).valid() && mesh.twin(mesh.halfedge(e)).valid();
  return lay_flat(mesh, all);
}

FoldingPath stopping_at(const Linkage& linkage, double time) {
  return {{{0, flat(linkage)}, {time, flat(linkage)}, {1, goal(linkage)}}};
}

// The first strip moves late, the second one has no motion.
FoldFile kit_of_two() {
  FoldFile file;
  file.net = two_strips();
  const std::vector<NetPiece> pieces = pieces_of(file.net);
  set_pieces(file, {"long", "short"}, {stopping_at(make_linkage(pieces[0].net.sheet), 0.25), std::nullopt});
  return file;
}

std::string kit_code(const KitJson& file) {
  try {
    read_fold(file.dump());
  } catch (const InvalidInput& error) {
    return error.code();
  }
  return "accepted";
}

TEST(NetPieces, StandWhereTheyStoodAndShareAllHinges) {
  const Unfolding net = two_strips();
  const std::vector<NetPiece> pieces = pieces_of(net);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].panel, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(pieces[1].panel, (std::vector<int>{3, 4}));
  for (const NetPiece& piece : pieces) {
    for (std::size_t v = 0; v < piece.vertex.size(); ++v)
      EXPECT_EQ(piece.net.sheet.vertices[v], net.sheet.vertices[piece.vertex[v]]);
    EXPECT_EQ(make_linkage(piece.net.sheet).num_hinges(), static_cast<int>(piece.hinge.size()));
  }
  EXPECT_EQ(pieces[0].hinge.size() + pieces[1].hinge.size(), 3u);
}

TEST(NetPieces, ThatAFoldJoinsAreRefused) {
  Unfolding net = two_strips();
  net.part[1] = 1;
  EXPECT_THROW(pieces_of(net), InvalidInput);
}

TEST(NetPieces, MoveInTheWholeAsTheyDoAlone) {
  const Unfolding net = two_strips();
  const std::vector<NetPiece> pieces = pieces_of(net);
  const Linkage whole = make_linkage(net.sheet);
  const FoldingPath late = stopping_at(make_linkage(pieces[1].net.sheet), 0.5);
  const FoldingPath joined = joined_path(whole, pieces, {std::nullopt, late});
  ASSERT_EQ(joined.waypoints.size(), 3u);
  EXPECT_EQ(path_of_piece(pieces[1], joined).at(0.75), late.at(0.75));
  const Configuration straight = path_of_piece(pieces[0], joined).at(0.5);
  EXPECT_EQ(straight, 0.5 * goal(make_linkage(pieces[0].net.sheet)));
}

TEST(FoldPieces, ReadBackByteForByte) {
  const FoldFile file = kit_of_two();
  const std::string bytes = write_fold(file);
  const FoldFile back = read_fold(bytes);
  ASSERT_EQ(back.pieces.size(), 2u);
  EXPECT_EQ(back.pieces[0].title, "long");
  EXPECT_TRUE(back.pieces[0].path);
  EXPECT_FALSE(back.pieces[1].path);
  ASSERT_TRUE(back.path) << "what all pieces do together";
  EXPECT_EQ(back.path->waypoints.size(), 3u);
  EXPECT_EQ(write_fold(back), bytes);
}

TEST(FoldPieces, AreModelsOfTheirOwnForOtherPrograms) {
  const KitJson file = KitJson::parse(write_fold(kit_of_two()));
  EXPECT_EQ(file["file_classes"], (KitJson{"multiModel", "animation"}));
  const KitJson& frames = file["file_frames"];
  ASSERT_EQ(frames.size(), 5u) << "a piece, its three waypoints, a piece";
  EXPECT_EQ(frames[0]["faces_vertices"].size(), 3u);
  EXPECT_EQ(frames[1]["frame_parent"], 1);
  EXPECT_EQ(frames[4]["frame_title"], "short");
}

TEST(FoldPieces, ThatDisagreeWithTheSheetAreRefused) {
  const KitJson file = KitJson::parse(write_fold(kit_of_two()));
  EXPECT_EQ(kit_code(file), "accepted");
  const auto broken = [&](auto change) {
    KitJson copy = file;
    change(copy["file_frames"]);
    return kit_code(copy);
  };
  EXPECT_EQ(broken([](KitJson& f) { f[0]["vertices_coords"][0][0] = 7; }), "fold/piece");
  EXPECT_EQ(broken([](KitJson& f) { f[0]["edges_foldAngle"][1] = 7; }), "fold/piece");
  EXPECT_EQ(broken([](KitJson& f) { f[4]["plico:piece"] = 0; }), "fold/piece");
  EXPECT_EQ(broken([](KitJson& f) { f[4].erase("plico:piece"); }), "fold/piece");
  EXPECT_EQ(broken([](KitJson& f) { f.erase(4); }), "fold/piece");
  EXPECT_EQ(broken([](KitJson& f) { f[2]["frame_parent"] = 0; }), "fold/motion");
  EXPECT_EQ(broken([](KitJson& f) { f[3].erase("plico:time"); }), "fold/piece") << "what follows stands apart";
  EXPECT_EQ(broken([](KitJson& f) { f.push_back(f[0]); }), "fold/piece");
  EXPECT_EQ(broken([](KitJson& f) { f[0]["frame_inherit"] = true; }), "fold/piece");
}

TEST(FoldPieces, KeepKeysOfOthers) {
  KitJson file = KitJson::parse(write_fold(kit_of_two()));
  file["file_frames"][0]["frame_description"] = "of someone else";
  const KitJson again = KitJson::parse(write_fold(read_fold(file.dump())));
  EXPECT_EQ(again, file);
}

TEST(FoldPieces, ShareANewMotionOfTheWhole) {
  FoldFile file = kit_of_two();
  const Linkage whole = make_linkage(file.net.sheet);
  set_path(file, whole, linear_path(whole));
  for (const FoldPiece& piece : file.pieces) {
    ASSERT_TRUE(piece.path);
    EXPECT_EQ(piece.path->waypoints.size(), 2u);
  }
  const std::string bytes = write_fold(file);
  EXPECT_EQ(write_fold(read_fold(bytes)), bytes);
}

TEST(FoldPieces, AsFilesOfTheirOwnAreSheetsWithTheirMotion) {
  const std::vector<FoldFile> files = piece_files(kit_of_two());
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(kind(files[0]), FoldKind::Motion);
  EXPECT_EQ(kind(files[1]), FoldKind::CreasePattern);
  const std::string bytes = write_fold(files[0]);
  EXPECT_EQ(write_fold(read_fold(bytes)), bytes);
}

}  // namespace
}  // namespace plico
