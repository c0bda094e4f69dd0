// Stacks: the bases of the dissertation's table 6.2 and the best ones, layers against the least possible, and growth.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "plico/io/mesh/mesh_file.h"
#include "plico/shapes/named_shapes.h"
#include "plico/stack/chain.h"
#include "plico/workflow/stack_mesh.h"
#include "tables.h"

namespace plico::bench {
namespace {

using nlohmann::json;

const std::vector<std::string> kStackColumns{"model", "squares", "t", "base",  "layers",   "ideal",
                                             "C",     "volume",  "s", "slots", "[Xi17] C", "[Xi17] volume"};

struct Model {
  std::string name;
  VoxelMesh voxels;
  std::vector<int> cycle;
};

Model model_of(const std::string& name, const PolygonSoup& soup, const Resolution& resolution) {
  Model model{name, voxel_mesh(soup, resolution), {}};
  model.cycle = judged_cycle(model.voxels, {}).found.cycle;
  return model;
}

struct StackCase {
  double thickness = 0.1;
  int width = 0, depth = 0;  // 0: the best base
  double limit = 10;         // seconds
  json dissertation_c = nullptr, dissertation_volume = nullptr;
};

// One stack, judged; the layers above the ideal, or -1 without a stack.
int stack_row(Table& table, const Model& model, const StackCase& c, double* time_taken = nullptr,
              double* slots = nullptr) {
  if (model.cycle.empty()) return -1;
  StackedChain chain;
  const double time = seconds([&] {
    chain = stack_voxels(model.voxels, model.cycle, {.thickness = c.thickness, .width = c.width, .depth = c.depth},
                         limited({}, c.limit));
  });
  if (time_taken != nullptr) *time_taken = time;
  if (slots != nullptr) *slots = chain.slots_per_panel;
  const ChainVerdict& verdict = chain.verdict;
  table.row({model.name, verdict.panels, c.thickness, fmt::format("{}x{}", verdict.width, verdict.depth),
             verdict.valid() ? json(verdict.height) : json("wrong"), verdict.ideal, chain.compactness,
             chain.volume_ratio, time, chain.slots_per_panel, c.dissertation_c, c.dissertation_volume});
  return verdict.valid() ? verdict.height - verdict.ideal : -1;
}

// As many squares as the dissertation's bunny has; the bunny itself where it is there.
Model model_of_table_6_2(const std::string& meshes) {
  for (const auto& path : mesh_files(meshes))
    if (path.stem() == "bunny-348") return model_of("bunny", read_mesh_file(path.string()).soup, {.squares = 2206});
  return model_of("dinosaur", make_shape("dinosaur"), {.squares = 2206});
}

Table table_6_2(const StackBench& bench, Goals& goals) {
  const Model model = model_of_table_6_2(bench.meshes);
  Table table("Bases of table 6.2, and for every thickness the best one; 10 s each", kStackColumns);
  for (const StackCase& c :
       {StackCase{0.0001, 1, 1, 10, 0.0305, 5.7776e-5}, StackCase{0.001, 2, 2, 10, 0.0632, 5.7776e-4},
        StackCase{0.01, 4, 4, 10, 0.1173, 5.7776e-3}, StackCase{0.1, 8, 8, 10, 0.3024, 5.7776e-2},
        StackCase{0.2, 10, 10, 10, 0.3780, 1.1284e-1}}) {
    for (const StackCase& one : {c, StackCase{.thickness = c.thickness}}) {
      double time = 0;
      const int above = stack_row(table, model, one, &time);
      goals.add(fmt::format("table 6.2, t = {}, base {}", c.thickness,
                            one.width > 0 ? fmt::format("{0}x{0}", c.width) : "best"),
                "ideal layers, 10 s", fmt::format("{} above, {:.2g} s", above, time), above == 0 && time <= 10);
    }
  }
  return table;
}

Table many_meshes(const StackBench& bench, Goals& goals) {
  Table table("Meshes at 500 to 5000 squares, best base, 10 s each", kStackColumns);
  int rows = 0, ideal = 0, most_above = 0;
  const auto add = [&](const std::string& name, const PolygonSoup& soup, int squares) {
    const Model model = model_of(name, soup, {.squares = squares});
    for (double thickness : {0.01, 0.1, 0.2}) {
      const int above = stack_row(table, model, {.thickness = thickness});
      if (above < 0) continue;
      ++rows;
      ideal += above == 0;
      most_above = std::max(most_above, above);
    }
  };
  const std::vector<int> sizes = bench.quick ? std::vector<int>{500} : std::vector<int>{500, 1500, 5000};
  std::size_t next = 0;  // size; one a mesh, in turn
  for (const char* shape : {"bird", "fish", "dinosaur"}) add(shape, make_shape(shape), sizes[next++ % sizes.size()]);
  for (const auto& path : mesh_files(bench.meshes))
    add(path.stem().string(), read_mesh_file(path.string()).soup, sizes[next++ % sizes.size()]);
  goals.add("compactness, meshes at 500-5000 squares", "ideal on 80 %, else 1 above",
            fmt::format("ideal on {} of {}, at most {} above", ideal, rows, most_above),
            most_above <= 1 && 5 * ideal >= 4 * rows);
  return table;
}

Table stack_growth(const StackBench& bench, Goals& goals) {
  Table table("Growth, t = 0.1, base near the cube root of t n, 60 s each", kStackColumns);
  for (int squares : bench.quick ? std::vector<int>{10'000} : std::vector<int>{10'000, 100'000, 1'000'000}) {
    const int side = static_cast<int>(std::lround(std::cbrt(0.1 * squares)));
    const Model model = model_of("dinosaur", make_shape("dinosaur"), {.squares = squares});
    double time = 0, slots = 0;
    const int above =
        stack_row(table, model, {.thickness = 0.1, .width = side, .depth = side, .limit = 60}, &time, &slots);
    goals.add(fmt::format("stack of {} squares", squares), "1.05 slots a panel in 60 s",
              fmt::format("{:.4g} slots, {} layers above, {:.3g} s", slots, above, time),
              above >= 0 && slots <= 1.05 && time <= 65);
  }
  return table;
}

// Walks through every square of a shell, each strip of turns once.
std::set<Headings> all_strips(const VoxelShell& shell) {
  std::set<Headings> strips;
  std::vector<int> path;
  const std::function<void(int)> go = [&](int at) {
    path.push_back(at);
    if (static_cast<int>(path.size()) == shell.size()) strips.insert(chain_of(shell, path).headings);
    for (int next : shell.squares[at].neighbor)
      if (std::find(path.begin(), path.end(), next) == path.end()) go(next);
    path.pop_back();
  };
  for (int s = 0; s < shell.size(); ++s) go(s);
  return strips;
}

// The fewest layers of all stacks of all chains, by exhaustion, against what the same exhaustion found elsewhere.
Table small_shells(Goals& goals) {
  struct Base {
    int width, depth, layers;
  };
  Table table("Small shells: fewest layers of all stacks of all chains", {"shell", "base", "layers", "oracle", "s"});
  int right = 0, rows = 0;
  const auto add = [&](const char* name, const std::vector<Voxel>& solid, const std::vector<Base>& bases) {
    VoxelGrid grid(4, 4, 4);
    for (const Voxel& voxel : solid) grid.fill(voxel);
    const std::set<Headings> strips = all_strips(shell_of(grid));
    for (const Base& base : bases) {
      int least = static_cast<int>(strips.begin()->size()) + 2;
      const double time = seconds([&] {
        for (const Headings& strip : strips)
          least = std::min(least, least_layers(strip, base.width, base.depth, least - 1));
      });
      table.row({name, fmt::format("{}x{}", base.width, base.depth), least, base.layers, time});
      ++rows;
      right += least == base.layers;
    }
  };
  add("cube", {{0, 0, 0}}, {{1, 2, 3}, {1, 3, 2}, {2, 3, 2}, {2, 5, 1}, {3, 4, 1}});
  add("domino", {{0, 0, 0}, {1, 0, 0}}, {{1, 3, 4}, {2, 2, 3}, {2, 5, 2}, {2, 8, 1}, {3, 6, 1}});
  goals.add("small shells", "exact optimum, proven", fmt::format("{} of {} bases as the oracle", right, rows),
            right == rows);
  return table;
}

}  // namespace

std::vector<Table> stack_tables(const StackBench& bench, Goals& goals) {
  std::vector<Table> tables;
  tables.push_back(table_6_2(bench, goals));
  tables.push_back(small_shells(goals));
  tables.push_back(many_meshes(bench, goals));
  return tables;
}

std::vector<Table> large_stack_tables(const StackBench& bench, Goals& goals) {
  std::vector<Table> tables;
  tables.push_back(stack_growth(bench, goals));
  return tables;
}

}  // namespace plico::bench
