// Nets with proven motions, beside the dissertation's tables 4.1 and 4.2, and valid ratios of samples beside
// figure 4.6.
//   bench_motion --meshes DIR [--json FILE] [--quick]
#include <map>
#include <thread>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/mesh/measures.h"
#include "plico/motion/collision.h"
#include "plico/motion/planner.h"
#include "plico/shapes/named_shapes.h"
#include "plico/unfold/search.h"
#include "plico/workflow/foldable_net.h"
#include "table.h"

namespace plico::bench {
namespace {

constexpr double kLimit = 60;  // seconds a mesh and seed
constexpr int kSamples = 100;  // states of a plain check

// Net and path planning of the undivided mesh, seconds ([Xi17] tables 4.1 and 4.2; its fish has 474 faces).
const std::map<std::string, std::string> kPrinted = {{"bunny-128", "8.09 + 482.57"},
                                                     {"fish-950", "69.66 + 1848.86 (474 faces)"},
                                                     {"horse-312", "219.87 + none in 3600"}};

nlohmann::json printed(const std::string& name) {
  const auto at = kPrinted.find(name);
  return at == kPrinted.end() ? nlohmann::json() : nlohmann::json(at->second);
}

Mesh load(const std::filesystem::path& file) { return to_mesh(read_mesh_source(read_file(file), file)); }

double sampling_seconds(const Linkage& linkage, const FoldingPath& path) {
  CollisionChecker checker(linkage);
  return seconds([&] {
    for (int i = 0; i < kSamples; ++i) checker.collisions(path.at((i + 0.5) / kSamples));
  });
}

void foldable_row(Table& table, const std::string& name, const Mesh& mesh, std::uint64_t seed) {
  Run run;
  run.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  FoldableNetOptions options;
  options.seed = seed;
  FoldableNet found;
  const double search = seconds([&] { found = find_foldable_net(mesh, options, limited(run, kLimit)); });
  const Linkage linkage = linkage_of(lay_flat(mesh, found.tree));
  PathProof proof;
  const double proving = seconds([&] { proof = prove_path(linkage, found.path); });
  const double sampling = sampling_seconds(linkage, found.path);
  table.row({name, seed, mesh.num_faces(), std::string(plico::name(found.ending)), search, found.steps, proving,
             proving / sampling, proof.pair_intervals, printed(name)});
}

void ratio_row(Table& table, const std::string& name, const Mesh& mesh, int samples) {
  const Linkage linkage = linkage_of(lay_flat(mesh, find_net(mesh).forest));
  const ValidRatio ratio = valid_ratio(linkage, samples);
  table.row({name, linkage.num_hinges(), ratio.discrete, ratio.uniform});
}

// The project's own animals, and what the folder holds of usable meshes of up to 500 faces or in the dissertation's
// tables.
std::vector<std::pair<std::string, Mesh>> all_meshes(const Arguments& args) {
  std::vector<std::pair<std::string, Mesh>> meshes;
  for (const char* animal : {"bird", "dog", "fish", "dinosaur"})
    meshes.emplace_back(fmt::format("{} 300", animal), Mesh(make_shape(animal, {.faces = 300})));
  for (const auto& file : mesh_files(args.meshes)) {
    const std::string name = file.stem();
    try {
      Mesh mesh = load(file);
      const bool wanted = mesh.num_faces() <= 500 || kPrinted.count(name) > 0;
      if (wanted && mesh.num_faces() > 1 && components(mesh).count == 1) meshes.emplace_back(name, std::move(mesh));
    } catch (const Error& error) {
      fmt::print("left out: {}: {}\n", name, error.what());
    }
  }
  return meshes;
}

int bench(const Arguments& args) {
  const auto meshes = all_meshes(args);
  Table nets("One-piece nets with a proven linear motion",
             {"mesh", "seed", "faces", "ending", "search s", "steps", "proof s", "proof / 100 samples",
              "pair intervals", "[Xi17] net + path s"});
  for (const auto& [name, mesh] : meshes)
    for (std::uint64_t seed = 1; seed <= (args.quick ? 1U : 3U); ++seed) foldable_row(nets, name, mesh, seed);
  Table ratios("Fraction of sampled configurations without collision ([Xi17] fig. 4.6)",
               {"mesh", "folds", "discrete", "uniform"});
  for (const auto& [name, mesh] : meshes) ratio_row(ratios, name, mesh, args.quick ? 200 : 2000);
  write_json(args, {&nets, &ratios});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) { return plico::bench::bench(plico::bench::arguments(argc, argv)); }
