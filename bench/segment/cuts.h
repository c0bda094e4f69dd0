// Cuts of meshes as the tables of bench_segment need them.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/creature.h"
#include "plico/workflow/segment_mesh.h"
#include "table.h"

namespace plico::bench {

inline constexpr double kSecondsAtMost = 60;  // for one row

struct Seam {
  double diagonals = 0, concave = 0;  // length; share of it in valleys
};

inline Seam seam_of(const Mesh& mesh, const Segmentation& parts) {
  double sum = 0, valleys = 0;
  for (EdgeId e : seams(mesh, parts)) {
    sum += length(mesh, e);
    if (fold_angle(mesh, e) > 0) valleys += length(mesh, e);
  }
  return {sum / diagonal(mesh), sum > 0 ? valleys / sum : 1};
}

struct Cut {
  Kit result;
  double seconds = 0;
};

inline Cut cut(const Mesh& mesh, const SegmentOptions& options) {
  Cut made;
  const auto work = [&] { made.result = segment_mesh(mesh, options, limited(Run{}, kSecondsAtMost)); };
  made.seconds = processor_seconds(work);
  return made;
}

inline SegmentOptions exactly(int parts, SegmentMethod method = SegmentMethod::Necks) {
  SegmentOptions options;
  options.method = method;
  options.wish = PartsWish::Exactly;
  options.parts = parts;
  return options;
}

inline SegmentOptions fewest() {
  SegmentOptions options;
  options.wish = PartsWish::Fewest;
  return options;
}

struct Named {
  std::string name;
  Mesh mesh;
};

inline std::vector<Named> all_meshes(const Arguments& arguments) {
  std::vector<Named> meshes;
  for (const auto& path : mesh_files(arguments.meshes)) {
    try {
      meshes.push_back({path.stem(), load_mesh(path)});
    } catch (const InvalidInput& error) {
      fmt::print("{}: {}\n", path.stem().string(), error.what());
    }
  }
  for (Animal animal : kAnimals)
    meshes.push_back({std::string(name(animal)), Mesh(creature({.animal = animal, .faces = 500}))});
  return meshes;
}

}  // namespace plico::bench
