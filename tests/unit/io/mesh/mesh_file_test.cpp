#include "plico/io/mesh/mesh_file.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/io/mesh/obj.h"
#include "plico/io/mesh/off.h"
#include "plico/io/mesh/ply.h"
#include "plico/io/mesh/stl.h"

namespace plico {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The message and place of the error that reading `bytes` as the file `name` ends in.
std::string failure(std::string_view bytes, const std::string& name) {
  try {
    read_mesh_source(bytes, name);
  } catch (const InvalidInput& error) {
    return error.code() + ": " + error.what() + " @ " + error.where() + " > " + error.suggestion();
  }
  return "no error";
}

std::vector<int> corners(const MeshSource& source) { return source.soup.corners; }

TEST(ReadObj, PassesOverEverythingButVerticesAndFaces) {
  const MeshSource source = read_obj(
      "# comment\nmtllib a.mtl\nv 0 0 0 # first\nv +1 0 0 0.5 0.5 0.5\nv 1e0 1.0 0\nv -0. 1 0\nvn 0 0 1\nvt 0 0\n"
      "g group\nusemtl m\ns off\nf 1/1/1 2//1 3/1 4\nl 1 2\n");
  EXPECT_EQ(source.soup.num_points(), 4);
  EXPECT_EQ(source.soup.points[1], Vec3(1, 0, 0));
  EXPECT_THAT(corners(source), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(source.face_place, ElementsAre(12));
  EXPECT_THAT(source.point_place, ElementsAre(3, 4, 5, 6));
}

TEST(ReadObj, NegativeIndicesCountFromTheLastVertexSoFar) {
  EXPECT_THAT(corners(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -2 -1\n")),
              ElementsAre(0, 1, 2, 0, 2, 3));
}

TEST(ReadObj, JoinsLinesAndTakesEveryLineEnd) {
  EXPECT_THAT(corners(read_obj("v 0 0 0\r\nv 1 0 \\\r\n0\r\nv 0 1 0\r\nf 1 \\\r\n 2\\\r\n 3\r\n")),
              ElementsAre(0, 1, 2));
  EXPECT_THAT(corners(read_obj("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3")), ElementsAre(0, 1, 2));
  EXPECT_EQ(read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\ng a \\\nf 3 3 3\nf 1 2 3").soup.num_faces(), 1);
}

TEST(ReadObj, ErrorsSayTheLine) {
  EXPECT_THAT(failure("v 0 0\n", "a.obj"), HasSubstr("read/syntax: a vertex needs three coordinates @ a.obj:1"));
  EXPECT_THAT(failure("v 0 0 zero\n", "a.obj"), HasSubstr("a coordinate is 'zero', must be a number"));
  EXPECT_THAT(failure("v 0 0 0\nf 1 2 3\n", "a.obj"),
              HasSubstr("read/index: face 0 uses vertex 2, the file has 1 vertices @ a.obj:2"));
  EXPECT_THAT(failure("v 0 0 0\nf 1 1 0\n", "a.obj"), HasSubstr("read/index: face 0 uses vertex 0"));
  EXPECT_THAT(failure("v 0 0 0\n\nf -1 -2 -1\n", "a.obj"), HasSubstr("a.obj:3"));
  EXPECT_THAT(failure("v 1e999 0 0\n", "a.obj"), HasSubstr("'1e999', must be a number that fits a double"));
}

TEST(ReadOff, TakesCommentsColoursAndFreeLayout) {
  const MeshSource source =
      read_off("OFF # cube's corner\n4 2 0\n0 0 0  1 0 0\n0 1 0\n# between\n0 0 1\n3 0 1 2 255 0 0\n3 0 2 3\n");
  EXPECT_EQ(source.soup.num_points(), 4);
  EXPECT_THAT(corners(source), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(source.face_place, ElementsAre(7, 8));
  EXPECT_EQ(read_off("3 1 0\n0 0 0 1 0 0 0 1 0 3 0 1 2").soup.num_faces(), 1);
  EXPECT_EQ(read_off("COFF\n3 1\n0 0 0 9 9 9 1\n1 0 0 9 9 9 1\n0 1 0 9 9 9 1\n3 0 1 2").soup.num_points(), 3);
}

TEST(ReadOff, CountsMayBeGluedToTheKeywordAndRemarkedOn) {
  const std::string body = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const PolygonSoup plain = read_mesh("OFF\n3 1 3" + body, MeshFormat::Off);
  EXPECT_EQ(plain.num_faces(), 1);
  for (const char* header : {"OFF3 1 3", "OFF 3 1 3 written by a program", "OFF3 1 3 0.5"}) {
    const PolygonSoup soup = read_mesh(header + body, MeshFormat::Off);
    EXPECT_EQ(soup.points, plain.points) << header;
    EXPECT_EQ(soup.corners, plain.corners) << header;
    EXPECT_EQ(sniff_mesh_format(header + body), MeshFormat::Off) << header;
  }
}

TEST(ReadOff, ErrorsSayTheLine) {
  EXPECT_THAT(failure("OFF\n3 1 0\n0 0 0\n1 0 0\n", "a.off"),
              HasSubstr("read/truncated: the file ends after 2 of 3 vertices"));
  EXPECT_THAT(failure("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off"), HasSubstr("after 1 of 2 faces"));
  EXPECT_THAT(failure("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", "a.off"), HasSubstr("read/counts"));
  EXPECT_THAT(failure("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off"),
              HasSubstr("face 0 uses vertex 3, must be in [0, 2] @ a.off:6"));
  EXPECT_THAT(failure("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off"), HasSubstr("uses vertex -1"));
  EXPECT_THAT(failure("OFF\n3 2000000000 0\n", "a.off"), HasSubstr("read/limit"));
  EXPECT_THAT(failure("4OFF\n3 2 0\n", "a.off"), HasSubstr("no OFF file in three dimensions"));
}

const char* kStl =
    "solid a # b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "FACET NORMAL nan 0 1\nOUTER LOOP\nVERTEX -0 0 0\nVERTEX 0 1 0\nVERTEX -1 0 0\nENDLOOP\nENDFACET\nendsolid a\n";

TEST(ReadStl, WeldsEqualCorners) {
  const MeshSource source = read_stl(kStl);
  EXPECT_EQ(source.soup.num_points(), 4);
  EXPECT_THAT(corners(source), ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(source.face_place, ElementsAre(2, 9));
  const MeshSource binary = read_stl(write_stl(source.soup));
  EXPECT_TRUE(binary.binary);
  EXPECT_EQ(binary.soup.corners, source.soup.corners);
  EXPECT_EQ(binary.soup.points, source.soup.points);
  EXPECT_THAT(binary.face_place, ElementsAre(84, 134));
}

TEST(ReadStl, SeveralSolidsAreOneFileWithOneListOfPoints) {
  const MeshSource source = read_stl(std::string(kStl) + kStl);
  EXPECT_EQ(source.soup.num_faces(), 4);
  EXPECT_EQ(source.soup.num_points(), 4);
}

TEST(ReadStl, BinaryThatStartsWithSolidIsBinary) {
  std::string bytes = write_stl(read_stl(kStl).soup);
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read_stl(bytes).soup.num_faces(), 2);
}

TEST(ReadStl, ErrorsSayLineOrByte) {
  const std::string bytes = write_stl(read_stl(kStl).soup);
  EXPECT_THAT(failure(bytes.substr(0, 100), "a.stl"),
              HasSubstr("read/truncated: 2 triangles need 184 bytes, the file has 100 @ a.stl: byte 80"));
  EXPECT_THAT(failure(bytes + "x", "a.stl"), HasSubstr("read/counts"));
  EXPECT_THAT(failure("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0", "a.stl"), HasSubstr("read/truncated"));
  EXPECT_THAT(failure("solid a\nfacet normal 0 0 1\nouter hoop\n", "a.stl"),
              HasSubstr("'hoop' stands where an STL file has loop @ a.stl:3"));
  EXPECT_THROW(write_stl(read_obj("v 1e300 0 0\nv 0 0 0\nv 1 1 1\nf 1 2 3\n").soup), InvalidInput);
}

TEST(ReadPly, PassesOverOtherElementsAndProperties) {
  const MeshSource source = read_ply(
      "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nelement material 1\r\nproperty list uchar int ids\r\n"
      "element vertex 3\r\nproperty uchar red\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
      "element face 1\r\nproperty uchar flags\r\nproperty list uchar uint vertex_index\r\nend_header\r\n"
      "2 7 7\r\n255 0 0 0\r\n255 1 0 0\r\n255 0 1 0\r\n9 3 0 1 2\r\n");
  EXPECT_EQ(source.soup.points[1], Vec3(1, 0, 0));
  EXPECT_THAT(corners(source), ElementsAre(0, 1, 2));
  EXPECT_THAT(source.face_place, ElementsAre(19));
}

TEST(ReadPly, ListsOfAnyTypeMayStandAnywhereAndFacesFirst) {
  const MeshSource source = read_ply(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar float texcoord\nproperty list ushort short "
      "vertex_index\n"
      "property uchar red\nproperty list int double weights\nelement vertex 3\nproperty double z\nproperty float x\n"
      "property int y\nend_header\n4 0 0 1 1 3 0 1 2 9 1 0.5\n0 0 0\n0 1 0\n0 0 1\n");
  EXPECT_EQ(source.soup.points[2], Vec3(0, 1, 0));
  EXPECT_THAT(corners(source), ElementsAre(0, 1, 2));
}

TEST(ReadPly, ErrorsSayLineOrByte) {
  const PolygonSoup soup = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").soup;
  for (PlyEncoding encoding : {PlyEncoding::Text, PlyEncoding::LittleEndian, PlyEncoding::BigEndian}) {
    const std::string bytes = write_ply(soup, encoding);
    EXPECT_THAT(failure(bytes.substr(0, bytes.size() - 4), "a.ply"), HasSubstr("read/truncated"));
    EXPECT_THAT(failure(bytes + "1", "a.ply"), HasSubstr("read/counts"));
  }
  EXPECT_THAT(failure("ply\nformat ascii 1.0\nelement face 2000000000\n", "a.ply"), HasSubstr("read/limit"));
  EXPECT_THAT(failure("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n", "a.ply"),
              HasSubstr("no x, y and z"));
  EXPECT_THAT(failure("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "a.ply"),
              HasSubstr("'quad' is no PLY type @ a.ply:4"));
}

TEST(MeshFile, FormatByExtensionThenByContents) {
  const PolygonSoup soup = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").soup;
  for (MeshFormat format : {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Stl, MeshFormat::Ply}) {
    const std::string bytes = write_mesh(soup, format);
    EXPECT_EQ(sniff_mesh_format(bytes), format);
    EXPECT_EQ(read_mesh_source(bytes, "-").soup.corners, soup.corners);
  }
  EXPECT_EQ(mesh_format_of("A.B/C.OBJ"), MeshFormat::Obj);
  EXPECT_EQ(mesh_format_of("obj"), std::nullopt);
}

TEST(MeshFile, AWronglyNamedFileIsRecognized) {
  const PolygonSoup soup = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").soup;
  EXPECT_THAT(failure(write_stl(soup), "a.obj"),
              HasSubstr("binary file read as text @ a.obj: byte 81 > rename the file: it looks like STL"));
  EXPECT_THAT(failure(write_ply(soup), "a.off"), HasSubstr("it looks like PLY"));
  EXPECT_THAT(failure(" \n", "a.obj"), HasSubstr("read/empty: a.obj is empty"));
  EXPECT_THAT(failure("hello world", "-"), HasSubstr("read/format"));
}

}  // namespace
}  // namespace plico
