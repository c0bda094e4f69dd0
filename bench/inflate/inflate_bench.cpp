// Dents popped up ([Xi17] 4.4.1, fig. 4.11): hyperbolic vertices that are left when the volume may change by so much,
// and what that is worth to those who unfold and fold. usage: bench_inflate [--meshes DIR] [--json FILE] [--figure
// FILE.svg]
// [--quick]
#include <cmath>

#include "figure.h"
#include "plico/base/error.h"
#include "plico/inflate/inflate.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/creature.h"
#include "plico/unfold/evolve.h"
#include "plico/unfold/search.h"
#include "plico/verify/inflation.h"
#include "plico/workflow/foldable_net.h"
#include "plot.h"
#include "table.h"

namespace {

using namespace plico;

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

// Closed triangle meshes with more than a fifth of their vertices hyperbolic, as the goal asks for.
bool has_dents(const Mesh& mesh) {
  for (FaceId f : mesh.faces())
    if (mesh.degree(f) != 3) return false;
  return is_closed(mesh) && volume(mesh) > 0 && 5 * count_hyperbolic(mesh) > mesh.num_vertices();
}

std::vector<NamedMesh> dented_meshes(const std::string& folder) {
  std::vector<NamedMesh> result;
  for (Animal animal : {Animal::Bird, Animal::Dog})
    result.push_back(
        {animal == Animal::Bird ? "our bird" : "our dog", Mesh(creature({.animal = animal, .faces = 300}))});
  for (const std::filesystem::path& path : bench::mesh_files(folder)) {
    try {
      const Mesh mesh(read_mesh_source(read_file(path.string()), path.string()).soup);
      if (has_dents(mesh)) result.push_back({path.stem().string(), mesh});
    } catch (const InvalidInput&) {
      continue;  // no manifold: repairing is no part of this
    }
  }
  return result;
}

Mesh moved(const Mesh& mesh, const std::vector<Vec3>& points) {
  PolygonSoup soup = mesh.soup();
  soup.points = points;
  return Mesh(std::move(soup));
}

void all_meshes(bench::Table& table, const std::vector<NamedMesh>& meshes) {
  int halved = 0, invalid = 0;
  for (const auto& [name, mesh] : meshes) {
    Inflation result;
    const double seconds = bench::seconds([&] { result = inflate(mesh); });
    const InflationVerdict verdict = verify_inflation(mesh, moved(mesh, result.points).soup(), {}, 0.05);
    halved += 2 * verdict.hyperbolic <= verdict.hyperbolic_before;
    invalid += verdict.valid() ? 0 : 1;
    table.row({name, mesh.num_vertices(), verdict.hyperbolic_before, verdict.hyperbolic, degrees(result.excess_before),
               degrees(result.excess), 100 * verdict.growth, 100 * result.largest_move() / diagonal(mesh),
               result.flattening, std::string(plico::name(result.limit)), verdict.valid() ? "yes" : "no", seconds});
  }
  fmt::print("{} of {} meshes lose at least half of their hyperbolic vertices; {} results not valid\n", halved,
             meshes.size(), invalid);
}

// Fig. 4.11 of one mesh: what each volume allowed brings, and the time that nets and motions then take.
void curve(bench::Table& table, bench::Plot& plot, const NamedMesh& named, bool quick) {
  const auto& [name, mesh] = named;
  bench::Curve curve{name, {}};
  for (double growth : {0.0, 0.01, 0.02, 0.05, 0.1, 0.2}) {
    const Mesh now = growth > 0 ? moved(mesh, inflate(mesh, {.max_growth = growth}).points) : mesh;
    const int left = count_hyperbolic(now);
    curve.points.emplace_back(100 * growth, 100.0 * left / mesh.num_vertices());
    bench::Table::Row row = {name, 100 * growth, left};
    const auto timed = [&](auto&& search) {
      bool found = false;
      const double seconds = bench::seconds([&] { found = search() == Ending::Found; });
      row.insert(row.end(), {1e3 * seconds, found ? "yes" : "no"});
    };
    timed([&] { return evolve_net(now, {.max_generations = quick ? 20 : 500}).ending; });
    timed([&] { return find_net(now).ending; });
    timed([&] { return find_foldable_net(now, {.max_steps = quick ? 2000 : 0}).ending; });
    table.row(std::move(row));
  }
  plot.add(std::move(curve));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string figure = bench::figure_of(argc, argv);
  const bench::Arguments arguments = bench::arguments(argc, argv);
  const std::vector<NamedMesh> meshes = dented_meshes(arguments.meshes);
  bench::Table all("Closed meshes with more than 20 % hyperbolic vertices, the volume may change by 5 %",
                   {"mesh", "vertices", "before", "after", "excess deg", "after", "volume %", "move %", "flatten",
                    "stopped by", "valid", "s"});
  all_meshes(all, meshes);
  bench::Table curves("\nFig. 4.11: hyperbolic vertices, and the time of EU, of our search, of one that folds linearly",
                      {"mesh", "allowed %", "left", "EU ms", "net", "ours ms", "net", "linear ms", "motion"});
  bench::Plot plot("Hyperbolic vertices against the change of volume allowed", "change of volume allowed, %",
                   "hyperbolic vertices, % of all");
  for (const NamedMesh& named : meshes)
    if (named.name.starts_with("our") || named.name == "moneybox-392" || named.name == "bunny-348" ||
        named.name == "horse-312" || named.name == "fish-950" || named.name == "cat-702")
      curve(curves, plot, named, arguments.quick);
  plot.write(figure);
  bench::write_json(arguments, {&all, &curves});
  return 0;
}
