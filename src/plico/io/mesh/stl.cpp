#include "plico/io/mesh/stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>
#include <limits>

#include "plico/base/error.h"
#include "plico/io/mesh/point_welder.h"
#include "plico/io/text/bytes.h"
#include "plico/io/text/text_scanner.h"
#include "plico/mesh/triangulate.h"

namespace plico {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;

MeshSource read_binary(std::string_view bytes, const std::string& name) {
  MeshSource source;
  source.name = name;
  source.binary = true;
  const auto count = load_number<std::uint32_t>(bytes, 80);
  const std::size_t promised = kHeader + kTriangle * count, have = bytes.size();
  if (count > kMaxElements)
    throw InvalidInput("read/limit",
                       fmt::format("the header counts {} triangles, must be in [0, {}]", count, kMaxElements),
                       source.place(80));
  if (promised != have)
    throw InvalidInput(have < promised ? "read/truncated" : "read/counts",
                       fmt::format("{} triangles need {} bytes, the file has {}", count, promised, have),
                       source.place(80));
  PointWelder welder(source, count / 2);
  source.soup.corners.reserve(3 * count);
  for (std::size_t at = kHeader; at < have; at += kTriangle) {
    const int place = static_cast<int>(at);
    std::array<int, 3> corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 p;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[static_cast<int>(axis)] = load_number<float>(bytes, at + 12 * (corner + 1) + 4 * axis);
      corners[corner] = welder.number_of(p, place);
    }
    source.soup.add_face(corners);
    source.face_place.push_back(place);
  }
  return source;
}

bool same_word(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() &&
         std::equal(word.begin(), word.end(), lower.begin(),
                    [](unsigned char a, char b) { return static_cast<char>(std::tolower(a)) == b; });
}

class StlTextReader {
 public:
  StlTextReader(std::string_view bytes, const std::string& name) : scan_(bytes, name), welder_(source_, 0) {
    source_.name = name;
  }

  MeshSource read() {
    while (scan_.more()) {
      expect("solid");
      scan_.skip_line();  // the name
      for (std::string_view word = scan_.word(); !same_word(word, "endsolid"); word = scan_.word()) {
        if (!same_word(word, "facet")) unexpected(word, "facet or endsolid");
        read_facet();
      }
      if (scan_.more_on_line()) scan_.skip_line();  // the name again
    }
    return std::move(source_);
  }

 private:
  void read_facet() {
    const int place = scan_.line();
    expect("normal");
    for (int axis = 0; axis < 3; ++axis) scan_.word();  // often nonsense, so not even read as a number
    expect("outer");
    expect("loop");
    std::array<int, 3> corners{};
    for (int& corner : corners) {
      expect("vertex");
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis) p[axis] = scan_.number("a coordinate");
      corner = welder_.number_of(p, scan_.line());
    }
    expect("endloop");
    expect("endfacet");
    source_.soup.add_face(corners);
    source_.face_place.push_back(place);
  }

  void expect(std::string_view wanted) {
    const std::string_view word = scan_.word();
    if (!same_word(word, wanted)) unexpected(word, wanted);
  }

  [[noreturn]] void unexpected(std::string_view word, std::string_view wanted) const {
    scan_.fail("read/syntax", fmt::format("{} stands where an STL file has {}", quoted_word(word), wanted));
  }

  TextScanner scan_;
  MeshSource source_;
  PointWelder welder_;
};

// Calls body(a, b, c) with the corners of every triangle.
template <class Body>
void for_each_triangle(const PolygonSoup& soup, Body&& body) {
  for (int f = 0; f < soup.num_faces(); ++f)
    for (const auto& [a, b, c] : triangulate_face(soup, f)) body(soup.points[a], soup.points[b], soup.points[c]);
}

Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3::Zero();
}

void append_floats(std::string& out, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(p[axis]) > std::numeric_limits<float>::max())
      throw InvalidInput("write/range", fmt::format("coordinate {} is too large for STL's 32-bit floats", p[axis]), {},
                         "write OBJ, OFF or PLY");
    append_number(out, static_cast<float>(p[axis]));
  }
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * load_number<std::uint32_t>(bytes, 80);
}

MeshSource read_stl(std::string_view bytes, const std::string& name) {
  const auto start = std::find_if(bytes.begin(), bytes.end(), [](unsigned char c) { return !std::isspace(c); });
  const std::size_t lead = static_cast<std::size_t>(start - bytes.begin());
  const bool text = same_word(bytes.substr(lead, 5), "solid") && !is_binary_stl(bytes);
  if (text) return StlTextReader(bytes, name).read();
  if (bytes.size() < kHeader)
    throw InvalidInput(
        "read/truncated",
        fmt::format("an STL file starts with 'solid' or has at least {} bytes, this one has {}", kHeader, bytes.size()),
        fmt::format("{}: byte 0", name));
  return read_binary(bytes, name);
}

std::string write_stl(const PolygonSoup& soup) {
  std::string out = "binary STL";
  out.resize(80, ' ');
  append_number(out, std::uint32_t{0});
  std::uint32_t count = 0;
  for_each_triangle(soup, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    append_floats(out, unit_normal(a, b, c));
    for (const Vec3* p : {&a, &b, &c}) append_floats(out, *p);
    append_number(out, std::uint16_t{0});
    ++count;
  });
  std::string counted;
  append_number(counted, count);
  return out.replace(80, 4, counted);
}

std::string write_stl_text(const PolygonSoup& soup) {
  fmt::memory_buffer out;
  const auto add = fmt::appender(out);
  fmt::format_to(add, "solid mesh\n");
  for_each_triangle(soup, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = unit_normal(a, b, c);
    fmt::format_to(add, "facet normal {} {} {}\nouter loop\n", n.x(), n.y(), n.z());
    for (const Vec3* p : {&a, &b, &c}) fmt::format_to(add, "vertex {} {} {}\n", p->x(), p->y(), p->z());
    fmt::format_to(add, "endloop\nendfacet\n");
  });
  fmt::format_to(add, "endsolid mesh\n");
  return fmt::to_string(out);
}

}  // namespace plico
