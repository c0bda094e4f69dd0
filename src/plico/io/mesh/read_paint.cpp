#include "plico/io/mesh/read_paint.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plico/base/error.h"
#include "plico/io/mesh/mtl.h"
#include "plico/io/text/read_picture.h"
#include "plico/mesh/triangulate.h"

namespace plico {
namespace {

// Programs on Windows write "textures\skin.png", and whole paths of their own machine.
std::vector<std::string> names_to_try(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::vector<std::string> names{name};
  if (const std::size_t slash = name.find_last_of('/'); slash != std::string::npos)
    names.push_back(name.substr(slash + 1));
  return names;
}

class PaintReader {
 public:
  PaintReader(const MeshSource& source, const FileBeside& file)
      : source_(source), looks_(source.looks), file_(file), materials_(source.looks.materials) {}

  PaintRead run() {
    for (const std::string& library : looks_.libraries) read_library(library);
    for (const Material& material : materials_) picture_of_.push_back(picture(material));
    for (int f = 0; f < source_.soup.num_faces(); ++f) add_face(f);
    if (says_nothing()) result_.paint = {};
    return std::move(result_);
  }

 private:
  std::optional<std::string> bytes_of(const std::string& name) const {
    for (const std::string& one : names_to_try(name))
      if (std::optional<std::string> bytes = one.empty() ? std::nullopt : file_(one)) return bytes;
    return {};
  }

  void read_library(const std::string& library) {
    const std::optional<std::string> bytes = bytes_of(library);
    if (!bytes) return note(fmt::format("colours are left out: there is no {}", library));
    try {
      for (Material& read : read_mtl(*bytes, library))
        for (Material& material : materials_)
          if (material.name == read.name) material = read;
    } catch (const InvalidInput& error) {
      note(fmt::format("colours are left out: {} ({})", error.what(), error.where()));
    }
  }

  // The number of its picture in the paint, -1 for none.
  int picture(const Material& material) {
    if (material.picture.empty() && material.picture_bytes.empty()) return -1;
    const std::string& name = material.picture.empty() ? material.name : material.picture;
    if (const auto known = known_.find(name); known != known_.end()) return known->second;
    int& number = known_[name] = -1;
    const std::optional<std::string> bytes =
        material.picture_bytes.empty() ? bytes_of(material.picture) : material.picture_bytes;
    if (!bytes) {
      note(fmt::format("the picture {} is left out: there is no such file", name));
      return number;
    }
    try {
      result_.paint.pictures.push_back(read_picture(*bytes, name));
      number = static_cast<int>(result_.paint.pictures.size()) - 1;
    } catch (const InvalidInput& error) {
      note(fmt::format("{}; it is left out", error.what()));
    }
    return number;
  }

  void note(std::string sentence) { result_.notes.push_back(std::move(sentence)); }

  int material_of(int face) const {
    return face < static_cast<int>(looks_.material.size()) ? looks_.material[face] : -1;
  }

  void add_face(int face) {
    const PolygonSoup& soup = source_.soup;
    const int first = soup.offsets[face], last = soup.offsets[face + 1];
    // Where a face has a point twice, the first counts.
    const auto corner_at = [&](int point) {
      for (int at = first; at < last; ++at)
        if (soup.corners[at] == point) return at;
      return first;
    };
    for (const auto& points : triangulate_face(soup, face)) {
      std::array<int, 3> at{};
      std::ranges::transform(points, at.begin(), corner_at);
      result_.paint.triangles.push_back(triangle(at, material_of(face)));
    }
  }

  PaintedTriangle triangle(const std::array<int, 3>& at, int material) const {
    PaintedTriangle result;
    const bool has_picture = material >= 0 && picture_of_[material] >= 0 && !looks_.uv.empty() &&
                             std::ranges::all_of(at, [&](int c) { return looks_.uv[c].allFinite(); });
    Color color = kWhite;
    if (material >= 0 && (!has_picture || materials_[material].tints)) color = materials_[material].color;
    for (std::size_t i = 0; i < 3; ++i) {
      result.corners[i] = source_.soup.points[source_.soup.corners[at[i]]];
      result.colors[i] = looks_.colors.empty() ? color : product(color, looks_.colors[at[i]]);
      if (has_picture)
        result.uv[i] = looks_.uv[at[i]].cwiseProduct(materials_[material].scale) + materials_[material].offset;
    }
    if (has_picture) result.picture = picture_of_[material];
    return result;
  }

  // One grey all over is what programs write when nobody chose a colour.
  bool says_nothing() const {
    const std::vector<PaintedTriangle>& all = result_.paint.triangles;
    if (all.empty()) return true;
    const Color& first = all.front().colors[0];
    return first[0] == first[1] && first[0] == first[2] && std::ranges::all_of(all, [&](const PaintedTriangle& t) {
             return t.picture < 0 && std::ranges::all_of(t.colors, [&](const Color& c) { return c == first; });
           });
  }

  const MeshSource& source_;
  const Looks& looks_;
  const FileBeside& file_;
  std::vector<Material> materials_;
  std::vector<int> picture_of_;       // of each material, -1 for none
  std::map<std::string, int> known_;  // pictures by name: several materials may share one
  PaintRead result_;
};

}  // namespace

PaintRead read_paint(const MeshSource& source, const FileBeside& file) { return PaintReader(source, file).run(); }

}  // namespace plico
