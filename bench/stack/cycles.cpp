// Hamiltonian cycles of voxel shells: the sizes of the dissertation's table 6.1 beside its seconds, and growth; then
// stacks (stacks.cpp).
//   bench_stack [--meshes DIR] [--json FILE] [--quick]
#include <algorithm>

#include "plico/io/mesh/mesh_file.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/voxel_mesh.h"
#include "tables.h"

namespace plico::bench {
namespace {

using nlohmann::json;

const std::vector<std::string> kCycleColumns{"model",    "squares",   "found",     "of",      "voxelize s",
                                             "median s", "slowest s", "us/square", "[Xi17] s"};

// One search a seed; every cycle is judged.
Table::Row row(const std::string& model, const PolygonSoup& soup, const Resolution& resolution, int seeds,
               const json& dissertation = nullptr) {
  VoxelMesh mesh;
  const double voxels = seconds([&] { mesh = voxel_mesh(soup, resolution); });
  std::vector<double> times;
  int found = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    JudgedCycle cycle;
    const double judging = seconds([&] { cycle = judged_cycle(mesh, {.seed = std::uint64_t(seed)}); });
    const double search = seconds([&] { find_hamiltonian_cycle(mesh.shell, {.seed = std::uint64_t(seed)}); });
    times.push_back(std::min(judging, search));
    found += cycle.found.ending == Ending::Found && cycle.verdict.valid();
  }
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  return {model,       mesh.shell.size(), found, seeds, voxels, median, times.back(), 1e6 * median / mesh.shell.size(),
          dissertation};
}

Table sizes_of_table_6_1() {
  struct Size {
    int squares;
    double dissertation;
    const char* model;
  };
  Table table("Sizes of table 6.1, own models", kCycleColumns);
  for (const Size& size : {Size{32, 0.01, "torus"}, Size{462, 0.59, "bird"}, Size{1964, 3.68, "dog"},
                           Size{2206, 2.50, "dinosaur"}, Size{4396, 5.41, "fish"}})
    table.row(row(size.model, make_shape(size.model), {.squares = size.squares}, 10, size.dissertation));
  return table;
}

Table growth(bool quick) {
  Table table("Growth", kCycleColumns);
  for (double cells : quick ? std::vector<double>{100} : std::vector<double>{30, 100, 300, 1000})
    table.row(row("dinosaur", make_shape("dinosaur"), {.cells = cells}, 3));
  return table;
}

Table meshes(const std::string& folder) {
  Table table("Meshes, 60 cells", kCycleColumns);
  for (const auto& path : mesh_files(folder))
    table.row(row(path.stem().string(), read_mesh_file(path.string()).soup, {.cells = 60}, 10));
  return table;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  using namespace plico::bench;
  const Arguments args = arguments(argc, argv);
  std::vector<Table> tables;
  tables.push_back(sizes_of_table_6_1());
  tables.push_back(growth(args.quick));
  if (!args.meshes.empty()) tables.push_back(meshes(args.meshes));
  for (Table& table : stack_tables(args.meshes, args.quick)) tables.push_back(std::move(table));
  tables.push_back(motions(args.meshes, args.quick));
  std::vector<const Table*> all;
  for (const Table& table : tables) all.push_back(&table);
  write_json(args, all);
}
