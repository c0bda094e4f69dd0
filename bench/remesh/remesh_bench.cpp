// Convex remeshing ([Xi17] 5.4, fig. 5.16): how few triangles and how fat ones a growth of the shells allows.
// usage: bench_remesh [--meshes DIR] [--json FILE] [--figure FILE.svg] [--quick] (DIR: OBJ files, as for bench_shell)
#include <cmath>
#include <fstream>
#include <iterator>

#include "figure.h"
#include "plico/base/rng.h"
#include "plico/convex/shape_parts.h"
#include "plico/io/mesh/face_groups.h"
#include "plico/io/mesh/obj.h"
#include "plico/workflow/shell_shape.h"
#include "plot.h"
#include "table.h"

namespace {

using namespace plico;

struct NamedShells {
  std::string name;
  Shells shells;
};

// Random points on ellipsoids: hulls of about 1,000 triangles of all shapes, as the dissertation starts from. The
// second shape has two that overlap, and so a contact.
ShapePart ellipsoid(const std::string& name, const Vec3& axes, const Vec3& center, std::uint64_t seed) {
  Rng rng(seed);
  ShapePart part{name, {}};
  for (int i = 0; i < 502; ++i) {
    Vec3 p;
    for (double& x : p) x = rng.normal();
    part.points.push_back(center + axes.cwiseProduct(p.normalized()));
  }
  return part;
}

std::vector<NamedShells> own_shapes() {
  return {{"ball", disjoint_shells({ellipsoid("ball", {1, 1, 1}, {0, 0, 0}, 1)})},
          {"egg", disjoint_shells({ellipsoid("egg", {1, 1, 2}, {0, 0, 0}, 2)})},
          {"two balls",
           disjoint_shells({ellipsoid("a", {1, 1, 1}, {0, 0, 0}, 3), ellipsoid("b", {1, 1.2, 1}, {1.2, 0, 0}, 4)})}};
}

std::vector<NamedShells> composite_shells(const std::string& folder) {
  std::vector<NamedShells> result;
  for (const std::filesystem::path& path : bench::mesh_files(folder)) {
    if (path.extension() != ".obj") continue;
    std::ifstream in(path);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const PolygonSoup soup = read_obj(bytes, path.string()).soup;
    std::vector<ShapePart> parts = parts_by_components(soup);
    if (has_obj_groups(bytes)) {
      const FaceGroups groups = read_obj_groups(bytes, path.string());
      parts = parts_by_groups(soup, groups.of_face, groups.names);
    }
    result.push_back({path.stem().string(), disjoint_shells(parts)});
  }
  return result;
}

struct Sums {
  int triangles_before = 0, triangles = 0, solves = 0;
  double volume_before = 0, volume = 0;
};

Sums sums_of(const Remeshing& remeshing) {
  Sums sums;
  for (const RemeshedShell& change : remeshing.changes) {
    sums.triangles_before += change.triangles_before;
    sums.triangles += change.triangles;
    sums.solves += change.solves;
    sums.volume_before += change.volume_before;
    sums.volume += change.volume;
  }
  return sums;
}

int invalid = 0;

void row(bench::Table& table, const NamedShells& named, const RemeshOptions& options) {
  JudgedRemeshing judged;
  Remeshing timed;
  const double seconds = bench::seconds([&] { timed = remesh(named.shells, options); });
  judged = remesh_shells(named.shells, options, {});
  const Sums sums = sums_of(judged.remeshing);
  invalid += judged.verdict.valid() ? 0 : 1;
  table.row({named.name, 100 * options.max_growth, sums.triangles_before, sums.triangles,
             100 * (sums.volume / sums.volume_before - 1), judged.remeshing.fatness_before, judged.remeshing.fatness,
             100 * (judged.remeshing.fatness / judged.remeshing.fatness_before - 1),
             judged.verdict.valid() ? "yes" : "no", 1e3 * seconds, 1e6 * seconds / std::max(1, sums.solves)});
}

std::vector<std::string> columns() {
  return {"shape", "cap %", "triangles", "after", "volume %", "fatness", "after", "+ %", "valid", "ms", "us a solve"};
}

// Fig. 5.16 of one shape.
void curves(bench::Plot& plot, bench::Table& table, const NamedShells& named, bool quick) {
  for (double cap : {0.01, 0.1, 1.0, 10.0}) {
    bench::Curve curve{fmt::format("{}, {:g} %", named.name, 100 * cap), {}};
    for (int rounds : {0, 1, 2, 5, 10, 20, 50, 100}) {
      if (quick && rounds > 5) break;
      const Remeshing remeshing = remesh(named.shells, {.regularize = rounds, .max_growth = cap});
      curve.points.emplace_back(rounds, remeshing.fatness);
      table.row({named.name, 100 * cap, rounds, remeshing.fatness});
    }
    plot.add(std::move(curve));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string figure = bench::figure_of(argc, argv);
  const bench::Arguments arguments = bench::arguments(argc, argv);
  std::vector<NamedShells> shapes = own_shapes();
  for (NamedShells& named : composite_shells(arguments.meshes)) shapes.push_back(std::move(named));
  bench::Table fewer("Fewer triangles: edges shrink as far as the cap allows", columns());
  for (const NamedShells& named : shapes)
    for (double cap : {0.01, 0.05, 0.1}) row(fewer, named, {.faces = 4, .max_growth = cap});
  bench::Table fatter("\nFatter triangles: 30 rounds ([Xi17] fig. 5.16: at least + 25 % at 10 %)", columns());
  for (const NamedShells& named : shapes) row(fatter, named, {.regularize = 30, .max_growth = 0.1});
  fmt::print("{} results not valid\n", invalid);
  bench::Plot plot("Fatness after rounds of regularization ([Xi17] fig. 5.16)", "rounds", "weighted mean fatness");
  bench::Table rounds("\nFig. 5.16", {"shape", "cap %", "rounds", "fatness"});
  curves(plot, rounds, shapes[0], arguments.quick);
  curves(plot, rounds, shapes[2], arguments.quick);
  plot.write(figure);
  bench::write_json(arguments, {&fewer, &fatter, &rounds});
  return 0;
}
