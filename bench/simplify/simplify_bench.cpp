// 20,000 triangles to 300, of our animals and of five meshes cut into as many: how far that strays, what passes through
// itself afterwards and did not before, whether left and right are equal. Goal: none does, under one second each.
//   bench_simplify [--meshes DIR] [--json FILE]
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/simplify_mesh.h"
#include "table.h"

namespace plico::bench {
namespace {

constexpr int kFine = 20'000, kCoarse = 300, kMostFiles = 5;

// Every triangle cut into four.
PolygonSoup refined(const PolygonSoup& coarse) {
  PolygonSoup fine;
  fine.points = coarse.points;
  std::map<std::pair<int, int>, int> middle;
  const auto between = [&](int u, int v) {
    const auto [at, is_new] = middle.try_emplace(std::minmax(u, v), fine.num_points());
    if (is_new) fine.points.push_back((coarse.points[u] + coarse.points[v]) / 2);
    return at->second;
  };
  for (int f = 0; f < coarse.num_faces(); ++f) {
    const auto t = coarse.face(f);
    const int a = between(t[0], t[1]), b = between(t[1], t[2]), c = between(t[2], t[0]);
    fine.add_face({t[0], a, c});
    fine.add_face({a, t[1], b});
    fine.add_face({c, b, t[2]});
    fine.add_face({a, b, c});
  }
  return fine;
}

std::optional<Mesh> read_fine(const std::filesystem::path& file) {
  try {
    PolygonSoup soup = triangulated(to_mesh(read_mesh_source(read_file(file.string()), file.string())).soup());
    if (soup.num_faces() < kCoarse) return {};
    while (soup.num_faces() < kFine) soup = refined(soup);
    return Mesh(std::move(soup));
  } catch (const Error& error) {
    fmt::print("left out: {}: {}\n", file.stem().string(), error.what());
    return {};
  }
}

void row(Table& table, const std::string& name, const Mesh& mesh) {
  const auto start = std::chrono::steady_clock::now();
  const SimplifiedMesh simple = simplify_mesh(mesh, kept_sharp(kCoarse));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  table.row({name, mesh.num_faces(), simple.mesh.num_faces(), 100 * simple.distance / diagonal(mesh), simple.crossings,
             simple.symmetric ? "yes" : "no", seconds.count()});
}

int bench(const Arguments& args) {
  Table table("simplified to 300", {"mesh", "faces", "left", "strays %", "new crossings", "left = right", "s"});
  for (const char* animal : {"bird", "dog", "fish", "dinosaur"})
    row(table, animal, Mesh(make_shape(animal, {.faces = kFine})));
  int files = 0;
  for (const auto& file : mesh_files(args.meshes)) {
    if (files == kMostFiles) break;
    const std::optional<Mesh> mesh = read_fine(file);
    if (!mesh) continue;
    row(table, file.stem().string(), *mesh);
    ++files;
  }
  write_json(args, {&table});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) { return plico::bench::bench(plico::bench::arguments(argc, argv)); }
