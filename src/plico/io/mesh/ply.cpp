#include "plico/io/mesh/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plico/base/error.h"
#include "plico/io/text/bytes.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

enum class Scalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

constexpr std::array<std::pair<std::string_view, Scalar>, 16> kScalarNames = {{{"char", Scalar::Int8},
                                                                               {"int8", Scalar::Int8},
                                                                               {"uchar", Scalar::Uint8},
                                                                               {"uint8", Scalar::Uint8},
                                                                               {"short", Scalar::Int16},
                                                                               {"int16", Scalar::Int16},
                                                                               {"ushort", Scalar::Uint16},
                                                                               {"uint16", Scalar::Uint16},
                                                                               {"int", Scalar::Int32},
                                                                               {"int32", Scalar::Int32},
                                                                               {"uint", Scalar::Uint32},
                                                                               {"uint32", Scalar::Uint32},
                                                                               {"float", Scalar::Float32},
                                                                               {"float32", Scalar::Float32},
                                                                               {"double", Scalar::Float64},
                                                                               {"float64", Scalar::Float64}}};

struct Property {
  std::string name;
  bool is_list = false;
  Scalar count_type = Scalar::Uint8, type = Scalar::Float32;
};

struct Element {
  std::string name;
  int count = 0;
  std::vector<Property> properties;

  int find(std::string_view wanted) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (properties[i].name == wanted) return static_cast<int>(i);
    return -1;
  }
};

struct Header {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<Element> elements;
  std::string picture;   // of the comment TextureFile, which scanners write
  std::size_t size = 0;  // bytes
  int lines = 0;
};

// What one counts in a file of colours: bytes, 16 bits, or in [0, 1].
double color_scale(Scalar type) { return type == Scalar::Uint8 ? 255 : type == Scalar::Uint16 ? 65535 : 1; }

// Where an element has the first of these names that it has; -1 for none.
int find_any(const Element& element, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    if (const int at = element.find(name); at >= 0 && !element.properties[static_cast<std::size_t>(at)].is_list)
      return at;
  return -1;
}

// The properties with a colour, or with (u, v); all -1 when one is missing.
std::array<int, 3> color_of(const Element& element) {
  const std::array<int, 3> rgb{find_any(element, {"red", "r", "diffuse_red"}),
                               find_any(element, {"green", "g", "diffuse_green"}),
                               find_any(element, {"blue", "b", "diffuse_blue"})};
  return std::ranges::min(rgb) < 0 ? std::array{-1, -1, -1} : rgb;
}

std::array<int, 2> uv_of(const Element& element) {
  const std::array<int, 2> uv{find_any(element, {"s", "u", "texture_u"}), find_any(element, {"t", "v", "texture_v"})};
  return std::ranges::min(uv) < 0 ? std::array{-1, -1} : uv;
}

// The header alone is text even in a binary file, so it is scanned apart.
class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& name) : scan_(text, name) {}

  Header read() {
    if (scan_.word() != "ply") scan_.fail("read/format", "a PLY file starts with the line 'ply'");
    bool has_format = false;
    for (std::string_view word = scan_.word(); word != "end_header"; word = scan_.word()) {
      if (word == "format") {
        read_format();
        has_format = true;
      } else if (word == "element") {
        read_element();
      } else if (word == "property") {
        read_property();
      } else if (word == "comment") {
        read_comment();
      } else if (word != "obj_info") {
        scan_.fail("read/syntax", fmt::format("{} is no line of a PLY header", quoted_word(word)));
      }
      scan_.skip_line();
    }
    if (!has_format) scan_.fail("read/syntax", "the PLY header has no format line");
    scan_.skip_line();
    header_.size = scan_.position();
    header_.lines = scan_.line() - 1;
    return std::move(header_);
  }

 private:
  void read_format() {
    const std::string_view word = scan_.word();
    if (word == "ascii") {
      header_.encoding = PlyEncoding::Text;
    } else if (word == "binary_little_endian") {
      header_.encoding = PlyEncoding::LittleEndian;
    } else if (word == "binary_big_endian") {
      header_.encoding = PlyEncoding::BigEndian;
    } else {
      scan_.fail("read/format", fmt::format("PLY format {} is none we know", quoted_word(word)));
    }
  }

  void read_comment() {
    constexpr std::string_view kPicture = "TextureFile ";
    const std::string_view text = scan_.rest_of_line();
    if (text.starts_with(kPicture) && header_.picture.empty()) header_.picture = text.substr(kPicture.size());
  }

  void read_element() {
    Element element;
    element.name = scan_.word();
    element.count = scan_.integer("the number of elements");
    if (element.count < 0 || element.count > kMaxElements)
      scan_.fail("read/limit", fmt::format("the header counts {}, must be in [0, {}]", element.count, kMaxElements));
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) scan_.fail("read/syntax", "a property stands before the first element");
    Property property;
    std::string_view word = scan_.word();
    property.is_list = word == "list";
    if (property.is_list) {
      property.count_type = scalar(scan_.word());
      if (property.count_type >= Scalar::Float32) scan_.fail("read/syntax", "a list is counted by a whole number");
      word = scan_.word();
    }
    property.type = scalar(word);
    property.name = scan_.word();
    header_.elements.back().properties.push_back(std::move(property));
  }

  Scalar scalar(std::string_view word) const {
    for (const auto& [name, type] : kScalarNames)
      if (name == word) return type;
    scan_.fail("read/syntax", fmt::format("{} is no PLY type", quoted_word(word)));
  }

  TextScanner scan_;
  Header header_;
};

// The body as a row of numbers, either way it is stored.
class TextBody {
 public:
  TextBody(std::string_view bytes, const std::string& name) : scan_(bytes, name) {}

  // Passes over the header and stands on the body.
  void skip_lines(int lines) {
    for (int i = 0; i < lines; ++i) scan_.skip_line();
  }
  int place() { return scan_.more() ? scan_.line() : scan_.line(); }
  double next(Scalar) { return scan_.number("a value"); }
  bool at_end() { return !scan_.more(); }
  [[noreturn]] void fail(const std::string& code, const std::string& message) const { scan_.fail(code, message); }

 private:
  TextScanner scan_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, const std::string& name, std::size_t start, std::endian order)
      : bytes_(bytes), name_(name), at_(start), order_(order) {}

  int place() const { return static_cast<int>(at_); }
  bool at_end() const { return at_ == bytes_.size(); }
  double next(Scalar type) {
    switch (type) {
      case Scalar::Int8:
        return take<std::int8_t>();
      case Scalar::Uint8:
        return take<std::uint8_t>();
      case Scalar::Int16:
        return take<std::int16_t>();
      case Scalar::Uint16:
        return take<std::uint16_t>();
      case Scalar::Int32:
        return take<std::int32_t>();
      case Scalar::Uint32:
        return take<std::uint32_t>();
      case Scalar::Float32:
        return take<float>();
      case Scalar::Float64:
        return take<double>();
    }
    return 0;
  }
  [[noreturn]] void fail(const std::string& code, const std::string& message) const {
    throw InvalidInput(code, message, fmt::format("{}: byte {}", name_, at_));
  }

 private:
  template <class Number>
  double take() {
    if (bytes_.size() - at_ < sizeof(Number)) fail("read/truncated", "the file ends too early");
    const auto number = load_number<Number>(bytes_, at_, order_);
    at_ += sizeof(Number);
    return static_cast<double>(number);
  }

  std::string_view bytes_;
  std::string name_;
  std::size_t at_;
  std::endian order_;
};

template <class Body>
class BodyReader {
 public:
  BodyReader(const Header& header, Body body, MeshSource& source)
      : header_(header), body_(std::move(body)), source_(source) {}

  void read() {
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        for (int i = 0; i < element.count && !element.properties.empty(); ++i) pass_row(element);
      }
    }
    if (!body_.at_end()) body_.fail("read/counts", "more follows after the elements that the header counts");
    check_indices();
    add_looks();
  }

 private:
  void read_vertices(const Element& element) {
    const std::array<int, 3> xyz = {element.find("x"), element.find("y"), element.find("z")};
    if (*std::min_element(xyz.begin(), xyz.end()) < 0) body_.fail("read/syntax", "the PLY vertices have no x, y and z");
    const std::array<int, 3> rgb = color_of(element);
    const std::array<int, 2> uv = uv_of(element);
    std::vector<double> row;
    for (int i = 0; i < element.count; ++i) {
      source_.point_place.push_back(body_.place());
      read_row(element, row);
      const auto value = [&](int k) { return row[static_cast<std::size_t>(k)]; };
      source_.soup.points.emplace_back(value(xyz[0]), value(xyz[1]), value(xyz[2]));
      if (rgb[0] >= 0) point_colors_.push_back(color(element, rgb, row));
      if (uv[0] >= 0) point_uv_.emplace_back(value(uv[0]), value(uv[1]));
    }
  }

  void read_row(const Element& element, std::vector<double>& row) {
    row.clear();
    for (const Property& property : element.properties) row.push_back(pass(property));
  }

  static Color color(const Element& element, const std::array<int, 3>& rgb, const std::vector<double>& row) {
    Color result;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(rgb[k]);
      const double value = row[at] / color_scale(element.properties[at].type);
      result[k] = value >= 0 ? std::min(value, 1.0) : 0;
    }
    return result;
  }

  void read_faces(const Element& element) {
    int list = element.find("vertex_indices");
    if (list < 0) list = element.find("vertex_index");
    if (list < 0 || !element.properties[static_cast<std::size_t>(list)].is_list)
      body_.fail("read/syntax", "the PLY faces have no list vertex_indices");
    const std::array<int, 3> rgb = color_of(element);
    std::vector<double> row(element.properties.size());
    for (int i = 0; i < element.count; ++i) {
      source_.face_place.push_back(body_.place());
      corner_uv_.clear();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const Property& property = element.properties[k];
        if (static_cast<int>(k) == list)
          read_corners(property);
        else if (property.is_list && property.name == "texcoord")
          read_texture_points(property);
        else
          row[k] = pass(property);
      }
      source_.soup.offsets.push_back(static_cast<int>(source_.soup.corners.size()));
      if (rgb[0] >= 0) source_.looks.colors.resize(source_.soup.corners.size(), color(element, rgb, row));
      add_corner_uv();
    }
  }

  void read_texture_points(const Property& list) {
    for (int n = list_size(list); n > 0; --n) corner_uv_.push_back(body_.next(list.type));
  }

  // (u, v) of every corner of the face read last, when it has them.
  void add_corner_uv() {
    std::vector<Vec2>& uv = source_.looks.uv;
    const std::size_t corners = source_.soup.corners.size(), before = source_.soup.offsets.end()[-2];
    if (corner_uv_.size() != 2 * (corners - before) || corner_uv_.empty()) {
      if (!uv.empty()) uv.resize(corners, kNoUv);
      return;
    }
    uv.resize(before, kNoUv);
    for (std::size_t k = 0; k < corner_uv_.size(); k += 2) uv.emplace_back(corner_uv_[k], corner_uv_[k + 1]);
  }

  // Colours of faces come before those of vertices; so do their texture points.
  void add_looks() {
    Looks& looks = source_.looks;
    const std::vector<int>& corners = source_.soup.corners;
    if (looks.colors.empty() && !point_colors_.empty())
      for (const int v : corners) looks.colors.push_back(point_colors_[static_cast<std::size_t>(v)]);
    if (looks.uv.empty() && !point_uv_.empty())
      for (const int v : corners) looks.uv.push_back(point_uv_[static_cast<std::size_t>(v)]);
    if (header_.picture.empty() || looks.uv.empty()) return;
    looks.materials.push_back({.name = header_.picture, .picture = header_.picture});
    looks.material.assign(static_cast<std::size_t>(source_.soup.num_faces()), 0);
  }

  void read_corners(const Property& list) {
    for (int n = list_size(list); n > 0; --n) {
      const double corner = body_.next(list.type);
      if (!(std::abs(corner) <= std::numeric_limits<int>::max()) || corner != std::floor(corner))
        body_.fail("read/number", fmt::format("a face corner is {}, must be a whole number", corner));
      source_.soup.corners.push_back(static_cast<int>(corner));
    }
  }

  int list_size(const Property& list) {
    const double n = body_.next(list.count_type);
    if (!(n >= 0 && n <= std::numeric_limits<int>::max()) || n != std::floor(n))
      body_.fail("read/number", fmt::format("a list has {} entries, must be a count", n));
    return static_cast<int>(n);
  }

  void pass_row(const Element& element) {
    for (const Property& property : element.properties) pass(property);
  }

  double pass(const Property& property) {  // the value of a scalar
    if (!property.is_list) return body_.next(property.type);
    for (int n = list_size(property); n > 0; --n) body_.next(property.type);
    return 0;
  }

  void check_indices() const {  // last, because faces may come before vertices
    const PolygonSoup& soup = source_.soup;
    for (int f = 0; f < soup.num_faces(); ++f)
      for (int v : soup.face(f))
        if (v < 0 || v >= soup.num_points())
          throw InvalidInput("read/index",
                             fmt::format("face {} uses vertex {}, must be in [0, {}]", f, v, soup.num_points() - 1),
                             source_.place(source_.face_place[static_cast<std::size_t>(f)]));
  }

  const Header& header_;
  Body body_;
  MeshSource& source_;
  std::vector<Color> point_colors_;
  std::vector<Vec2> point_uv_;
  std::vector<double> corner_uv_;  // of one face, u and v in turn
};

std::string header_text(const PolygonSoup& soup, PlyEncoding encoding, std::string_view count_type) {
  constexpr std::string_view kNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  return fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list {} int vertex_indices\nend_header\n",
      kNames[static_cast<int>(encoding)], soup.num_points(), soup.num_faces(), count_type);
}

std::string text_body(const PolygonSoup& soup) {
  fmt::memory_buffer out;
  for (const Vec3& p : soup.points) fmt::format_to(fmt::appender(out), "{} {} {}\n", p.x(), p.y(), p.z());
  for (int f = 0; f < soup.num_faces(); ++f) {
    fmt::format_to(fmt::appender(out), "{}", soup.face(f).size());
    for (int v : soup.face(f)) fmt::format_to(fmt::appender(out), " {}", v);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace

MeshSource read_ply(std::string_view bytes, const std::string& name) {
  constexpr std::string_view kEnd = "end_header";
  const auto end = bytes.find(kEnd);
  const auto line_end = end == std::string_view::npos ? end : bytes.find_first_of("\r\n", end);
  // A carriage return may be followed by a line feed, which still belongs to the header.
  const bool crlf = line_end != std::string_view::npos && bytes.substr(line_end, 2) == "\r\n";
  const auto header_size = line_end == std::string_view::npos ? bytes.size() : line_end + (crlf ? 2 : 1);
  const Header header = HeaderReader(bytes.substr(0, header_size), name).read();
  MeshSource source;
  source.name = name;
  source.binary = header.encoding != PlyEncoding::Text;
  if (source.binary) {
    const auto order = header.encoding == PlyEncoding::BigEndian ? std::endian::big : std::endian::little;
    BodyReader(header, BinaryBody(bytes, name, header.size, order), source).read();
  } else {
    TextBody body(bytes, name);
    body.skip_lines(header.lines);
    BodyReader(header, std::move(body), source).read();
  }
  return source;
}

std::string write_ply(const PolygonSoup& soup, PlyEncoding encoding) {
  bool small = true;
  for (int f = 0; f < soup.num_faces(); ++f) small = small && soup.face(f).size() <= 255;
  std::string out = header_text(soup, encoding, small ? "uchar" : "int");
  if (encoding == PlyEncoding::Text) return out + text_body(soup);
  const auto order = encoding == PlyEncoding::BigEndian ? std::endian::big : std::endian::little;
  for (const Vec3& p : soup.points)
    for (int axis = 0; axis < 3; ++axis) append_number(out, p[axis], order);
  for (int f = 0; f < soup.num_faces(); ++f) {
    const auto face = soup.face(f);
    small ? append_number(out, static_cast<std::uint8_t>(face.size()), order)
          : append_number(out, static_cast<std::int32_t>(face.size()), order);
    for (int v : face) append_number(out, static_cast<std::int32_t>(v), order);
  }
  return out;
}

}  // namespace plico
