// What is written is read back number for number, and written again byte for byte.
#include <gtest/gtest.h>

#include "plico/io/pattern/fold.h"
#include "random_nets.h"

namespace plico {
namespace {

// A net in up to a few parts, with its folded form and sometimes a motion.
FoldFile random_file(Rng& rng) {
  const Mesh mesh = bumpy_torus(rng, 3 + rng.below(6), 3 + rng.below(6));
  FoldForest forest = random_tree(mesh, rng);
  for (int cuts = rng.below(3); cuts > 0; --cuts) forest.is_fold[rng.below(mesh.num_edges())] = 0;
  FoldFile file = fold_file(mesh, lay_flat(mesh, forest));
  if (rng.below(2) == 0) return file;
  const Linkage linkage = make_linkage(file.net.sheet, file.net.mate);
  set_path(file, linkage, rng.below(2) == 0 ? linear_path(linkage) : uniform_path(linkage));
  return file;
}

TEST(FoldLaw, WrittenIsReadBackAndWrittenAgain) {
  for (int seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const FoldFile file = random_file(rng);
    const std::string bytes = write_fold(file);
    const FoldFile back = read_fold(bytes);
    EXPECT_EQ(write_fold(back), bytes);
    EXPECT_EQ(back.net.sheet.vertices, file.net.sheet.vertices);
    EXPECT_EQ(back.net.sheet.faces, file.net.sheet.faces);
    EXPECT_EQ(back.net.mate, file.net.mate);
    EXPECT_EQ(back.net.part, file.net.part);
    EXPECT_EQ(back.folded, file.folded);
    EXPECT_EQ(back.path.has_value(), file.path.has_value());
    for (int e = 0; e < file.net.sheet.num_edges(); ++e)
      EXPECT_NEAR(back.net.sheet.edges[e].fold_angle, file.net.sheet.edges[e].fold_angle, 1e-15);
  }
}

TEST(FoldLaw, FoldedFormIsTheMeshThatWasUnfolded) {
  for (int seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Mesh mesh = bumpy_torus(rng, 3 + rng.below(6), 3 + rng.below(6));
    const Unfolding net = lay_flat(mesh, random_tree(mesh, rng));
    FoldFile back = read_fold(write_fold(fold_file(mesh, net)));
    const Mesh folded = folded_mesh(back);
    EXPECT_EQ(folded.soup().points, mesh.soup().points);
    EXPECT_EQ(folded.soup().corners, mesh.soup().corners);
    attach_mesh(back.net, folded);
    EXPECT_EQ(back.net.mesh_edge, net.mesh_edge);
    EXPECT_EQ(forest_of(folded, back.net), forest_of(mesh, net));
  }
}

}  // namespace
}  // namespace plico
