#include "plico/io/mesh/off.h"

#include <fmt/format.h>

#include <algorithm>

#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

class OffReader {
 public:
  OffReader(std::string_view bytes, const std::string& name) : size_(bytes.size()), scan_(bytes, name) {
    source_.name = name;
  }

  MeshSource read() {
    read_header();
    for (int i = 0; i < vertices_; ++i) read_vertex(i);
    for (int i = 0; i < faces_; ++i) read_face(i);
    if (scan_.more()) {
      scan_.word();
      scan_.fail("read/counts",
                 fmt::format("more follows after the {} vertices and {} faces of the header", vertices_, faces_));
    }
    return std::move(source_);
  }

 private:
  // The keyword is optional; then the counts of vertices and faces, and of edges, which nobody keeps true.
  void read_header() {
    std::string_view word = scan_.word();
    if (const std::size_t keyword = word.find("OFF"); keyword != std::string_view::npos) {
      const std::string_view prefix = word.substr(0, keyword), glued = word.substr(keyword + 3);
      if (prefix.find_first_not_of("STCN") != std::string_view::npos)
        scan_.fail("read/format", fmt::format("{} is no OFF file in three dimensions", quoted_word(word)));
      extra_columns_ = !prefix.empty();
      word = glued.empty() ? scan_.word() : glued;  // some programs write "OFF8 6 12"
    }
    if (word == "BINARY")
      scan_.fail("read/format", "binary OFF files cannot be read", "save the mesh as text OFF or as PLY");
    if (!parse_integer(word, vertices_))
      scan_.fail("read/format",
                 fmt::format("an OFF file starts with OFF and three counts, this one with {}", quoted_word(word)));
    faces_ = scan_.integer("the number of faces");
    for (int count : {vertices_, faces_})
      if (count < 0 || count > kMaxElements)
        scan_.fail("read/limit", fmt::format("the header counts {}, must be in [0, {}]", count, kMaxElements));
    if (scan_.more_on_line()) scan_.integer("the number of edges");
    while (scan_.more_on_line()) scan_.word();  // what programs remark after it
    reserve();
  }

  void reserve() {  // never more than the bytes can hold, whatever the header says
    const std::size_t most = size_ / 6 + 1;
    const std::size_t points = std::min<std::size_t>(vertices_, most), faces = std::min<std::size_t>(faces_, most);
    source_.soup.points.reserve(points);
    source_.point_place.reserve(points);
    source_.soup.offsets.reserve(faces + 1);
    source_.soup.corners.reserve(3 * faces);
    source_.face_place.reserve(faces);
  }

  void read_vertex(int i) {
    if (!scan_.more()) truncated("vertices", i, vertices_);
    source_.point_place.push_back(scan_.line());
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = scan_.number("a coordinate");
    source_.soup.points.push_back(p);
    if (extra_columns_) scan_.skip_line();
  }

  void read_face(int i) {
    if (!scan_.more()) truncated("faces", i, faces_);
    source_.face_place.push_back(scan_.line());
    const int size = scan_.integer("the number of corners of a face");
    if (size < 0) scan_.fail("read/syntax", fmt::format("face {} has {} corners", i, size));
    for (int k = 0; k < size; ++k) {
      const int v = scan_.integer("a face corner");
      if (v < 0 || v >= vertices_)
        scan_.fail("read/index", fmt::format("face {} uses vertex {}, must be in [0, {}]", i, v, vertices_ - 1));
      source_.soup.corners.push_back(v);
    }
    source_.soup.offsets.push_back(static_cast<int>(source_.soup.corners.size()));
    read_face_color(size);
  }

  // Three or four numbers: bytes when they are whole, else in [0, 1]. A single one is an index into a table nobody has.
  void read_face_color(int size) {
    std::vector<double> numbers;
    bool whole = true;
    while (scan_.more_on_line()) {
      const std::string_view word = scan_.word();
      double number = 0;
      if (!parse_number(word, number) || !(number >= 0 && number <= 255)) numbers.assign(5, 0);
      numbers.push_back(number);
      whole = whole && word.find_first_not_of("0123456789") == std::string_view::npos;
    }
    const bool is_color = numbers.size() == 3 || numbers.size() == 4;
    std::vector<Color>& colors = source_.looks.colors;
    if (!is_color && colors.empty()) return;
    colors.resize(source_.soup.corners.size() - size, kWhite);  // of the faces before, when this is the first
    const double most = whole ? 255 : 1;
    Color color = kWhite;
    for (std::size_t k = 0; is_color && k < 3; ++k) color[k] = std::min(numbers[k] / most, 1.0);
    colors.resize(source_.soup.corners.size(), color);
  }

  [[noreturn]] void truncated(const char* what, int have, int promised) const {
    scan_.fail("read/truncated", fmt::format("the file ends after {} of {} {}", have, promised, what));
  }

  std::size_t size_;
  TextScanner scan_;
  MeshSource source_;
  int vertices_ = 0, faces_ = 0;
  bool extra_columns_ = false;
};

}  // namespace

MeshSource read_off(std::string_view bytes, const std::string& name) { return OffReader(bytes, name).read(); }

std::string write_off(const PolygonSoup& soup) {
  fmt::memory_buffer out;
  fmt::format_to(fmt::appender(out), "OFF\n{} {} 0\n", soup.num_points(), soup.num_faces());
  for (const Vec3& p : soup.points) fmt::format_to(fmt::appender(out), "{} {} {}\n", p.x(), p.y(), p.z());
  for (int f = 0; f < soup.num_faces(); ++f) {
    fmt::format_to(fmt::appender(out), "{}", soup.face(f).size());
    for (int v : soup.face(f)) fmt::format_to(fmt::appender(out), " {}", v);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace plico
