#include "plico/io/pattern/ori.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/fold/linkage.h"
#include "plico/io/pattern/pattern_file.h"

namespace plico {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A unit square cut along its diagonal; the triangle above it turns about the crease.
std::string square(const std::string& crease, const std::string& corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n") {
  return "4\n" + corners + "1\n" + crease + " 1 0\n2\n3 0 1 2 -1 -1\n3 0 2 3 0 0\n0\n0 1\n";
}

std::string code(const std::string& bytes) {
  try {
    read_ori(bytes, "x.ori");
  } catch (const InvalidInput& error) {
    return error.code() + " " + error.where();
  }
  return "accepted";
}

TEST(Ori, TheSideOfTheChildDecidesWhatIsAValley) {
  const OriFile left = read_ori(square("0 2 1.25")), right = read_ori(square("2 0 1.25"));
  ASSERT_EQ(left.pattern.sheet.num_edges(), 5);
  EXPECT_EQ(left.pattern.sheet.edges[0].fold_angle, 1.25);
  EXPECT_EQ(left.pattern.sheet.edges[0].assignment, Assignment::Valley);
  EXPECT_EQ(right.pattern.sheet.edges[0].fold_angle, -1.25);
  EXPECT_THAT(left.sign, ElementsAre(1));
  EXPECT_THAT(right.sign, ElementsAre(-1));
  EXPECT_TRUE(left.pattern.notes.empty());
}

// Seen from +y, x runs to the right and z towards the viewer's feet.
TEST(Ori, SheetsInThePlaneXzAreSeenFromAbove) {
  const OriFile flat = read_ori(square("0 2 1.25")),
                lying = read_ori(square("0 2 1.25", "0 0 0\n1 0 0\n1 0 -1\n0 0 -1\n"));
  EXPECT_EQ(lying.pattern.sheet.vertices, flat.pattern.sheet.vertices);
  EXPECT_EQ(lying.pattern.sheet.edges[0].fold_angle, 1.25);
  EXPECT_EQ(code(square("0 2 1", "0 0 0\n1 0 0\n1 1 1\n0 1 0\n")), "ori/not-flat x.ori");
}

TEST(Ori, AnglesOfSixDigitsAreMeantToBeRight) {
  const OriFile ori = read_ori(square("0 2 3.14159"));
  EXPECT_EQ(ori.pattern.sheet.edges[0].fold_angle, kPi);
  ASSERT_EQ(ori.pattern.notes.size(), 1u);
  EXPECT_THAT(ori.pattern.notes[0],
              HasSubstr("1 fold angle within 0.0003 degrees of a multiple of 90 was taken for it"));
  EXPECT_EQ(read_ori(square("0 2 1.5708")).pattern.sheet.edges[0].fold_angle, kPi / 2);
  EXPECT_EQ(read_ori(square("0 2 1.571")).pattern.sheet.edges[0].fold_angle, 1.571);
}

TEST(Ori, JsonSaysTheSame) {
  const std::string json = R"({"vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "creases": [[0,2,1.25,1,0]],
    "faces": [[3,0,1,2,-1,-1],[3,0,2,3,0,0]], "base_face_id": 0, "ordered_face_ids": [0,1]})";
  const OriFile text = read_ori(square("0 2 1.25")), other = read_ori(json);
  EXPECT_EQ(other.pattern.sheet.vertices, text.pattern.sheet.vertices);
  EXPECT_EQ(other.pattern.sheet.faces, text.pattern.sheet.faces);
  EXPECT_EQ(other.pattern.sheet.edges[0].fold_angle, 1.25);
  EXPECT_EQ(read_pattern(json, "a.ori.json").file.net.sheet.num_edges(), 5);
  EXPECT_EQ(read_pattern(json, "a.json.txt").file.net.sheet.num_edges(), 5);
  EXPECT_EQ(read_pattern(square("0 2 1"), "a.ori").file.net.sheet.num_edges(), 5);
  EXPECT_EQ(code("{}"), "ori/key x.ori");
  EXPECT_EQ(code(R"({"vertices": [[0,0]]})"), "ori/row x.ori, vertices[0]");
  EXPECT_EQ(code("{"), "ori/json x.ori:1:2");
}

TEST(Ori, MistakesAreNamedWithTheirPlace) {
  EXPECT_EQ(code("-1"), "ori/count x.ori:1");
  EXPECT_EQ(code("0 0 0"), "ori/empty x.ori");
  EXPECT_EQ(code(square("0 1 1")), "ori/crease x.ori, crease 0");
  EXPECT_EQ(code(square("0 9 1")), "ori/id x.ori, crease 0");
  EXPECT_EQ(code(square("0 2 4")), "ori/angle x.ori, crease 0");
  EXPECT_EQ(code(square("0 2 nan")), "ori/angle x.ori, crease 0");
  EXPECT_EQ(code("3\n0 0 0\n1 0 0\n2 0 0\n0\n1\n3 0 1 2 -1 -1"), "ori/face x.ori, face 0");
  EXPECT_EQ(code("3\n0 0 0\n1 0 0\n1 1 0\n0\n1\n4 0 1 2 -1 -1"), "ori/face x.ori, face 0");
}

TEST(Trj, DegreesInTextAndRadiansInJson) {
  const OriFile ori = read_ori(square("2 0 1.25"));  // its positive angles are mountains
  const FoldingPath text = read_trj("0\n 45\n90\n", ori), json = read_trj(R"({"trajs": [[0], [0.5], [1]]})", ori);
  ASSERT_EQ(text.waypoints.size(), 3u);
  EXPECT_EQ(text.waypoints[1].time, 0.5);
  EXPECT_EQ(text.waypoints[2].config[0], -kPi / 2);
  EXPECT_EQ(json.waypoints[1].config[0], -0.5);
}

TEST(Trj, FramesThatDoNotFitAreNamed) {
  const OriFile ori = read_ori(square("0 2 1"));
  const auto code_of = [&](const std::string& bytes) -> std::string {
    try {
      read_trj(bytes, ori, "x.trj");
    } catch (const InvalidInput& error) {
      return error.code() + " " + error.where();
    }
    return "accepted";
  };
  EXPECT_EQ(code_of("0\n1 2\n"), "trj/frame x.trj:2");
  EXPECT_EQ(code_of("0\n190\n"), "trj/angle x.trj:2");
  EXPECT_EQ(code_of("0\n"), "trj/frames x.trj");
  EXPECT_EQ(code_of(R"({"trajs": [[0], 3]})"), "trj/frame x.trj, trajs[1]");
  EXPECT_EQ(code_of(R"({"paths": []})"), "trj/key x.trj");
  EXPECT_EQ(code_of("0\nx\n"), "read/number x.trj:2");
}

}  // namespace
}  // namespace plico
