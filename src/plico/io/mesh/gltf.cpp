#include "plico/io/mesh/gltf.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
#include "plico/io/mesh/point_welder.h"
#include "plico/io/text/base64.h"
#include "plico/io/text/bytes.h"
#include "plico/io/text/parse_json.h"

namespace plico {
namespace {

using nlohmann::json;

constexpr std::uint32_t kGlbMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr int kTriangles = 4, kStrip = 5, kFan = 6;  // modes of a primitive
constexpr int kDeepestNode = 200;

// Bytes of a buffer, and where in the file they start (0 where they are not there as they are).
struct Buffer {
  std::string_view bytes;
  std::size_t start = 0;
};

// Numbers in a buffer, in rows of equal length.
struct Accessor {
  Buffer buffer;
  std::size_t first = 0, stride = 0;
  int count = 0, component_type = 0;
  bool normalized = false;
};

std::size_t size_of_component(int type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

// The looks of the vertices of a primitive; numbers that are none where it says nothing.
struct VertexLooks {
  std::vector<Vec2> uv;
  std::vector<Color> colors;
  int material = -1;
};

class GltfReader {
 public:
  GltfReader(const json& document, std::optional<Buffer> chunk, const std::string& name)
      : document_(document), chunk_(chunk) {
    source_.name = name;
    source_.binary = true;
  }

  MeshSource read() {
    refuse_unknown_extensions();
    decode_data_uris();
    for (const json& material : array("materials")) source_.looks.materials.push_back(look_of(material));
    seen_.assign(array("nodes").size(), 0);
    if (array("nodes").empty())
      for (std::size_t m = 0; m < array("meshes").size(); ++m)
        add_mesh(static_cast<int>(m), Eigen::Affine3d::Identity());
    for (const int node : roots()) visit(node, Eigen::Affine3d::Identity(), 0);
    if (!has_uv_) source_.looks.uv.clear();
    if (!has_colors_) source_.looks.colors.clear();
    return std::move(source_);
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& suggestion = "") const {
    throw InvalidInput("read/gltf", message, source_.name, suggestion);
  }

  const json& array(const char* key) const {
    static const json none = json::array();
    const auto at = document_.find(key);
    return at == document_.end() ? none : *at;
  }

  const json& element(const char* key, int index) const {
    const json& all = array(key);
    if (!all.is_array() || index < 0 || static_cast<std::size_t>(index) >= all.size())
      fail(fmt::format("{} {} is used, the file has {}", key, index, all.size()));
    return all[static_cast<std::size_t>(index)];
  }

  // Those about looks change no triangle.
  void refuse_unknown_extensions() const {
    for (const json& word : array("extensionsRequired")) {
      const auto extension = word.get<std::string>();
      if (extension.starts_with("KHR_materials") || extension.starts_with("KHR_texture") ||
          extension == "KHR_mesh_quantization" || extension == "EXT_texture_webp")
        continue;
      fail(fmt::format("the file needs the extension {}, which is not read here", extension),
           "export it again without compression");
    }
  }

  void decode_data_uris() {
    for (const json& buffer : array("buffers")) {
      decoded_.emplace_back();
      const std::string uri = buffer.value("uri", "");
      if (uri.empty()) continue;
      const auto comma = uri.find(',');
      if (!uri.starts_with("data:") || comma == std::string::npos)
        fail(fmt::format("its numbers are in another file, '{}'", uri.substr(0, 60)),
             "save it as one binary file, .glb");
      std::optional<std::string> bytes = decoded_base64(std::string_view(uri).substr(comma + 1));
      if (!bytes) fail("a data URI of the file is not base64");
      decoded_.back() = std::move(*bytes);
    }
  }

  std::vector<int> roots() const {
    if (!array("scenes").empty())
      return element("scenes", document_.value("scene", 0)).value("nodes", std::vector<int>{});
    std::vector<char> is_child(array("nodes").size(), 0);
    for (const json& node : array("nodes"))
      for (const int child : node.value("children", std::vector<int>{}))
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
          is_child[static_cast<std::size_t>(child)] = 1;
    std::vector<int> result;
    for (std::size_t n = 0; n < is_child.size(); ++n)
      if (!is_child[n]) result.push_back(static_cast<int>(n));
    return result;
  }

  void visit(int index, const Eigen::Affine3d& above, int depth) {
    const json& node = element("nodes", index);
    if (seen_[static_cast<std::size_t>(index)]++) fail(fmt::format("node {} stands in two places", index));
    if (depth > kDeepestNode) fail(fmt::format("nodes stand more than {} deep in each other", kDeepestNode));
    const Eigen::Affine3d here = above * transform(node);
    if (node.contains("mesh")) add_mesh(node["mesh"].get<int>(), here);
    for (const int child : node.value("children", std::vector<int>{})) visit(child, here, depth + 1);
  }

  std::vector<double> numbers(const json& node, const char* key, const std::vector<double>& otherwise) const {
    auto values = node.value(key, otherwise);
    if (values.size() != otherwise.size())
      fail(fmt::format("{} of a node has {} numbers, must have {}", key, values.size(), otherwise.size()));
    return values;
  }

  Eigen::Affine3d transform(const json& node) const {
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    if (node.contains("matrix")) {
      const std::vector<double> m = numbers(node, "matrix", std::vector<double>(16, 0));
      for (std::size_t i = 0; i < 16; ++i) result.matrix()(static_cast<int>(i % 4), static_cast<int>(i / 4)) = m[i];
      return result;
    }
    const std::vector<double> t = numbers(node, "translation", {0, 0, 0}), r = numbers(node, "rotation", {0, 0, 0, 1}),
                              s = numbers(node, "scale", {1, 1, 1});
    Eigen::Quaterniond turn(r[3], r[0], r[1], r[2]);
    if (!(turn.norm() > 0)) fail("the rotation of a node is zero");
    turn.normalize();
    result.linear() = turn.toRotationMatrix() * Eigen::Vector3d(s[0], s[1], s[2]).asDiagonal();
    result.translation() = Vec3(t[0], t[1], t[2]);
    return result;
  }

  void add_mesh(int index, const Eigen::Affine3d& here) {
    PointWelder welder(source_, 0);
    for (const json& primitive : element("meshes", index).value("primitives", json::array()))
      add_primitive(primitive, here, welder);
  }

  void add_primitive(const json& primitive, const Eigen::Affine3d& here, PointWelder& welder) {
    const int mode = primitive.value("mode", kTriangles);
    if (mode < kTriangles || mode > kFan) return;  // points and lines
    const json attributes = primitive.value("attributes", json::object());
    if (!attributes.contains("POSITION")) return;
    const Accessor positions = accessor(attributes["POSITION"].get<int>(), "VEC3", 3);
    if (source_.soup.points.size() + static_cast<std::size_t>(positions.count) > kMaxElements)
      fail(fmt::format("it has more than {} vertices", kMaxElements));
    const VertexLooks looks = vertex_looks(primitive, attributes, positions.count);
    std::vector<int> number;
    for (int i = 0; i < positions.count; ++i)
      number.push_back(welder.number_of(here * point(positions, i), place(positions, i)));
    add_triangles(primitive, mode, number, looks, here.linear().determinant() < 0);
  }

  void add_triangles(const json& primitive, int mode, const std::vector<int>& number, const VertexLooks& looks,
                     bool mirrored) {
    std::optional<Accessor> indices;
    if (primitive.contains("indices")) indices = accessor(primitive["indices"].get<int>(), "SCALAR", 1);
    const int count = indices ? indices->count : static_cast<int>(number.size());
    const auto corner = [&](int i) {
      const double index = indices ? component(*indices, i, 0) : i;
      if (!(index >= 0 && index < static_cast<double>(number.size())) || index != std::floor(index))
        fail(fmt::format("a triangle uses vertex {}, there are {}", index, number.size()));
      return static_cast<int>(index);
    };
    for (int t = 0; mode == kTriangles ? 3 * t + 2 < count : t + 2 < count; ++t) {
      const int first = mode == kTriangles ? 3 * t : mode == kStrip ? t : 0;
      const int second = mode == kFan ? t + 1 : first + 1;
      std::array<int, 3> face{corner(first), corner(second), corner(second + 1)};
      if (mirrored != (mode == kStrip && t % 2 == 1)) std::swap(face[1], face[2]);
      for (const int vertex : face) {
        source_.looks.uv.push_back(looks.uv[vertex]);
        source_.looks.colors.push_back(looks.colors[vertex]);
      }
      source_.looks.material.push_back(looks.material);
      source_.soup.add_face(std::array{number[face[0]], number[face[1]], number[face[2]]});
      source_.face_place.push_back(indices ? place(*indices, first) : 0);
    }
  }

  // Colours of glTF are linear light, pictures are not.
  Material look_of(const json& material) const {
    Material result{.name = material.value("name", "")};
    const json surface = material.value("pbrMetallicRoughness", json::object());
    const auto factor = surface.value("baseColorFactor", std::vector<double>{1, 1, 1, 1});
    if (factor.size() >= 3) result.color = from_linear({factor[0], factor[1], factor[2]});
    result.tints = true;
    const json texture = surface.value("baseColorTexture", json::object());
    if (texture.contains("index")) take_picture(element("textures", texture["index"].get<int>()), result);
    return result;
  }

  void take_picture(const json& texture, Material& material) const {
    if (!texture.contains("source")) return;  // only in a format that is not read here
    const json& image = element("images", texture["source"].get<int>());
    // The number keeps pictures apart that have no name.
    const std::string label = fmt::format("{} {}", image.value("name", "image"), texture["source"].get<int>());
    // v counts downwards in glTF.
    material.scale = Vec2(1, -1);
    material.offset = Vec2(0, 1);
    if (image.contains("bufferView")) {
      material.picture = label;
      material.picture_bytes = view_bytes(image["bufferView"].get<int>());
      return;
    }
    const std::string uri = image.value("uri", "");
    material.picture = uri.starts_with("data:") ? label : uri;
    if (!uri.starts_with("data:")) return;
    const auto comma = uri.find(',');
    if (comma != std::string::npos)
      material.picture_bytes = decoded_base64(std::string_view(uri).substr(comma + 1)).value_or("");
  }

  std::string view_bytes(int index) const {
    const json& view = element("bufferViews", index);
    const Buffer whole = buffer(view.value("buffer", 0));
    const std::size_t first = offset(view, "byteOffset"), length = offset(view, "byteLength");
    if (first > whole.bytes.size() || length > whole.bytes.size() - first)
      fail(fmt::format("bufferView {} reaches beyond its buffer", index));
    return std::string(whole.bytes.substr(first, length));
  }

  VertexLooks vertex_looks(const json& primitive, const json& attributes, int count) {
    VertexLooks looks{std::vector<Vec2>(count, kNoUv), std::vector<Color>(count, kWhite),
                      primitive.value("material", -1)};
    if (looks.material >= static_cast<int>(source_.looks.materials.size())) looks.material = -1;
    if (attributes.contains("TEXCOORD_0")) {
      const Accessor from = accessor(attributes["TEXCOORD_0"].get<int>(), "VEC2", 2);
      for (int i = 0; i < std::min(count, from.count); ++i)
        looks.uv[i] = {component(from, i, 0), component(from, i, 1)};
      has_uv_ = true;
    }
    if (attributes.contains("COLOR_0")) {
      const int number = attributes["COLOR_0"].get<int>();
      const bool has_alpha = element("accessors", number).value("type", "") == "VEC4";
      const Accessor from = accessor(number, has_alpha ? "VEC4" : "VEC3", has_alpha ? 4 : 3);
      for (int i = 0; i < std::min(count, from.count); ++i)
        looks.colors[i] = from_linear({component(from, i, 0), component(from, i, 1), component(from, i, 2)});
      has_colors_ = true;
    }
    return looks;
  }

  Buffer buffer(int index) const {
    element("buffers", index);
    const std::string& decoded = decoded_[static_cast<std::size_t>(index)];
    if (!decoded.empty()) return {decoded, 0};
    if (index > 0 || !chunk_) fail(fmt::format("buffer {} is not in the file", index));
    return *chunk_;
  }

  Accessor accessor(int index, const std::string& type, std::size_t components) const {
    const json& about = element("accessors", index);
    if (about.contains("sparse") || !about.contains("bufferView"))
      fail(fmt::format("accessor {} is sparse or empty, which is not read here", index));
    if (about.value("type", "") != type) fail(fmt::format("accessor {} is not {}", index, type));
    const json& view = element("bufferViews", about["bufferView"].get<int>());
    Accessor result;
    result.component_type = about.value("componentType", 0);
    const std::size_t row = components * size_of_component(result.component_type);
    if (row == 0) fail(fmt::format("accessor {} has components of an unknown type", index));
    result.buffer = buffer(view.value("buffer", 0));
    result.first = offset(view, "byteOffset") + offset(about, "byteOffset");
    result.stride = std::max(offset(view, "byteStride"), row);
    result.count = static_cast<int>(offset(about, "count"));
    result.normalized = about.value("normalized", false);
    const std::size_t size = result.buffer.bytes.size(),
                      steps = static_cast<std::size_t>(std::max(result.count, 1)) - 1;
    if (result.first > size || steps * result.stride + row > size - result.first)
      fail(fmt::format("accessor {} reaches beyond its buffer", index));
    return result;
  }

  // Whole numbers below 2^31, so that sums and products of two stay in 64 bits.
  std::size_t offset(const json& about, const char* key) const {
    const double value = about.value(key, 0.0);
    if (!(value >= 0 && value <= std::numeric_limits<int>::max()) || value != std::floor(value))
      fail(fmt::format("{} is {}, must be a whole number", key, value));
    return static_cast<std::size_t>(value);
  }

  double component(const Accessor& from, int row, std::size_t which) const {
    const std::size_t at =
        from.first + static_cast<std::size_t>(row) * from.stride + which * size_of_component(from.component_type);
    const auto scaled = [&](double value, double most) {
      return from.normalized ? std::max(value / most, -1.0) : value;
    };
    const std::string_view bytes = from.buffer.bytes;
    switch (from.component_type) {
      case 5120:
        return scaled(load_number<std::int8_t>(bytes, at), 127);
      case 5121:
        return scaled(load_number<std::uint8_t>(bytes, at), 255);
      case 5122:
        return scaled(load_number<std::int16_t>(bytes, at), 32767);
      case 5123:
        return scaled(load_number<std::uint16_t>(bytes, at), 65535);
      case 5125:
        return load_number<std::uint32_t>(bytes, at);
      default:
        return load_number<float>(bytes, at);
    }
  }

  Vec3 point(const Accessor& positions, int i) const {
    return {component(positions, i, 0), component(positions, i, 1), component(positions, i, 2)};
  }

  int place(const Accessor& from, int row) const {
    return static_cast<int>(from.buffer.start + from.first + static_cast<std::size_t>(row) * from.stride);
  }

  const json& document_;
  std::optional<Buffer> chunk_;  // of a binary file: its buffer 0
  std::vector<std::string> decoded_;
  std::vector<int> seen_;
  bool has_uv_ = false, has_colors_ = false;
  MeshSource source_;
};

// The text and the buffer of a binary file.
std::pair<std::string_view, std::optional<Buffer>> glb_chunks(std::string_view bytes, const std::string& name) {
  std::string_view text;
  std::optional<Buffer> binary;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t length = load_number<std::uint32_t>(bytes, at);
    const auto kind = load_number<std::uint32_t>(bytes, at + 4);
    if (length > bytes.size() - at - 8)
      throw InvalidInput("read/truncated", "the file ends too early", fmt::format("{}: byte {}", name, at));
    if (kind == kJsonChunk && text.empty()) text = bytes.substr(at + 8, length);
    if (kind == kBinaryChunk && !binary) binary = Buffer{bytes.substr(at + 8, length), at + 8};
    at += 8 + (length + 3) / 4 * 4;
  }
  return {text, binary};
}

}  // namespace

bool is_glb(std::string_view bytes) { return bytes.size() >= 12 && load_number<std::uint32_t>(bytes, 0) == kGlbMagic; }

MeshSource read_gltf(std::string_view bytes, const std::string& name) {
  std::string_view text = bytes;
  std::optional<Buffer> binary;
  if (is_glb(bytes)) std::tie(text, binary) = glb_chunks(bytes, name);
  const json document = parse_json(text, name, "gltf");
  try {
    return GltfReader(document, binary, name).read();
  } catch (const json::exception&) {
    throw InvalidInput("read/gltf", "a value of the glTF is not of the kind it must be", name);
  }
}

}  // namespace plico
