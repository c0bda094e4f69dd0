#include "plico/io/pattern/fold.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "plico/base/error.h"

namespace plico {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::SizeIs;

Mesh cube() {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (auto f : std::vector<std::array<int, 4>>{
           {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    soup.add_face(f);
  return Mesh(soup);
}

// The cross: the bottom, the four walls around it, the top on the first wall.
Unfolding cross_net(const Mesh& mesh) {
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges()) {
    const auto [f, g] = std::minmax({int(mesh.face(mesh.halfedge(e))), int(mesh.face(mesh.twin(mesh.halfedge(e))))});
    forest.is_fold[e] = f == 0 || (f == 1 && g == 2);
  }
  return lay_flat(mesh, forest);
}

std::string code_of(const std::string& bytes) {
  try {
    read_fold(bytes);
  } catch (const InvalidInput& error) {
    EXPECT_STRNE(error.what(), "");
    return error.code();
  }
  return "accepted";
}

const char* const kSquare = R"("vertices_coords": [[0,0],[1,0],[1,1],[0,1]])";
const char* const kDiagonal = R"("edges_vertices": [[0,1],[1,2],[2,3],[3,0],[0,2]])";

FoldFile square_with(const std::string& more) {
  return read_fold(fmt::format("{{{},{}{}}}", kSquare, kDiagonal, more));
}
std::string square_code(const std::string& more) {
  return code_of(fmt::format("{{{},{}{}}}", kSquare, kDiagonal, more));
}

TEST(Fold, NetHasTheKeysOfTheFormatInTheirOrder) {
  const Mesh mesh = cube();
  FoldFile file = fold_file(mesh, cross_net(mesh));
  file.report = R"({"seed":1})";
  const auto written = nlohmann::ordered_json::parse(write_fold(file));
  std::vector<std::string> keys;
  for (const auto& [key, value] : written.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("file_spec", "file_creator", "file_classes", "frame_classes", "frame_attributes",
                                "frame_unit", "vertices_coords", "vertices_plico:mesh_vertex", "edges_vertices",
                                "edges_assignment", "edges_foldAngle", "edges_plico:mate", "faces_vertices",
                                "faces_plico:mesh_face", "plico:report", "file_frames"));
  EXPECT_EQ(written["file_spec"], 1.2);
  EXPECT_EQ(written["file_frames"].size(), 1u);
  EXPECT_EQ(written["vertices_coords"].size(), 14u) << "a cube's net has 14 corners";
  const auto folds = std::count(written["edges_assignment"].begin(), written["edges_assignment"].end(), "M");
  EXPECT_EQ(folds, 5);
  for (const auto& angle : written["edges_foldAngle"]) EXPECT_TRUE(angle == 0 || angle == -90) << angle;
}

TEST(Fold, NetReadsBackNumberForNumber) {
  const Mesh mesh = cube();
  const Unfolding net = cross_net(mesh);
  const std::string bytes = write_fold(fold_file(mesh, net));
  const FoldFile back = read_fold(bytes);
  EXPECT_EQ(kind(back), FoldKind::Net);
  EXPECT_EQ(back.net.sheet.vertices, net.sheet.vertices);
  EXPECT_EQ(back.net.sheet.faces, net.sheet.faces);
  EXPECT_EQ(back.net.mate, net.mate);
  EXPECT_EQ(back.net.mesh_face, net.mesh_face);
  EXPECT_EQ(back.net.mesh_vertex, net.mesh_vertex);
  EXPECT_EQ(back.net.part, net.part);
  EXPECT_EQ(write_fold(back), bytes);
}

TEST(Fold, LimitsOfCreasesAreWrittenAndReadBack) {
  const Mesh mesh = cube();
  FoldFile file = fold_file(mesh, cross_net(mesh));
  EXPECT_EQ(write_fold(file).find("maxFoldAngle"), std::string::npos);
  file.net.sheet.edges[2].limit = radians(95);
  file.net.sheet.edges[3].limit = 0;
  const std::string bytes = write_fold(file);
  EXPECT_NE(bytes.find("\"edges_plico:maxFoldAngle\":[null,null,95,0,null"), std::string::npos) << bytes;
  const FoldFile back = read_fold(bytes);
  EXPECT_EQ(back.net.sheet.edges[2].limit, radians(95));
  EXPECT_EQ(back.net.sheet.edges[3].limit, 0);
  EXPECT_EQ(back.net.sheet.edges[4].limit, kPi);
  EXPECT_EQ(write_fold(back), bytes);
}

TEST(Fold, FoldedFormIsTheMeshAndNamesTheMeshEdges) {
  const Mesh mesh = cube();
  const Unfolding net = cross_net(mesh);
  FoldFile back = read_fold(write_fold(fold_file(mesh, net)));
  const Mesh folded = folded_mesh(back);
  EXPECT_EQ(folded.soup().corners, mesh.soup().corners);
  EXPECT_EQ(folded.soup().points, mesh.soup().points);
  attach_mesh(back.net, folded);
  EXPECT_EQ(back.net.mesh_edge, net.mesh_edge);
}

TEST(Fold, PartsAreWrittenWhenThereAreSeveral) {
  const Mesh mesh = cube();
  const Unfolding pieces = lay_flat(mesh, {std::vector<char>(mesh.num_edges(), 0)});
  const std::string bytes = write_fold(fold_file(mesh, pieces));
  EXPECT_THAT(bytes, HasSubstr("\"faces_plico:part\":[0,1,2,3,4,5]"));
  EXPECT_EQ(read_fold(bytes).net.part, pieces.part);
}

TEST(Fold, MotionIsOneFrameAWaypoint) {
  const Mesh mesh = cube();
  FoldFile file = fold_file(mesh, cross_net(mesh));
  const Linkage linkage = make_linkage(file.net.sheet, file.net.mate);
  set_path(file, linkage, linear_path(linkage));
  const std::string bytes = write_fold(file);
  const Json written = Json::parse(bytes);
  EXPECT_EQ(written["file_classes"][0], "animation");
  ASSERT_EQ(written["file_frames"].size(), 3u);
  EXPECT_EQ(written["file_frames"][1]["plico:time"], 0);
  EXPECT_EQ(written["file_frames"][2]["edges_foldAngle"], written["edges_foldAngle"]);
  const FoldFile back = read_fold(bytes);
  EXPECT_EQ(kind(back), FoldKind::Motion);
  ASSERT_THAT(back.path->waypoints, SizeIs(2));
  EXPECT_EQ(back.path->waypoints[1].config, goal(linkage));
  EXPECT_EQ(back.path_points, file.path_points);
  EXPECT_EQ(write_fold(back), bytes);
}

TEST(Fold, UnknownKeysAndFramesAreKept) {
  const FoldFile file =
      square_with(R"(,"file_author":"Ann \"A\"","faceOrders":[[0,1,1]],"edges_x:tint":["red",2.5e3,null,{},[]],
    "file_frames":[{"frame_title":"later","frame_inherit":true}])");
  EXPECT_THAT(file.other, ElementsAre(Pair("edges_x:tint", R"(["red",2500.0,null,{},[]])"),
                                      Pair("faceOrders", "[[0,1,1]]"), Pair("file_author", R"("Ann \"A\"")")));
  EXPECT_THAT(file.other_frames, ElementsAre(R"({"frame_inherit":true,"frame_title":"later"})"));
  const FoldFile again = read_fold(write_fold(file));
  EXPECT_EQ(again.other, file.other);
  EXPECT_EQ(again.other_frames, file.other_frames);
}

TEST(Fold, MissingFacesComeFromThePlanarGraph) {
  EXPECT_THAT(square_with("").net.sheet.faces, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(2, 3, 0)));
}

TEST(Fold, MissingEdgesAreTheSidesOfTheFaces) {
  const CreasePattern sheet = read_fold(fmt::format(R"({{{},"faces_vertices":[[0,1,2],[0,2,3]]}})", kSquare)).net.sheet;
  ASSERT_EQ(sheet.num_edges(), 5);
  EXPECT_EQ(sheet.edges[0].assignment, Assignment::Boundary);
  EXPECT_EQ(sheet.edges[2].assignment, Assignment::Unassigned) << "the diagonal";
}

TEST(Fold, MissingEdgesFollowFromTheNeighboursOfTheVertices) {
  EXPECT_EQ(read_fold(fmt::format(R"({{{},"vertices_vertices":[[1,2,3],[2,0],[3,0,1],[0,2]]}})", kSquare))
                .net.sheet.num_faces(),
            2);
}

TEST(Fold, AssignmentsAndAnglesFillEachOther) {
  const CreasePattern from_letters = square_with(R"(,"edges_assignment":["B","B","B","B","V"])").net.sheet;
  EXPECT_EQ(from_letters.edges[4].fold_angle, kPi);
  const CreasePattern from_angles = square_with(R"(,"edges_foldAngle":[null,0,0,0,-30])").net.sheet;
  EXPECT_EQ(from_angles.edges[4].assignment, Assignment::Mountain);
  EXPECT_DOUBLE_EQ(from_angles.edges[4].fold_angle, radians(-30));
  EXPECT_EQ(from_angles.edges[0].assignment, Assignment::Boundary);
  EXPECT_EQ(square_with(R"(,"edges_foldAngles":[0,0,0,0,90])").net.sheet.edges[4].assignment, Assignment::Valley)
      << "FOLD 1.0";
}

TEST(Fold, EveryLetterIsRead) {
  for (char letter : std::string("BMVFUCJ")) {
    const FoldFile file = square_with(fmt::format(R"(,"edges_assignment":["B","B","B","B","{}"])", letter));
    EXPECT_EQ(static_cast<char>(file.net.sheet.edges[4].assignment), letter);
  }
}

TEST(Fold, ClockwiseFacesOfOthersAreTurnedOver) {
  const std::string faces = R"(,"faces_vertices":[[2,1,0],[0,2,3]])";
  EXPECT_THAT(square_with(faces).net.sheet.faces[0], ElementsAre(0, 1, 2));
  const std::string ours = faces + R"(,"faces_plico:mesh_face":[0,1])";
  EXPECT_THAT(square_code(ours), "fold/side-used-twice")
      << "a net with a mirrored panel must not be repaired in silence";
}

TEST(Fold, SheetMayStandInALaterFrame) {
  const FoldFile file = read_fold(R"({"file_spec":1.1,"file_title":"t","frame_title":"form",
    "vertices_coords":[[0,0,0],[1,0,0],[1,1,1]],"edges_vertices":[[0,1],[1,2],[2,0]],
    "file_frames":[{"frame_inherit":true,"frame_parent":0,"frame_title":"sheet","vertices_coords":[[0,0],[1,0],[1,1]]},
                   {"frame_inherit":true,"frame_parent":0}]})");
  EXPECT_EQ(file.net.sheet.num_faces(), 1);
  EXPECT_THAT(file.other, ElementsAre(Pair("file_title", "\"t\""), Pair("frame_title", "\"sheet\"")));
  ASSERT_THAT(file.other_frames, SizeIs(2));
  EXPECT_THAT(file.other_frames[0], HasSubstr("\"form\"")) << "the key frame took the sheet's place";
  EXPECT_EQ(Json::parse(file.other_frames[1])["frame_parent"], 1);
}

TEST(Fold, BadFilesAreNamedByCode) {
  EXPECT_EQ(code_of(""), "fold/json");
  EXPECT_EQ(code_of("{\"file_spec\": 1.2,"), "fold/json");
  EXPECT_EQ(code_of("[]"), "fold/json");
  EXPECT_EQ(code_of("{\"vertices_coords\":[[1e999,0]]}"), "fold/number");
  EXPECT_EQ(code_of("{\"vertices_coords\":[[0,0],[1,0],[0,-2e30]],\"faces_vertices\":[[0,1,2]]}"), "fold/number");
  EXPECT_EQ(code_of(std::string(200, '[') + std::string(200, ']')), "fold/depth");
  EXPECT_EQ(code_of("{\"file_spec\": 2}"), "fold/version");
  EXPECT_EQ(code_of("{}"), "fold/no-sheet");
  EXPECT_EQ(code_of(R"({"vertices_coords":[[0,0,0],[1,0,0],[1,1,1],[0,1,0]]})"), "fold/no-sheet");
  EXPECT_EQ(code_of(fmt::format("{{{}}}", kSquare)), "fold/no-faces");
  EXPECT_EQ(square_code(R"(,"edges_assignment":["B"])"), "fold/length");
  EXPECT_EQ(square_code(R"(,"edges_assignment":["B","B","B","B","X"])"), "fold/assignment");
  EXPECT_EQ(square_code(R"(,"edges_foldAngle":[0,0,0,0,"1"])"), "fold/type");
  EXPECT_EQ(square_code(R"(,"edges_foldAngle":[0,0,0,0,181])"), "fold/angle");
  EXPECT_EQ(square_code(R"(,"faces_vertices":[[0,1]])"), "fold/face");
  EXPECT_EQ(square_code(R"(,"faces_vertices":[[0,1,1]])"), "fold/face");
  EXPECT_EQ(square_code(R"(,"faces_vertices":[[0,1,4]])"), "fold/index");
  EXPECT_EQ(square_code(R"(,"faces_vertices":[[0,1,-1]])"), "fold/index");
  EXPECT_EQ(square_code(R"(,"faces_vertices":[[0,1,2],[0,1,3]])"), "fold/side-used-twice");
  EXPECT_EQ(square_code(R"(,"file_frames":3)"), "fold/type");
  EXPECT_EQ(square_code(R"(,"file_frames":[{"frame_inherit":true,"frame_parent":1}])"), "fold/parent");
  EXPECT_EQ(code_of(fmt::format(R"({{{},"edges_vertices":[[0,2],[1,3]]}})", kSquare)), "fold/edges-cross");
  EXPECT_EQ(code_of(fmt::format(R"({{{},"edges_vertices":[[0,0]]}})", kSquare)), "fold/edge");
}

TEST(Fold, MessagesSayWhere) {
  try {
    read_fold("{\n  \"file_spec\": 1.2,\n  oops\n}", "a.fold");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.where(), "a.fold:3:3");
  }
  try {
    square_with(R"(,"faces_vertices":[[0,1,2],[0,2,9]])");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.where(), "faces_vertices[1]");
    EXPECT_STREQ(error.what(), "faces_vertices holds index 9, must be in [0, 3]");
  }
}

TEST(Fold, AnglesAreWrittenAsTheyWereRead) {
  for (const char* angle :
       {"90", "-60.5", "0.1", "35.26438968275465", "179.99999999999997", "-180", "1e-12", "54.735610317245346"}) {
    const std::string bytes = write_fold(square_with(fmt::format(R"(,"edges_foldAngle":[0,0,0,0,{}])", angle)));
    EXPECT_EQ(write_fold(read_fold(bytes)), bytes);
    EXPECT_THAT(bytes, HasSubstr(fmt::format("\"edges_foldAngle\":[0,0,0,0,{}]", angle)));
  }
}

// A square with a valley on its diagonal; `place` says where (u, v) lies in space.
std::string folded_square(const std::string& file_class, const std::vector<std::string>& corners) {
  return R"({"frame_classes":[")" + file_class + R"("],"vertices_coords":[)" + corners[0] + "," + corners[1] + "," +
         corners[2] + "," + corners[3] + R"(],"edges_vertices":[[0,1],[1,2],[2,3],[3,0],[0,2]],
    "edges_assignment":["B","B","B","B","V"],"faces_vertices":[[0,1,2],[0,2,3]]})";
}

TEST(ReadFold, AFlatFrameIsTheSheetWhateverItIsCalledAndInAnyPlane) {
  const FoldFile called = read_fold(folded_square("foldedForm", {"[0,0,0]", "[2,0,0]", "[2,1,0]", "[0,1,0]"}));
  EXPECT_EQ(called.net.sheet.num_faces(), 2);
  EXPECT_EQ(called.notes.size(), 1U);
  const FoldFile lying = read_fold(folded_square("creasePattern", {"[0,5,0]", "[2,5,0]", "[2,5,-1]", "[0,5,-1]"}));
  EXPECT_EQ(lying.net.sheet.vertices, called.net.sheet.vertices);
  EXPECT_EQ(lying.net.sheet.faces, called.net.sheet.faces);
  const FoldFile upright = read_fold(folded_square("foldedForm", {"[3,0,0]", "[3,2,0]", "[3,2,1]", "[3,0,1]"}));
  EXPECT_EQ(upright.net.sheet.vertices, called.net.sheet.vertices);
  EXPECT_EQ(upright.notes.size(), 2U);
}

// The plane is spanned by (3, 0, 4) / 5 and (0, 1, 0), so its front is seen from (-4, 0, 3): from -x, which is turned
// to +x, and y goes to the right.
TEST(ReadFold, ATiltedSheetKeepsItsShapeAndItsFront) {
  const auto file = [](double off) {
    return read_fold(fmt::format(
        R"({{"vertices_coords":[[1,2,3],[4,2,{}],[4,7,7],[1,7,3]],{},"edges_assignment":["B","B","B","B","M"]}})",
        7 + off, kDiagonal));
  };
  const FoldFile tilted = file(0), rounded = file(1e-5);
  for (const FoldFile& f : {tilted, rounded}) {
    EXPECT_THAT(f.notes, ElementsAre("the sheet lies in a tilted plane and was laid into that of x and y"));
    EXPECT_EQ(f.net.sheet.num_faces(), 2);
    const std::vector<Vec2>& at = f.net.sheet.vertices;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR((at[i] - at[(i + 1) % 4]).norm(), 5, 1e-4);
    EXPECT_NEAR(at[3].x() - at[0].x(), 5, 1e-4) << "y goes to the right";
    EXPECT_NEAR(at[1].y() - at[0].y(), 5, 1e-4) << "seen from +x, z goes up";
  }
  EXPECT_EQ(
      code_of(R"({"vertices_coords":[[1,2,3],[4,2,7],[4,7,7.1],[1,7,3]],"edges_vertices":[[0,1],[1,2],[2,3],[3,0]]})"),
      "fold/no-sheet")
      << "not flat";
}

TEST(ReadFold, AFormThatIsFoldedFlatIsNoSheet) {
  EXPECT_THROW(read_fold(folded_square("foldedForm", {"[0,0,0]", "[2,0,0]", "[1,1,0]", "[2,0.5,0]"})), InvalidInput);
}

}  // namespace
}  // namespace plico
