#include "plico/segment/given.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

using testing::ElementsAre;

TEST(GivenParts, PiecesOfOneGroupAreNumberedAndFacesWithoutOneLettered) {
  // A row of five unit squares: A's group lies at both ends.
  const Mesh row{open_grid(5, 1)};
  const Segmentation parts = by_groups(row, {0, 1, 1, 2, 0}, {"leg", "trunk", ""});
  EXPECT_THAT(parts.names, ElementsAre("trunk", "leg", "A", "leg-2"));
  EXPECT_THAT(parts.part, ElementsAre(1, 0, 0, 2, 3));
}

TEST(GivenParts, NamesMadeByNumberingNeverRepeatNamesThatAreGiven) {
  const Mesh row{open_grid(3, 1)};
  EXPECT_THAT(by_groups(row, {0, 1, 0}, {"x", "x-2"}).names, ElementsAre("x", "x-2", "x-3"));
  EXPECT_THAT(by_groups(row, {0, 1, 1}, {"", "A"}).names, ElementsAre("A", "B"));
}

TEST(GivenParts, APartLiesInOneComponent) {
  PolygonSoup two = cube();
  const PolygonSoup other = cube();
  for (const Vec3& p : other.points) two.points.push_back(p + Vec3(5, 0, 0));
  for (int f = 0; f < other.num_faces(); ++f) {
    std::vector<int> face(other.face(f).begin(), other.face(f).end());
    for (int& v : face) v += other.num_points();
    two.add_face(face);
  }
  const Mesh mesh{two};
  EXPECT_EQ(by_labels(mesh, std::vector<int>(12, 3)).num_parts(), 2);
  EXPECT_EQ(by_components(mesh).num_parts(), 2);
}

TEST(GivenParts, LabelsOfAnotherMeshAreRefused) {
  EXPECT_THROW(by_labels(Mesh(cube()), {1, 2, 3}), InvalidInput);
  EXPECT_THROW(by_groups(Mesh(cube()), {0}, {"a"}), InvalidInput);
}

}  // namespace
}  // namespace plico
