#include "plico/io/mesh/obj.h"

#include <fmt/format.h>

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
      } else {
        while (scan_.more_on_line()) scan_.word();  // word by word, since such a line may be joined with the next
      }
    }
    check_indices();
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
    while (scan_.more_on_line()) scan_.word();  // weight or colour
    source_.soup.points.push_back(p);
  }

  void read_face() {
    source_.face_place.push_back(scan_.line());
    while (scan_.more_on_line()) source_.soup.corners.push_back(corner(scan_.word()));
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
