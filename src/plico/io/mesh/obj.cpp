#include "plico/io/mesh/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "plico/base/error.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& name) : scan_(bytes, name) { source_.name = name; }

  MeshSource read() {
    while (scan_.more()) {
      const std::string_view keyword = scan_.word();
      if (keyword == "v") {
        read_vertex();
      } else if (keyword == "f") {
        read_face();
      } else if (keyword == "vt") {
        read_texture_point();
      } else if (keyword == "usemtl") {
        material_ = source_.looks.number_of(std::string(scan_.rest_of_line()));
      } else if (keyword == "mtllib") {
        source_.looks.libraries.emplace_back(scan_.rest_of_line());
      } else {
        while (scan_.more_on_line()) scan_.word();  // word by word, since such a line may be joined with the next
      }
    }
    check_indices();
    add_looks();
    return std::move(source_);
  }

 private:
  void read_vertex() {
    source_.point_place.push_back(scan_.line());
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      if (!scan_.more_on_line()) scan_.fail("read/syntax", "a vertex needs three coordinates");
      p[axis] = scan_.number("a coordinate");
    }
    read_vertex_color();
    source_.soup.points.push_back(p);
  }

  // Three numbers after the coordinates are a colour, as scanners write it; one is a weight.
  void read_vertex_color() {
    std::vector<double> numbers;
    while (scan_.more_on_line()) {
      double number = std::numeric_limits<double>::quiet_NaN();
      parse_number(scan_.word(), number);
      numbers.push_back(number);
    }
    const bool is_color =
        numbers.size() == 3 && std::ranges::all_of(numbers, [](double n) { return n >= 0 && n <= 255; });
    has_colors_ = has_colors_ || is_color;
    const double most = is_color && std::ranges::max(numbers) > 1 ? 255 : 1;
    point_colors_.push_back(is_color ? Color{numbers[0] / most, numbers[1] / most, numbers[2] / most} : kWhite);
  }

  void read_texture_point() {
    Vec2 uv = Vec2::Zero();  // looks are never a reason to refuse a shape: what is no number counts as 0
    for (int axis = 0; axis < 2 && scan_.more_on_line(); ++axis) parse_number(scan_.word(), uv[axis]);
    while (scan_.more_on_line()) scan_.word();
    texture_points_.push_back(uv);
  }

  void read_face() {
    source_.face_place.push_back(scan_.line());
    while (scan_.more_on_line()) {
      const std::string_view word = scan_.word();
      source_.soup.corners.push_back(corner(word));
      corner_texture_.push_back(texture_point(word));
    }
    source_.looks.material.push_back(material_);
    source_.soup.offsets.push_back(static_cast<int>(source_.soup.corners.size()));
  }

  int corner(std::string_view word) {
    int index = 0;
    if (!parse_integer(word.substr(0, word.find('/')), index))
      scan_.fail("read/number", fmt::format("a face corner is {}, must start with a vertex number", quoted_word(word)));
    if (index > 0) return index - 1;  // may name a vertex further down, so the end is checked last
    const int count = source_.soup.num_points();
    if (index == 0 || count + index < 0)
      scan_.fail("read/index", fmt::format("face {} uses vertex {}, must be in [1, {}] or [-{}, -1]",
                                           source_.soup.num_faces(), index, count, count));
    return count + index;
  }

  // "7/3/2" or "7/3": its second number, from 0; -1 when there is none.
  int texture_point(std::string_view word) const {
    const std::size_t slash = word.find('/');
    int index = 0;
    if (slash == std::string_view::npos) return -1;
    word.remove_prefix(slash + 1);
    if (!parse_integer(word.substr(0, word.find('/')), index) || index == 0) return -1;
    return index > 0 ? index - 1 : static_cast<int>(texture_points_.size()) + index;
  }

  // Texture points may stand after the faces that use them.
  void add_looks() {
    Looks& looks = source_.looks;
    const auto known = [&](int t) { return t >= 0 && t < static_cast<int>(texture_points_.size()); };
    if (std::ranges::any_of(corner_texture_, known))
      for (const int t : corner_texture_) looks.uv.push_back(known(t) ? texture_points_[t] : kNoUv);
    if (has_colors_)
      for (const int v : source_.soup.corners) looks.colors.push_back(point_colors_[v]);
    if (looks.materials.empty()) looks.material.clear();
  }

  void check_indices() const {
    const PolygonSoup& soup = source_.soup;
    for (int f = 0; f < soup.num_faces(); ++f)
      for (int v : soup.face(f))
        if (v >= soup.num_points())
          throw InvalidInput(
              "read/index",
              fmt::format("face {} uses vertex {}, the file has {} vertices", f, v + 1, soup.num_points()),
              source_.place(source_.face_place[f]));
  }

  TextScanner scan_;
  MeshSource source_;
  std::vector<Vec2> texture_points_;
  std::vector<Color> point_colors_;
  std::vector<int> corner_texture_;  // of each corner of a face, -1 for none
  int material_ = -1;                // of the faces that follow
  bool has_colors_ = false;
};

void append_polygons(fmt::memory_buffer& out, const PolygonSoup& soup, int points_before) {
  for (const Vec3& p : soup.points) fmt::format_to(fmt::appender(out), "v {} {} {}\n", p.x(), p.y(), p.z());
  for (int f = 0; f < soup.num_faces(); ++f) {
    out.push_back('f');
    for (int v : soup.face(f)) fmt::format_to(fmt::appender(out), " {}", points_before + v + 1);
    out.push_back('\n');
  }
}

}  // namespace

MeshSource read_obj(std::string_view bytes, const std::string& name) { return ObjReader(bytes, name).read(); }

std::string write_obj(const PolygonSoup& soup) {
  fmt::memory_buffer out;
  append_polygons(out, soup, 0);
  return fmt::to_string(out);
}

std::string write_obj(const std::vector<ObjObject>& objects) {
  fmt::memory_buffer out;
  int before = 0;
  for (const ObjObject& object : objects) {
    std::string name = object.name;
    for (char& c : name)
      if (c == '\n' || c == '\r') c = ' ';
    fmt::format_to(fmt::appender(out), "o {}\n", name);
    append_polygons(out, object.soup, before);
    before += object.soup.num_points();
  }
  return fmt::to_string(out);
}

}  // namespace plico
