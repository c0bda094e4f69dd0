// Hamiltonian cycles of voxel shells.
#include <sys/resource.h>

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

struct Cycles {
  int squares = 0, found = 0, seeds = 0;
  double voxels = 0, median = 0, slowest = 0;  // seconds
  bool all() const { return found == seeds; }
  double slowest_us() const { return 1e6 * slowest / squares; }
};

bool is_judged(const VoxelMesh& mesh, const CycleResult& found) {
  std::vector<ShellSquare> walk;
  for (int s : found.cycle) walk.push_back(mesh.shell.squares[s]);
  return found.ending == Ending::Found && verify_shell_cycle(mesh.solid.grid, mesh.pairing, walk).valid();
}

// One search a seed, 1 and on; every cycle is judged.
Cycles cycles_of(Table& table, const std::string& model, const PolygonSoup& soup, const Resolution& resolution,
                 int seeds, const json& dissertation = nullptr) {
  VoxelMesh mesh;
  Cycles cycles{.seeds = seeds};
  cycles.voxels = seconds([&] { mesh = voxel_mesh(soup, resolution); });
  cycles.squares = mesh.shell.size();
  std::vector<double> times;
  for (int seed = 1; seed <= seeds; ++seed) {
    CycleResult found;
    times.push_back(seconds([&] { found = find_hamiltonian_cycle(mesh.shell, {.seed = std::uint64_t(seed)}); }));
    cycles.found += is_judged(mesh, found);
  }
  std::sort(times.begin(), times.end());
  cycles.median = times[times.size() / 2];
  cycles.slowest = times.back();
  table.row({model, cycles.squares, cycles.found, seeds, cycles.voxels, cycles.median, cycles.slowest,
             1e6 * cycles.median / cycles.squares, dissertation});
  return cycles;
}

// Eight voxels around a hole: 32 squares.
PolygonSoup donut() {
  PolygonSoup soup;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) {
      if (x == 1 && y == 1) continue;
      const int first = soup.num_points();
      for (const auto& [dx, dy] : {std::pair{0.3, 0.3}, {0.7, 0.3}, {0.3, 0.7}})
        soup.points.push_back({x + dx, y + dy, 0.5});
      soup.add_face({first, first + 1, first + 2});
    }
  for (double corner : {0.0, 3.0}) {  // so that the voxels are the unit cubes
    const int first = soup.num_points();
    for (double step : {0.0, 0.01, 0.02}) soup.points.push_back({corner + (corner > 0 ? -step : step), corner, 0.5});
    soup.add_face({first, first + 1, first + 2});
  }
  return soup;
}

Table sizes_of_table_6_1(Goals& goals) {
  struct Size {
    int squares;
    double dissertation, goal_ms;
    const char* model;
  };
  Table table("Sizes of table 6.1, own models", kCycleColumns);
  for (const Size& size : {Size{32, 0.01, 1, "donut"}, Size{462, 0.59, 3, "bird"}, Size{1964, 3.68, 10, "dog"},
                           Size{2206, 2.50, 15, "dinosaur"}, Size{4396, 5.41, 30, "fish"}}) {
    const bool is_donut = size.squares == 32;
    const Cycles cycles =
        cycles_of(table, size.model, is_donut ? donut() : make_shape(size.model),
                  is_donut ? Resolution{.cells = 3} : Resolution{.squares = size.squares}, 10, size.dissertation);
    goals.add(fmt::format("table 6.1, {} squares", size.squares), fmt::format("{} ms", size.goal_ms),
              fmt::format("{} squares, {:.3g} ms (median of 10)", cycles.squares, 1e3 * cycles.median),
              cycles.all() && 1e3 * cycles.median <= size.goal_ms &&
                  std::abs(cycles.squares - size.squares) <= 0.02 * size.squares);
  }
  return table;
}

// The most memory that this program ever had, GB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e6;
}

Table growth(const StackBench& bench, Goals& goals) {
  Table table("Growth", kCycleColumns);
  Cycles last;
  bool all = true;
  double slowest = 0;
  for (double cells : bench.quick ? std::vector<double>{100} : std::vector<double>{30, 100, 300, 1000}) {
    last = cycles_of(table, "dinosaur", make_shape("dinosaur"), {.cells = cells}, 10);
    all = all && last.all();
    slowest = std::max(slowest, last.slowest_us());
  }
  goals.add("cycles of a dinosaur up to a million squares", "all of seeds 1-10, 10 us a square",
            fmt::format("{}, {:.3g} us at most", all ? "all" : "not all", slowest), all && slowest <= 10);
  if (last.squares < 500'000) return table;
  goals.add("cycle of a million squares", "10 s, 1 GB",
            fmt::format("{} squares, median {:.3g} s, {:.2g} GB with all", last.squares, last.median, peak_memory()),
            last.median <= 10 && peak_memory() <= 1);
  goals.add("voxelizing a million squares", "10 s", fmt::format("{:.3g} s", last.voxels), last.voxels <= 10);
  return table;
}

Table meshes(const StackBench& bench, Goals& goals) {
  Table table("Meshes and own shapes, about a thousand and 20,000 squares", kCycleColumns);
  int models = 0, complete = 0;
  double slowest = 0;
  const auto add = [&](const std::string& name, const PolygonSoup& soup) {
    for (int squares : bench.quick ? std::vector<int>{1000} : std::vector<int>{1000, 20'000}) {
      const Cycles cycles = cycles_of(table, name, soup, {.squares = squares}, 10);
      ++models;
      complete += cycles.all();
      slowest = std::max(slowest, cycles.slowest_us());
    }
  };
  for (const char* shape : {"bird", "fish", "dog", "torus"}) add(shape, make_shape(shape));
  for (const auto& path : mesh_files(bench.meshes)) add(path.stem().string(), read_mesh_file(path.string()).soup);
  goals.add("cycles of meshes and own shapes", "all of seeds 1-10, 10 us a square",
            fmt::format("{} of {} shells, {:.3g} us at most", complete, models, slowest),
            complete == models && slowest <= 10);
  return table;
}

}  // namespace

std::vector<Table> cycle_tables(const StackBench& bench, Goals& goals) {
  std::vector<Table> tables;
  tables.push_back(sizes_of_table_6_1(goals));
  tables.push_back(growth(bench, goals));
  tables.push_back(meshes(bench, goals));
  return tables;
}

}  // namespace plico::bench
