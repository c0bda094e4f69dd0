#include "plico/unfold/count_cuts.h"

#include <gtest/gtest.h>

#include "mesh_samples.h"
#include "plico/mesh/measures.h"
#include "plico/unfold/search.h"
#include "triangle_sheet.h"

namespace plico {
namespace {

// Bent like z = x y, so that all inner vertices are hyperbolic.
Mesh saddle(int n) {
  return triangle_sheet(n, [n](int x, int y) { return (x - n / 2.0) * (y - n / 2.0) / n; });
}

TEST(CountCuts, ASaddleHasNoNetWhateverItsSize) {
  for (int n : {2, 5, 30}) {
    const Mesh mesh = saddle(n);
    const long inner = static_cast<long>(n - 1) * (n - 1);
    for (VertexId v : mesh.vertices()) {
      if (is_boundary(mesh, v)) continue;
      ASSERT_TRUE(is_hyperbolic(mesh, v));
    }
    const CutCount count = count_cuts(mesh);
    EXPECT_EQ(count.cut_ends, 2 * inner);  // as many cuts as inner vertices, for a disc
    EXPECT_GT(count.needed, 2 * inner);
    EXPECT_TRUE(count.refutes());
    EXPECT_TRUE(find_net(mesh).proven_impossible);
  }
}

TEST(CountCuts, ShapesWithANetAreNotRefuted) {
  for (std::uint64_t seed : {1, 2, 3}) {
    const Mesh mesh = bumpy_sphere(2, 0.1, seed);
    const CutCount count = count_cuts(mesh);
    EXPECT_EQ(count.cut_ends, 2 * (mesh.num_vertices() - 1));  // the cuts are a tree on the vertices
    EXPECT_FALSE(count.refutes());
    EXPECT_FALSE(find_net(mesh).proven_impossible);
  }
}

TEST(CountCuts, AFlatSheetAndATriangleNeedNothingTheyDoNotHave) {
  PolygonSoup triangle;
  triangle.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  triangle.add_face({0, 1, 2});
  EXPECT_EQ(count_cuts(Mesh(triangle)).needed, 0);
  EXPECT_FALSE(count_cuts(triangle_sheet(4, [](int, int) { return 0; })).refutes());
}

}  // namespace
}  // namespace plico
