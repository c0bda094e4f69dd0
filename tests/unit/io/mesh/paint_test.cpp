#include <gmock/gmock.h>

#include <map>

#include "plico/base/error.h"
#include "plico/io/mesh/gltf.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/mesh/mtl.h"
#include "plico/io/mesh/obj.h"
#include "plico/io/mesh/read_paint.h"
#include "plico/io/text/base64.h"
#include "plico/io/text/bytes.h"
#include "plico/io/text/png.h"

namespace plico {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Color kRed{1, 0, 0}, kBlue{0, 0, 1};
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
const std::string kPicture = write_png({2, 1, {255, 0, 0, 255, 0, 0, 255, 255}});  // red, blue

std::optional<std::string> no_files(const std::string&) { return {}; }

PaintRead paint_of(const std::string& obj, const std::map<std::string, std::string>& files) {
  const MeshSource source = read_obj(obj);
  return read_paint(source, [&](const std::string& name) -> std::optional<std::string> {
    const auto at = files.find(name);
    return at == files.end() ? std::nullopt : std::optional(at->second);
  });
}

TEST(ReadMtl, TakesColoursAndPicturesWithSpacesInTheirNames) {
  const auto materials = read_mtl("newmtl my skin\r\nKd 1 0 0\r\nmap_Kd -s 2 3 1 -clamp on my skin.png\r\n", "m.mtl");
  ASSERT_EQ(materials.size(), 1U);
  EXPECT_EQ(materials[0].name, "my skin");
  EXPECT_EQ(materials[0].color, kRed);
  EXPECT_EQ(materials[0].picture, "my skin.png");
  EXPECT_EQ(materials[0].scale, Vec2(2, 3));
}

TEST(ReadMtl, SaysWhereAColourIsNone) {
  try {
    read_mtl("newmtl a\nKd 1 red 0\n", "m.mtl");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.where(), "m.mtl:2");
  }
}

TEST(ReadPaint, GivesEachFaceTheColourOfItsMaterial) {
  const PaintRead read = paint_of("mtllib m.mtl\n" + kTriangle + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 2\n",
                                  {{"m.mtl", "newmtl b\nKd 0 0 1\nnewmtl a\nKd 1 0 0\n"}});
  ASSERT_EQ(read.paint.triangles.size(), 2U);
  EXPECT_EQ(read.paint.triangles[0].colors[0], kRed);
  EXPECT_EQ(read.paint.triangles[1].colors[0], kBlue);
  EXPECT_THAT(read.notes, IsEmpty());
}

TEST(ReadPaint, FindsPicturesNamedByPathsOfOtherMachines) {
  const PaintRead read = paint_of("mtllib m.mtl\n" + kTriangle + "usemtl a\nf 1/1 2/2 3/3\n",
                                  {{"m.mtl", "newmtl a\nmap_Kd D:\\art\\skin.png\n"}, {"skin.png", kPicture}});
  ASSERT_EQ(read.paint.pictures.size(), 1U);
  EXPECT_EQ(read.paint.color_at(0, Vec3(0.9, 0.05, 0.05)), kRed);
  EXPECT_EQ(read.paint.color_at(0, Vec3(0.05, 0.9, 0.05)), kBlue);
}

TEST(ReadPaint, TellsWhatIsMissingOrDamagedAndGoesOn) {
  const std::string obj = "mtllib m.mtl\n" + kTriangle + "usemtl a\nf 1/1 2/2 3/3\n";
  EXPECT_THAT(paint_of(obj, {}).notes, ElementsAre(HasSubstr("there is no m.mtl")));
  const std::string mtl = "newmtl a\nKd 1 0 0\nmap_Kd skin.png\n";
  EXPECT_THAT(paint_of(obj, {{"m.mtl", mtl}}).notes, ElementsAre(HasSubstr("skin.png is left out")));
  const PaintRead damaged = paint_of(obj, {{"m.mtl", mtl}, {"skin.png", kPicture.substr(0, 50)}});
  EXPECT_THAT(damaged.notes, ElementsAre(HasSubstr("cannot be read")));
  EXPECT_EQ(damaged.paint.triangles.at(0).colors[0], kRed);
  EXPECT_THAT(paint_of(obj, {{"m.mtl", "newmtl a\nKd red\n"}}).notes, ElementsAre(HasSubstr("colours are left out")));
}

TEST(ReadPaint, OneGreyIsNoColour) {
  const std::string obj = "mtllib m.mtl\n" + kTriangle + "usemtl a\nf 1 2 3\n";
  EXPECT_TRUE(paint_of(obj, {{"m.mtl", "newmtl a\nKd 0.8 0.8 0.8\n"}}).paint.empty());
  EXPECT_FALSE(paint_of(obj, {{"m.mtl", "newmtl a\nKd 0.8 0 0\n"}}).paint.empty());
  EXPECT_TRUE(paint_of(kTriangle + "f 1 2 3\n", {}).paint.empty());
}

TEST(ReadPaint, TakesTheColoursOfVertices) {
  const PaintRead read = paint_of("v 0 0 0 1 0 0\nv 1 0 0 0 0 1\nv 0 1 0 1 0 0\nf 1 2 3\n", {});
  EXPECT_EQ(read.paint.triangles.at(0).colors[0], kRed);
  EXPECT_EQ(read.paint.triangles.at(0).colors[1], kBlue);
}

TEST(ReadPaint, FacesOfOffAndVerticesOfPlyHaveColours) {
  const MeshSource off = read_mesh_source("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1 255 0 0\n", "a.off");
  const PaintRead faces = read_paint(off, no_files);
  ASSERT_EQ(faces.paint.triangles.size(), 2U);
  EXPECT_EQ(faces.paint.triangles[0].colors[0], kWhite);
  EXPECT_EQ(faces.paint.triangles[1].colors[2], kRed);
  const MeshSource ply = read_mesh_source(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 0 0 255\n0 1 0 255 0 0\n3 0 1 2\n",
      "a.ply");
  const PaintRead vertices = read_paint(ply, no_files);
  ASSERT_EQ(vertices.paint.triangles.size(), 1U);
  EXPECT_EQ(vertices.paint.triangles[0].colors[1], kBlue);
}

TEST(ReadPaint, ReadsColoursAndPicturesOfGltf) {
  std::string numbers;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1}) append_number(numbers, x);
  const std::string document =
      R"({"buffers":[{"byteLength":60,"uri":"data:;base64,)" + base64(numbers) +
      R"("}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],
      "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                   {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
      "images":[{"uri":"data:image/png;base64,)" +
      base64(kPicture) + R"("}],"textures":[{"source":0}],
      "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},
                   {"pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]}}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0},
                               {"attributes":{"POSITION":0},"material":1}]}]})";
  const MeshSource source = read_gltf(document);
  const PaintRead read = read_paint(source, no_files);
  ASSERT_EQ(read.paint.triangles.size(), 2U);
  EXPECT_EQ(read.paint.color_at(0, Vec3(0.9, 0.05, 0.05)), kRed);
  EXPECT_EQ(read.paint.color_at(0, Vec3(0.05, 0.9, 0.05)), kBlue);
  EXPECT_EQ(read.paint.color_at(1, Vec3(0.9, 0.05, 0.05)), kBlue);
}

}  // namespace
}  // namespace plico
