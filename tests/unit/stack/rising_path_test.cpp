#include "plico/stack/rising_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "plico/shapes/named_shapes.h"
#include "plico/workflow/voxel_mesh.h"
#include "voxel_samples.h"

namespace plico {
namespace {

struct Walk {
  VoxelMesh voxels;
  SquareGraph graph;
  std::vector<int> cycle;
};

Walk walk_of(const char* shape, double cells) {
  Walk walk{voxel_mesh(make_shape(shape), {.cells = cells}), {}, {}};
  walk.graph = graph_of(walk.voxels.shell);
  walk.cycle = judged_cycle(walk.voxels, {}).found.cycle;
  return walk;
}

TEST(RisingPath, VisitsEverySquareOnceAndRises) {
  const Walk walk = walk_of("icosahedron", 6);
  for (Upwards upwards : {Upwards::PlusZ, Upwards::MinusX}) {
    const std::vector<int> path = rising_path(walk.voxels.shell, walk.graph, walk.cycle, {.upwards = upwards});
    std::vector<int> sorted = path, all(walk.graph.size());
    std::ranges::sort(sorted);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
    EXPECT_NO_THROW(strip_headings(walk.graph, path));
    EXPECT_LT(places_astray(walk.voxels.shell, path, upwards), walk.graph.size() / 20.0);
    EXPECT_GT(places_astray(walk.voxels.shell, walk.cycle, upwards), walk.graph.size() / 20.0);
  }
}

TEST(RisingPath, TheSameSeedGivesTheSameWalk) {
  const Walk walk = walk_of("icosahedron", 4);
  const RisingOptions options{.seed = 5, .exchanges = 5000};
  EXPECT_EQ(rising_path(walk.voxels.shell, walk.graph, walk.cycle, options),
            rising_path(walk.voxels.shell, walk.graph, walk.cycle, options));
}

TEST(RisingPath, BeginsWithTheDirectionInWhichMostSquaresAreLow) {
  // A tower on a plate: the plate first.
  const VoxelShell shell =
      shell_of(voxels({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 0, 1}, {0, 0, 2}}));
  EXPECT_EQ(directions_to_rise(shell).front(), Upwards::PlusZ);
}

}  // namespace
}  // namespace plico
