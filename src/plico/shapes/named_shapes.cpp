#include "plico/shapes/named_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "plico/base/error.h"
#include "plico/shapes/creature.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

struct Entry {
  NamedShape shape;
  std::function<PolygonSoup(const ShapeOptions&)> make;
  bool is_creature = false;
};

Entry fixed(const char* name, const char* description, std::function<PolygonSoup()> make) {
  return {{name, description}, [make = std::move(make)](const ShapeOptions&) { return make(); }};
}

// `make` is told the number of faces, at least `fewest`.
Entry counted(const char* name, const char* description, int usual, int fewest, std::function<PolygonSoup(int)> make) {
  return {{name, fmt::format("{}; {} faces unless told", description, usual), true},
          [name, usual, fewest, make = std::move(make)](const ShapeOptions& options) {
            const int faces = options.faces == 0 ? usual : options.faces;
            if (faces < fewest || faces > 1'000'000)
              throw InvalidOption(fmt::format("faces = {} must be in [{}, 1000000] for a {}", faces, fewest, name));
            return make(faces);
          }};
}

Entry animal(Animal animal, const char* description, int usual) {
  const auto make = [animal, usual](const ShapeOptions& options) {
    return creature({.animal = animal,
                     .faces = options.faces == 0 ? usual : options.faces,
                     .variety = options.variety,
                     .seed = options.seed});
  };
  return {{std::string(name(animal)), fmt::format("{}; {} faces unless told", description, usual), true}, make, true};
}

int nearest_root(double faces) { return std::max(1, static_cast<int>(std::lround(std::sqrt(faces)))); }

// Squares on the tube where the torus is widest seen from its middle: n / m = 1 / tube.
PolygonSoup even_torus(int faces) {
  const int m = std::max(3, static_cast<int>(std::lround(std::sqrt(faces * 0.4))));
  return torus(std::max(3, static_cast<int>(std::lround(static_cast<double>(faces) / m))), m);
}

std::vector<Entry> make_entries() {
  return {
      animal(Animal::Bird, "a dove in flight", 300),
      animal(Animal::Dog, "a standing dog", 500),
      animal(Animal::Fish, "a fish with five kinds of fins", 400),
      animal(Animal::Dinosaur, "a hunter on two legs", 500),
      fixed("tetrahedron", "4 triangles", tetrahedron),
      fixed("cube", "6 squares", cube),
      fixed("octahedron", "8 triangles", octahedron),
      fixed("dodecahedron", "12 pentagons", dodecahedron),
      fixed("icosahedron", "20 triangles", icosahedron),
      fixed("truncated-tetrahedron", "4 triangles, 4 hexagons", [] { return truncated(Mesh(tetrahedron()), 3); }),
      fixed("truncated-cube", "8 triangles, 6 octagons", [] { return truncated(Mesh(cube()), 4); }),
      fixed("truncated-octahedron", "6 squares, 8 hexagons", [] { return truncated(Mesh(octahedron()), 3); }),
      fixed("truncated-dodecahedron", "20 triangles, 12 decagons", [] { return truncated(Mesh(dodecahedron()), 5); }),
      fixed("truncated-icosahedron", "12 pentagons, 20 hexagons: a football",
            [] { return truncated(Mesh(icosahedron()), 3); }),
      fixed("cuboctahedron", "8 triangles, 6 squares", [] { return rectified(Mesh(cube())); }),
      fixed("icosidodecahedron", "20 triangles, 12 pentagons", [] { return rectified(Mesh(icosahedron())); }),
      fixed("star", "the stella octangula: 24 triangles", [] { return spiked(Mesh(octahedron()), 1); }),
      fixed("small-stellated-dodecahedron", "12 five-sided spikes: 60 triangles",
            [] { return spiked(Mesh(dodecahedron()), std::numbers::phi); }),
      fixed("great-stellated-dodecahedron", "20 three-sided spikes: 60 triangles",
            [] { return spiked(Mesh(icosahedron()), std::numbers::phi); }),
      counted("prism", "two polygons and squares between them", 8, 5, [](int n) { return prism(n - 2); }),
      counted("pyramid", "a polygon and triangles that meet in a point", 5, 4,
              [](int n) { return frustum(n - 1, 0, 1.6); }),
      counted("cone", "a pyramid with many sides", 17, 9, [](int n) { return frustum(n - 1, 0, 2.2); }),
      counted("cylinder", "two round lids and a wall of strips", 18, 10, [](int n) { return frustum(n - 2, 1, 2.2); }),
      counted("frustum", "a pyramid without its tip", 6, 5, [](int n) { return frustum(n - 2, 0.55, 1.2); }),
      fixed("house", "a box with a ridged roof: 7 faces", house),
      counted("antiprism", "two polygons and triangles between them", 12, 8,
              [](int n) { return antiprism((n - 2) / 2); }),
      counted("sphere", "a geodesic sphere of 20 f^2 triangles", 180, 20,
              [](int n) { return geodesic_sphere(nearest_root(n / 20.0)); }),
      counted("torus", "a ring of planar quadrangles", 240, 9, even_torus),
      counted("quad-cube", "a cube of 6 n^2 squares", 54, 6, [](int n) { return quad_cube(nearest_root(n / 6.0)); }),
      counted("grid", "an open sheet of n^2 squares", 64, 1,
              [](int n) { return open_grid(nearest_root(n), nearest_root(n)); }),
  };
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = make_entries();
  return all;
}

}  // namespace

const std::vector<NamedShape>& named_shapes() {
  static const std::vector<NamedShape> all = [] {
    std::vector<NamedShape> shapes;
    for (const Entry& entry : entries()) shapes.push_back(entry.shape);
    return shapes;
  }();
  return all;
}

PolygonSoup make_shape(std::string_view name, const ShapeOptions& options) {
  const auto& all = entries();
  const auto entry = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.shape.name == name; });
  if (entry == all.end())
    throw InvalidOption(fmt::format("there is no sample shape called {}", name), "plico sample --list");
  if (options.faces != 0 && !entry->shape.has_face_count)
    throw InvalidOption(fmt::format("the faces of a {} cannot be chosen", name), "plico sample --list");
  if (options.variety != 0 && !entry->is_creature)
    throw InvalidOption(fmt::format("variety is for animals, a {} has none", name), "plico sample --list");
  return entry->make(options);
}

}  // namespace plico
