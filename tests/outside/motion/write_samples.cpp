// usage: write_samples FOLDER
// Twelve linkages of every kind and ten nets with proven motions, each as page, animation and robot models, with where
// the library says their panels are; nets also as FOLD files.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/io/motion/gltf.h"
#include "plico/io/motion/mjcf.h"
#include "plico/io/motion/urdf.h"
#include "plico/io/motion/viewer.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/text/file.h"
#include "plico/origami/patterns.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/foldable_net.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

struct Sample {
  std::string name;
  Linkage linkage;
  FoldingPath path;
  std::string fold;  // the file's text; empty for samples that are no nets
};

Sample linear(const std::string& name, const CreasePattern& sheet) {
  const Linkage linkage = make_linkage(sheet);
  return {name, linkage, linear_path(linkage), ""};
}
Sample uniform(const std::string& name, const CreasePattern& sheet) {
  const Linkage linkage = make_linkage(sheet);
  return {name, linkage, uniform_path(linkage), ""};
}

// Squares in a grid that bend along all lines x = 1, 2, ...: every inner corner is a loop, and all of them close.
CreasePattern curtain(int columns, int rows, double turn) {
  CreasePattern sheet;
  const auto vertex = [&](int x, int y) { return y * (columns + 1) + x; };
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) sheet.vertices.emplace_back(x, y);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      sheet.faces.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
      const double angle = x % 2 ? turn : -turn;
      if (x > 0) sheet.edges.push_back({vertex(x, y), vertex(x, y + 1), assignment_of(angle), angle});
      if (y > 0) sheet.edges.push_back({vertex(x, y), vertex(x + 1, y), Assignment::Flat, 0});
    }
  }
  return sheet;
}

Sample thick(Sample sample, double thickness) {
  sample.linkage.thickness = thickness;
  return sample;
}

// A one-piece net of the shape, with a linear motion that is proven free of collision.
Sample net(const std::string& shape, int faces) {
  const Mesh mesh(make_shape(shape, {.faces = faces}));
  const FoldableNet found = find_foldable_net(mesh);
  PLICO_ASSERT(found.proof.verdict == PathVerdict::Free);
  const Unfolding flat = lay_flat(mesh, found.tree);
  FoldFile file = fold_file(mesh, flat);
  set_path(file, linkage_of(flat), found.path);
  return {"net-" + shape, linkage_of(flat), found.path, write_fold(file)};
}

// A sheet with loops, with a motion that is proven free of collision.
Sample planned(const std::string& name, const CreasePattern& sheet) {
  const MotionOutcome found = plan_origami(sheet);
  PLICO_ASSERT(found.proven());
  return {name, make_linkage(sheet), found.motions.front().path, ""};
}

std::vector<Sample> samples() {
  Rng rng(7);
  std::vector<Sample> list;
  list.push_back(linear("single", square_strip({})));
  list.push_back(linear("pair", square_strip({1})));
  list.push_back(linear("closing", square_strip({kPi, -kPi})));
  list.push_back(uniform("strip", square_strip({0.3, -0.6, 0.9, -0.1})));
  list.push_back(thick(linear("plates", square_strip({1, -1, 1})), 0.1));
  list.push_back(linear("loops", curtain(4, 3, 0.8)));
  list.push_back(uniform("snow", random_triangles(24, 0.4, rng)));
  list.push_back(linear("leaf", random_triangles(60, 0.3, rng)));
  list.push_back(uniform("sheet", random_triangles(200, 0.2, rng)));
  Sample back_and_forth = linear("planned", square_strip({0.5, 0.5}));
  back_and_forth.path = path_through({{0, {0, 0}}, {0.4, {1, 0}}, {0.7, {1, 0.5}}, {1, {0.5, 0.5}}});
  list.push_back(back_and_forth);
  list.push_back(planned("miura", miura({.columns = 4, .rows = 3, .zigzag_angle = radians(110)})));
  list.push_back(planned("waterbomb", waterbomb({.columns = 6, .rows = 4, .diagonal_angle = radians(40)})));
  for (const char* animal : {"bird", "dog", "fish", "dinosaur"}) list.push_back(net(animal, 100));
  for (const char* solid : {"octahedron", "dodecahedron", "icosahedron", "truncated-icosahedron"})
    list.push_back(net(solid, 0));
  list.push_back(net("torus", 60));
  list.push_back(net("sphere", 80));
  return list;
}

std::string positions(const Sample& sample) {
  nlohmann::json moments;
  double size = 0;
  for (double time : {0.0, 0.5, 1.0}) {
    const std::vector<Pose> poses = folding_map(sample.linkage, sample.path.at(time));
    nlohmann::json panels;
    for (int p = 0; p < sample.linkage.num_panels(); ++p) {
      nlohmann::json points;
      for (const Vec3& corner : sample.linkage.panels[p])
        for (double x : Vec3(poses[p] * corner)) {
          points.push_back(x);
          size = std::max(size, std::abs(x));
        }
      panels.push_back(points);
    }
    moments.push_back({{"time", time}, {"panels", panels}});
  }
  return nlohmann::json{{"moments", moments}, {"size", size}}.dump();
}

std::string page(const Sample& sample) {
  ViewerInput input;
  input.title = sample.name;
  input.linkage = sample.linkage;
  input.path = sample.path;
  input.report = R"({"panels": 3, "proof": {"status": "free"}})";
  input.links = {{sample.name + ".pdf", sample.name + ".pdf"}, {sample.name + ".fold", sample.name + ".fold"}};
  for (int i = 1; i <= 30; ++i)
    for (const char* kind : {"svg", "dxf"}) {
      const std::string file = fmt::format("{}-{}.{}", sample.name, i, kind);
      input.links.emplace_back(file, file);
    }
  return viewer_page(input);
}

void write_samples(const std::string& folder) {
  nlohmann::json list;
  for (const Sample& sample : samples()) {
    const std::string base = folder + "/" + sample.name;
    RobotOptions robot;
    robot.name = sample.name;
    robot.metres_per_unit = 0.05;
    write_file(base + ".html", page(sample), true);
    write_file(base + ".json", positions(sample), true);
    write_file(base + ".glb", write_glb(sample.linkage, sample.path), true);
    write_file(base + ".urdf", write_urdf(sample.linkage, sample.path, robot).text, true);
    write_file(base + ".xml", write_mjcf(sample.linkage, sample.path, robot).text, true);
    const int joints = sample.linkage.num_hinges() - static_cast<int>(sample.linkage.loop_hinges.size());
    const int surfaces = sample.linkage.num_panels() * (sample.linkage.thickness > 0 ? 3 : 2);
    if (!sample.fold.empty()) write_file(base + ".fold", sample.fold, true);
    list.push_back({{"name", sample.name},
                    {"joints", joints},
                    {"surfaces", surfaces},
                    {"panels", sample.linkage.num_panels()},
                    {"is_net", !sample.fold.empty()}});
  }
  write_file(folder + "/samples.json", list.dump(), true);
}

}  // namespace
}  // namespace plico

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  plico::write_samples(argv[1]);
}
