#include "plico/fold/linkage.h"

#include <gtest/gtest.h>

#include "linkage_samples.h"
#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"

namespace plico {
namespace {

Vec3 placed_normal(const Pose& pose) { return pose.linear().col(2); }

TEST(Linkage, AValleyBringsTheFrontsTogether) {
  const Linkage linkage = make_linkage(square_strip({1.0}));
  const auto poses = folding_map(linkage, goal(linkage));
  // The far side of the folded square has risen to the front (+z) of the square at rest, whichever that is.
  const int moved = linkage.order[1], rest = linkage.order[0];
  double height = 0;
  for (const Vec3& corner : linkage.panels[moved]) height = std::max(height, (poses[moved] * corner).z());
  EXPECT_NEAR(height, std::sin(1.0), 1e-12);
  EXPECT_TRUE(poses[rest].isApprox(Pose::Identity()));
}

TEST(Linkage, AMountainPutsTheBacksTogether) {
  const Linkage linkage = make_linkage(square_strip({-kPi}));
  const auto poses = folding_map(linkage, goal(linkage));
  EXPECT_NEAR(placed_normal(poses[linkage.order[1]]).z(), -1, 1e-12);
}

TEST(Linkage, ClosesATetrahedronWhereverTheStationaryPanelIs) {
  const Vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  PolygonSoup soup;
  soup.points.assign(p, p + 4);
  for (auto face : {std::vector<int>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) soup.add_face(face);
  const Mesh mesh(soup);
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (HalfedgeId h : mesh.halfedges(FaceId(0))) forest.is_fold[mesh.edge(h)] = 1;
  const Unfolding net = lay_flat(mesh, forest);
  for (int base = 0; base < 4; ++base) {
    SCOPED_TRACE(base);
    const Linkage linkage = make_linkage(net.sheet, net.mate, base);
    ASSERT_EQ(linkage.num_hinges(), 3);
    EXPECT_EQ(linkage.seams.size(), 3u);
    const auto poses = folding_map(linkage, goal(linkage));
    // Distances between folded corners are those of the mesh: equal up to a rigid motion (or mirror; see below).
    const auto corner = [&](int panel, int i) { return Vec3(poses[panel] * linkage.panels[panel][i]); };
    for (int f = 0; f < 4; ++f)
      for (int g = 0; g < 4; ++g)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            const double meant = (p[mesh.corners(FaceId(f))[i]] - p[mesh.corners(FaceId(g))[j]]).norm();
            EXPECT_NEAR((corner(f, i) - corner(g, j)).norm(), meant, 1e-12);
          }
    // Not mirrored: the fronts look outward, away from the tetrahedron's centre.
    Vec3 centre = Vec3::Zero();
    for (int f = 0; f < 4; ++f)
      for (int i = 0; i < 3; ++i) centre += corner(f, i) / 12;
    for (int f = 0; f < 4; ++f) EXPECT_GT(placed_normal(poses[f]).dot(corner(f, 0) - centre), 0);
  }
}

TEST(Linkage, UniformPathTurnsAllHingesAtOneRateUntilTheyArrive) {
  const Linkage linkage = make_linkage(square_strip({1.0, -0.5, 0.25}));
  const FoldingPath path = uniform_path(linkage);
  const Configuration half = path.at(0.5);
  EXPECT_NEAR(half[0], 0.5, 1e-12);
  EXPECT_NEAR(half[1], -0.5, 1e-12);
  EXPECT_NEAR(half[2], 0.25, 1e-12);
  EXPECT_TRUE(path.at(1).isApprox(goal(linkage)));
  EXPECT_NEAR(linear_path(linkage).at(0.5)[1], -0.25, 1e-12);
}

TEST(Linkage, PartsAreWhatHingesConnect) {
  CreasePattern sheet = square_strip({1.0, 1.0});
  sheet.edges.erase(sheet.edges.begin());
  EXPECT_EQ(parts(make_linkage(sheet)), (std::vector<int>{0, 1, 1}));
}

}  // namespace
}  // namespace plico
