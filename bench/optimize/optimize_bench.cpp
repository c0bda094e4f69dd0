// How much smaller and less cut a net becomes ([Xi17] 5.5: hull area -41 %, cut length -50 % from the first net).
// The first net is the best steepest-edge tree of 20 directions, or, where all of them overlap, our search's way out of
// steepest-edge trees. Bounds: no hull is smaller than the surface, and no net of the mesh is cut by more than this
// much less. usage: bench_optimize [--meshes DIR] [--json FILE] [--quick]
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/check.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/creature.h"
#include "plico/unfold/classic.h"
#include "plico/unfold/optimize.h"
#include "plico/unfold/search.h"
#include "plico/verify/net.h"
#include "table.h"

#include <optional>

namespace {

using namespace plico;
using nlohmann::json;

std::optional<FoldForest> first_net(const Mesh& mesh) {
  ClassicResult classic = classic_net(mesh);
  if (classic.ending == Ending::Found) return std::move(classic.forest);
  SearchResult found = find_net(mesh, {.starts = 1, .grow_by = Heuristic::SteepestEdge}, limited({}, 20));
  if (found.ending == Ending::Found) return std::move(found.forest);
  return std::nullopt;
}

struct Gain {
  double first, ours, seconds;
  bool verified;
  double percent() const { return 100 * (1 - ours / first); }
};

Gain gain(const Mesh& mesh, const FoldForest& net, const char* wish, double NetFeatures::*feature) {
  OptimizeResult result;
  const OptimizeOptions options{.weights = weights_for(wish)};
  const double seconds = bench::seconds([&] { result = optimize_net(mesh, net, options, Run{.threads = 2}); });
  const bool verified = verify_net(lay_flat(mesh, result.forest), mesh).is_net();
  return {result.before.*feature, result.after.*feature, seconds, verified};
}

struct Tally {
  int meshes = 0, hull = 0, hull_possible = 0, cut = 0, cut_possible = 0;
};

void add_row(bench::Table& table, Tally& tally, const std::string& name, const Mesh& mesh) {
  if (components(mesh).count != 1) return;
  const std::optional<FoldForest> net = first_net(mesh);
  if (!net) return;
  const Gain hull = gain(mesh, *net, "hull-area", &NetFeatures::hull_area);
  const Gain cut = gain(mesh, *net, "cut-length", &NetFeatures::cut_length);
  const double hull_bound = 100 * (1 - surface_area(mesh) / hull.first);
  const double cut_bound = 100 * (1 - least_cut_length(mesh) / cut.first);
  table.row({name, mesh.num_faces(), hull.first, hull.ours, hull.percent(), hull_bound, hull.seconds, cut.first,
             cut.ours, cut.percent(), cut_bound, cut.seconds, hull.verified && cut.verified ? "yes" : "NO"});
  ++tally.meshes;
  tally.hull += hull.percent() >= 41;
  tally.hull_possible += hull_bound >= 41;
  tally.cut += cut.percent() >= 50;
  tally.cut_possible += cut_bound >= 50;
}

}  // namespace

int main(int argc, char** argv) {
  const bench::Arguments arguments = bench::arguments(argc, argv);
  bench::Table table("net optimization", {"mesh", "faces", "first hull", "hull", "hull -%", "hull bound -%", "hull s",
                                          "first cut", "cut", "cut -%", "cut bound -%", "cut s", "verified"});
  Tally tally;
  for (Animal animal : kAnimals)
    for (int faces : {300, 1000})
      if (faces == 300 || !arguments.quick)
        add_row(table, tally, fmt::format("{}-{}", name(animal), faces),
                Mesh(creature({.animal = animal, .faces = faces})));
  for (const auto& file : bench::mesh_files(arguments.meshes)) {
    std::optional<Mesh> mesh;
    try {
      mesh = load_mesh(file);
    } catch (const std::exception& error) {
      fmt::print("{}: {}\n", file.filename().string(), error.what());
      continue;
    }
    add_row(table, tally, file.filename(), *mesh);
  }
  fmt::print(
      "{} meshes; hull area less by 41 % or more: {} (possible on at most {}); cut length less by 50 % or more: {} "
      "(possible on at most {})\n",
      tally.meshes, tally.hull, tally.hull_possible, tally.cut, tally.cut_possible);
  bench::write_json(arguments, {&table});
  return 0;
}
