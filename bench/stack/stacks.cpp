// Stacks: the bases of the dissertation's table 6.2 and the best ones, layers against the least possible, and growth.
#include <cmath>

#include "plico/io/mesh/mesh_file.h"
#include "plico/shapes/named_shapes.h"
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
int stack_row(Table& table, const Model& model, const StackCase& c) {
  if (model.cycle.empty()) return -1;
  StackedChain chain;
  const double time = seconds([&] {
    chain = stack_voxels(model.voxels, model.cycle, {.thickness = c.thickness, .width = c.width, .depth = c.depth},
                         limited({}, c.limit));
  });
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

Table table_6_2(const std::string& meshes) {
  const Model model = model_of_table_6_2(meshes);
  Table table("Bases of table 6.2, and for every thickness the best one; 10 s each", kStackColumns);
  for (const StackCase& c :
       {StackCase{0.0001, 1, 1, 10, 0.0305, 5.7776e-5}, StackCase{0.001, 2, 2, 10, 0.0632, 5.7776e-4},
        StackCase{0.01, 4, 4, 10, 0.1173, 5.7776e-3}, StackCase{0.1, 8, 8, 10, 0.3024, 5.7776e-2},
        StackCase{0.2, 10, 10, 10, 0.3780, 1.1284e-1}}) {
    stack_row(table, model, c);
    stack_row(table, model, {.thickness = c.thickness});
  }
  return table;
}

Table many_meshes(const std::string& folder, bool quick) {
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
  const std::vector<int> sizes = quick ? std::vector<int>{500} : std::vector<int>{500, 1500, 5000};
  std::size_t next = 0;  // size; one a mesh, in turn
  for (const char* shape : {"bird", "fish", "dinosaur"}) add(shape, make_shape(shape), sizes[next++ % sizes.size()]);
  for (const auto& path : mesh_files(folder))
    add(path.stem().string(), read_mesh_file(path.string()).soup, sizes[next++ % sizes.size()]);
  fmt::print("{} of {} with the ideal layers, at most {} above\n", ideal, rows, most_above);
  return table;
}

Table stack_growth(bool quick) {
  Table table("Growth, t = 0.1, base near the cube root of t n, 60 s each", kStackColumns);
  for (int squares : quick ? std::vector<int>{10'000} : std::vector<int>{10'000, 100'000, 1'000'000}) {
    const int side = static_cast<int>(std::lround(std::cbrt(0.1 * squares)));
    const Model model = model_of("dinosaur", make_shape("dinosaur"), {.squares = squares});
    stack_row(table, model, {.thickness = 0.1, .width = side, .depth = side, .limit = 60});
  }
  return table;
}

}  // namespace

std::vector<Table> stack_tables(const std::string& meshes, bool quick) {
  std::vector<Table> tables;
  tables.push_back(table_6_2(meshes));
  tables.push_back(many_meshes(meshes, quick));
  tables.push_back(stack_growth(quick));
  return tables;
}

}  // namespace plico::bench
