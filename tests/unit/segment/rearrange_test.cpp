#include "plico/segment/rearrange.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

#include "plico/mesh/measures.h"
#include "plico/mesh/segmentation.h"
#include "plico/segment/coarse.h"
#include "plico/segment/given.h"
#include "plico/shapes/shapes.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

int count_of(const std::vector<int>& part) { return static_cast<int>(std::set<int>(part.begin(), part.end()).size()); }

constexpr double kAnyScore = std::numeric_limits<double>::infinity();

TEST(Limbs, SpikesOfAStarComeOffOneByOne) {
  const Mesh star{spiked(Mesh(cube()), 2)};
  const std::vector<int> part = cut_limbs(DualGraph(star), components(star).of_face);
  EXPECT_EQ(count_of(part), 6);
  for (const auto& faces : faces_of_parts(segmentation_by_labels(star, part))) EXPECT_EQ(faces.size(), 4u);
}

TEST(Limbs, AskedForAsManyPartsAsFacesGivesThem) {
  const Mesh mesh{octahedron()};
  const NeckCutOptions options{.worst_score = kAnyScore, .max_parts = 8, .neck = {.min_area = 0}};
  EXPECT_EQ(count_of(cut_limbs(DualGraph(mesh), components(mesh).of_face, options)), 8);
}

TEST(Limbs, PartsThatWereThereAreNeverJoined) {
  const Mesh mesh = dumbbell();
  std::vector<int> halves(mesh.num_faces());
  for (int f = 0; f < mesh.num_faces(); ++f) halves[f] = f % 12 < 6 ? 0 : 1;
  halves = connected_pieces(mesh, halves);
  const std::vector<int> part = cut_limbs(DualGraph(mesh), halves);
  std::set<std::pair<int, int>> together;
  for (int f = 0; f < mesh.num_faces(); ++f) together.emplace(part[f], halves[f]);
  EXPECT_EQ(static_cast<int>(together.size()), count_of(part));
}

TEST(Limbs, ANumberOfPartsIsKeptWhenCutsAreExchanged) {
  const Mesh star{spiked(Mesh(cube()), 2)};
  for (int count : {2, 3, 7, 9}) {
    const NeckCutOptions options{.worst_score = kAnyScore, .max_parts = count, .neck = {}};
    const std::vector<int> part = cut_limbs(DualGraph(star), components(star).of_face, options);
    EXPECT_EQ(count_of(part), count);
    EXPECT_EQ(count_of(connected_pieces(star, part)), count);
  }
}

TEST(Limbs, OfAFineMeshAreThoseOfTheShape) {
  const Mesh mesh = dumbbell(240);
  ASSERT_GE(mesh.num_faces(), kCoarseFrom);
  const std::vector<int> part = cut_limbs_of(mesh, DualGraph(mesh), {.neck = {}});
  // The tube may stand alone.
  EXPECT_LE(count_of(part), 3);
  EXPECT_EQ(count_of(connected_pieces(mesh, part)), count_of(part));
  EXPECT_NE(part[0], part.back());
  for (int f = 0; f < 5 * 240; ++f) {
    EXPECT_EQ(part[f], part[0]);
    EXPECT_EQ(part[mesh.num_faces() - 1 - f], part.back());
  }
}

}  // namespace
}  // namespace plico
