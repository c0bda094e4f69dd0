// The motion of stacked chains: how many shapes unpack, by thickness, proven.
#include <algorithm>

#include "plico/io/mesh/mesh_file.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/stack_motion.h"
#include "tables.h"

namespace plico::bench {
namespace {

const std::vector<std::string> kMotionColumns{"model", "panels", "t",      "layers", "ideal",
                                              "share", "chains", "proven", "plan s", "proof s"};

Table::Row row(const std::string& model, const PolygonSoup& soup, int squares, double thickness, double limit) {
  const VoxelMesh voxels = voxel_mesh(soup, {.squares = squares});
  const JudgedCycle cycle = judged_cycle(voxels, {});
  const StackMeshOptions stacking{.thickness = thickness};
  StackMotion motion;
  double plan = seconds([&] {
    const StackedChain first = stack_voxels(voxels, cycle.found.cycle, stacking);
    motion = unpack_stack(voxels, first, stacking, {}, limited({}, limit));
  });
  const double proof = seconds([&] { judge_chain_motion(motion.chain.claim, motion.path); });
  plan -= proof;
  return {model,
          motion.chain.verdict.panels,
          thickness,
          motion.chain.verdict.height,
          motion.chain.verdict.ideal,
          motion.share(),
          motion.chains,
          motion.ending == Ending::Found ? "yes"
          : motion.verdict.free()        ? "prefix"
                                         : "no",
          plan,
          proof};
}

}  // namespace

Table motions(const std::string& folder, bool quick) {
  Table table("From the stack to the shape, about 200 squares", kMotionColumns);
  const double limit = quick ? 10 : 60;
  for (double thickness : {0.001, 0.01, 0.05, 0.1, 0.2}) {
    for (const char* model : {"bird", "fish", "dinosaur"})
      table.row(row(model, make_shape(model), 200, thickness, limit));
    if (folder.empty()) continue;
    int seen = 0;
    for (const auto& path : mesh_files(folder)) {
      if (quick && seen++ % 8 != 0) continue;
      const std::string name = path.string();
      table.row(row(path.stem().string(), read_mesh_file(name).soup, 200, thickness, limit));
    }
  }
  return table;
}

}  // namespace plico::bench
