#include "plico/segment/thickness.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <set>

#include "plico/mesh/measures.h"
#include "plico/segment/dual_graph.h"
#include "plico/segment/rearrange.h"
#include "plico/shapes/creature.h"
#include "plico/shapes/shapes.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

TEST(Thickness, OfAFlatSheetIsNotKnown) { EXPECT_THAT(thickness(Mesh(open_grid(3, 2))), testing::Each(0)); }

TEST(Thickness, IsAboutTheDiameterOfABall) {
  // Rays go up to 50 degrees from the middle: chords of 0.64 diameters and more.
  for (double t : thickness(Mesh(geodesic_sphere(3)))) {
    EXPECT_LE(t, 2);
    EXPECT_GE(t, 2 * 0.6);
  }
}

TEST(Thickness, IsLessInATubeThanInTheBodiesItJoins) {
  const std::vector<double> thick = thickness(dumbbell());
  for (int i = 0; i < 12; ++i) EXPECT_LT(thick[6 * 12 + i], thick[3 * 12 + i]);
}

TEST(Thickness, IsInProportionToTheSize) {
  PolygonSoup soup = dumbbell().soup();
  for (Vec3& p : soup.points) p *= 4;  // exactly
  const std::vector<double> once = thickness(dumbbell()), larger = thickness(Mesh(soup));
  for (std::size_t f = 0; f < once.size(); ++f) EXPECT_NEAR(larger[f], 4 * once[f], 1e-9);
}

TEST(Thickness, MakesSeamsCheaperWhereItChanges) {
  const Mesh row{open_grid(4, 1)};
  DualGraph graph(row);
  graph.discount({1, 1, 3, 3});
  const auto cost = [&](int a, int b) {
    for (const DualGraph::Arc& arc : graph.arcs(a))
      if (arc.to == b) return arc.cost;
    return 0.0;
  };
  EXPECT_LT(cost(1, 2), cost(0, 1));
  EXPECT_EQ(cost(1, 2), cost(2, 1));
  EXPECT_EQ(cost(0, 1), cost(2, 3));
}

TEST(Thickness, LeavesFacesThatAreHeldTogether) {
  const Mesh row{open_grid(4, 1)};
  DualGraph graph(row);
  graph.hold(1, 2);
  graph.discount({1, 1, 3, 3});
  EXPECT_FALSE(best_neck(graph, {1, 2}, {.min_area = 0}).has_value());
}

TEST(CutByThickness, TakesOffAFinThatNoValleySurrounds) {
  const Mesh fish{creature({.animal = Animal::Fish, .faces = 500, .variety = 0.6, .seed = 31})};
  const DualGraph graph(fish);
  const std::vector<int> necks = cut_limbs(graph, components(fish).of_face);
  const std::vector<int> part = cut_by_thickness(fish, graph, necks, {});
  EXPECT_EQ(*std::max_element(part.begin(), part.end()), 1 + *std::max_element(necks.begin(), necks.end()));
  // It only cuts further.
  std::set<std::pair<int, int>> together;
  for (std::size_t f = 0; f < part.size(); ++f) together.emplace(part[f], necks[f]);
  EXPECT_EQ(static_cast<int>(together.size()), 1 + *std::max_element(part.begin(), part.end()));
}

TEST(CutByThickness, IsOffWhereANumberOfPartsIsAskedFor) {
  const Mesh mesh = dumbbell();
  const std::vector<int> whole(mesh.num_faces(), 0);
  const NeckCutOptions three{.worst_score = std::numeric_limits<double>::infinity(), .max_parts = 3, .neck = {}};
  EXPECT_EQ(cut_by_thickness(mesh, DualGraph(mesh), whole, three), whole);
}

TEST(CutByThickness, CutsNoBall) {
  const Mesh ball{geodesic_sphere(3)};
  const std::vector<int> whole(ball.num_faces(), 0);
  EXPECT_EQ(cut_by_thickness(ball, DualGraph(ball), whole, {}), whole);
}

}  // namespace
}  // namespace plico
