#include "plico/io/mesh/gltf.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/bytes.h"

namespace plico {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

void append_chunk(std::string& file, std::uint32_t kind, std::string bytes, char filler) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filler);
  append_number(file, static_cast<std::uint32_t>(bytes.size()));
  append_number(file, kind);
  file += bytes;
}

std::string glb(const std::string& text, const std::string& binary) {
  std::string chunks;
  append_chunk(chunks, 0x4e4f534a, text, ' ');
  append_chunk(chunks, 0x004e4942, binary, '\0');
  std::string file = "glTF";
  append_number(file, std::uint32_t{2});
  append_number(file, static_cast<std::uint32_t>(12 + chunks.size()));
  return file + chunks;
}

// The corners of a unit square's two triangles, or of a strip of them.
std::string floats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers) append_number(bytes, number);
  return bytes;
}
const std::string kSquare = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
const std::string kStrip = floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});

std::string document(int count, const std::string& primitive = "", const std::string& node = "",
                     const std::string& more = "") {
  return R"({"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0)" + node +
         R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0})" + primitive +
         R"(}]}], "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": )" +
         std::to_string(count) + R"(}], "bufferViews": [{"buffer": 0}], "buffers": [{}])" + more + "}";
}

std::string gltf_failure(const std::string& bytes) {
  try {
    read_gltf(bytes, "a.glb");
  } catch (const InvalidInput& error) {
    return error.code() + ": " + error.what() + " > " + error.suggestion();
  }
  return "no error";
}

TEST(ReadGltf, CornersAtOnePlaceAreOnePointWhereTheNodePutsThem) {
  const MeshSource source =
      read_mesh_source(glb(document(6, "", R"(, "translation": [0, 0, 5])"), kSquare), "no extension");
  EXPECT_EQ(source.soup.num_points(), 4);
  EXPECT_THAT(source.soup.corners, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_EQ(source.soup.points[2], Vec3(1, 1, 5));
}

TEST(ReadGltf, AMirroredNodeKeepsTheOutsideOutside) {
  const PolygonSoup soup = read_gltf(glb(document(4, R"(, "mode": 5)", R"(, "scale": [-1, 1, 1])"), kStrip)).soup;
  EXPECT_THAT(soup.corners, ElementsAre(0, 2, 1, 1, 2, 3));  // a strip turns every second triangle, the mirror all
  EXPECT_EQ(soup.points[1], Vec3(-1, 0, 0));
}

TEST(ReadGltf, BuffersInTheTextAreBase64) {
  std::string text = document(3);
  text.replace(text.find("[{}]"), 4, R"([{"uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])");
  const PolygonSoup soup = read_mesh_source(text, "a.gltf").soup;
  EXPECT_THAT(soup.points, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
}

TEST(ReadGltf, ErrorsSayWhatIsWrong) {
  EXPECT_THAT(gltf_failure(glb(document(7), kSquare)), HasSubstr("accessor 0 reaches beyond its buffer"));
  EXPECT_THAT(gltf_failure(glb(document(6, "", R"(, "children": [0])"), kSquare)), HasSubstr("stands in two places"));
  EXPECT_THAT(
      gltf_failure(glb(document(6, "", "", R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"), kSquare)),
      HasSubstr("the file needs the extension KHR_draco_mesh_compression, which is not read here > export it"));
  std::string other = document(6);
  other.replace(other.find("[{}]"), 4, R"([{"uri": "a.bin"}])");
  EXPECT_THAT(gltf_failure(other),
              HasSubstr("its numbers are in another file, 'a.bin' > save it as one binary file, .glb"));
  EXPECT_THAT(gltf_failure(R"({"nodes": [3]})"), HasSubstr("read/gltf"));
  EXPECT_THAT(gltf_failure(glb(document(6), kSquare).substr(0, 40)), HasSubstr("read/truncated"));
}

}  // namespace
}  // namespace plico
