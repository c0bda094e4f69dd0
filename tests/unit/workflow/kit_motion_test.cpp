#include "plico/workflow/kit_motion.h"

#include <gtest/gtest.h>

#include "plico/segment/given.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

// A cube, and an octahedron beside it.
Mesh cube_and_octahedron() {
  PolygonSoup soup = cube();
  const PolygonSoup other = octahedron();
  const int first = soup.num_points();
  for (const Vec3& p : other.points) soup.points.emplace_back(p + Vec3(10, 0, 0));
  for (int f = 0; f < other.num_faces(); ++f) {
    std::vector<int> face(other.face(f).begin(), other.face(f).end());
    for (int& v : face) v += first;
    soup.add_face(face);
  }
  return Mesh(soup);
}

TEST(KitMotion, PiecesMoveAsTheyDoByThemselves) {
  const Mesh mesh = cube_and_octahedron();
  const Kit kit = make_kit(mesh, by_components(mesh));
  const std::optional<Motion> motion = motion_of_pieces(mesh, kit);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->proof.verdict, PathVerdict::Free);
  EXPECT_EQ(motion->method, MotionMethod::Linear);
  const Linkage linkage = linkage_of(kit.net);
  EXPECT_EQ(linkage.num_hinges(), 12);
  EXPECT_LT((motion->path.waypoints.back().config - goal(linkage)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(KitMotion, StopsOfOnePieceAreStopsOfAll) {
  const Mesh mesh = cube_and_octahedron();
  Kit kit = make_kit(mesh, by_components(mesh));
  ASSERT_EQ(kit.part.size(), 2u);
  FoldingPath& path = kit.part[0].motion->path;
  path.waypoints.insert(path.waypoints.begin() + 1, {0.25, flat(linkage_of(kit.part[0].net))});
  const std::optional<Motion> motion = motion_of_pieces(mesh, kit);
  ASSERT_TRUE(motion);
  ASSERT_EQ(motion->path.waypoints.size(), 3u);
  const Configuration early = motion->path.at(0.25);
  const Configuration straight = 0.25 * goal(linkage_of(kit.net));
  int at_rest = 0, on_the_way = 0;
  for (int h = 0; h < early.size(); ++h) {
    if (early[h] == 0) ++at_rest;
    if (std::abs(early[h] - straight[h]) < 1e-12) ++on_the_way;
  }
  EXPECT_EQ(at_rest, static_cast<int>(kit.part[0].net.sheet.num_faces()) - 1);
  EXPECT_EQ(on_the_way, static_cast<int>(kit.part[1].net.sheet.num_faces()) - 1);
}

TEST(KitMotion, OfPanelsAloneThereIsNone) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.add_face({0, 1, 2});
  const Mesh mesh(soup);
  EXPECT_FALSE(motion_of_pieces(mesh, make_kit(mesh, by_components(mesh))));
}

}  // namespace
}  // namespace plico
