#include "plico/segment/necks.h"

#include <gmock/gmock.h>

#include <limits>
#include <numeric>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/segmentation.h"
#include "plico/shapes/shapes.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

std::vector<int> all_faces(const Mesh& mesh) {
  std::vector<int> faces(mesh.num_faces());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

Segmentation at_necks(const Mesh& mesh, const NeckCutOptions& options = {}) {
  return segmentation_by_labels(mesh, cut_at_necks(DualGraph(mesh), components(mesh).of_face, options));
}

TEST(Necks, TwoBodiesAndATubeAreCutAtTheTube) {
  const Mesh mesh = dumbbell();
  const Segmentation parts = at_necks(mesh);
  ASSERT_EQ(parts.num_parts(), 2);
  EXPECT_EQ(seams(mesh, parts).size(), 12u);
  // Wholly on one side are the bodies; the tube may go with either.
  for (int f = 0; f < 6 * 12; ++f) {
    EXPECT_EQ(parts.part[f], parts.part[0]);
    EXPECT_EQ(parts.part[mesh.num_faces() - 1 - f], parts.part[mesh.num_faces() - 1]);
  }
}

TEST(Necks, SpikesOfAStarComeOffOneByOne) {
  const Mesh star{spiked(Mesh(cube()), 2)};
  const Segmentation parts = at_necks(star);
  ASSERT_EQ(parts.num_parts(), 6);
  for (const auto& faces : faces_of_parts(parts)) EXPECT_EQ(faces.size(), 4u);
}

TEST(Necks, ASphereHasNone) { EXPECT_EQ(at_necks(Mesh(geodesic_sphere(3))).num_parts(), 1); }

TEST(Necks, ComponentsStayApartAndAreCutAlike) {
  PolygonSoup two = dumbbell().soup();
  const PolygonSoup other = two;
  for (const Vec3& p : other.points) two.points.push_back(p + Vec3(9, 0, 0));
  for (int f = 0; f < other.num_faces(); ++f) {
    std::vector<int> face(other.face(f).begin(), other.face(f).end());
    for (int& v : face) v += other.num_points();
    two.add_face(face);
  }
  EXPECT_EQ(at_necks(Mesh(two)).num_parts(), 4);
}

TEST(Necks, AskedForAsManyPartsAsFacesGivesThem) {
  const Mesh mesh{octahedron()};
  NeckCutOptions options{.worst_score = std::numeric_limits<double>::infinity(), .max_parts = 8, .neck = {}};
  EXPECT_EQ(at_necks(mesh, options).num_parts(), 8);
}

TEST(Necks, NoSideIsSmallerThanAllowed) {
  const Mesh mesh = dumbbell();
  EXPECT_FALSE(best_neck(DualGraph(mesh), {0, 1}, {.min_area = 0.4}).has_value());
  const std::optional<Neck> neck = best_neck(DualGraph(mesh), all_faces(mesh), {.min_area = 0.45});
  ASSERT_TRUE(neck.has_value());
  double side = 0;
  for (int f : neck->side) side += area(mesh, FaceId(f));
  EXPECT_GE(side, 0.45 * surface_area(mesh));
}

// Parts numbered by their first face, so that equal areas may come in any order.
std::vector<int> by_first_face(const Segmentation& parts) {
  std::vector<int> number(parts.num_parts(), -1), result;
  int next = 0;
  for (int p : parts.part) {
    if (number[p] < 0) number[p] = next++;
    result.push_back(number[p]);
  }
  return result;
}

TEST(Necks, SizeAndPlaceOfTheMeshDoNotMatter) {
  const Mesh star{spiked(Mesh(cube()), 2)};
  PolygonSoup moved = star.soup();
  for (Vec3& p : moved.points) p = 1000 * (rotation(Vec3(1, 2, 2) / 3, 0.7) * p) + Vec3(5, 6, 7);
  EXPECT_EQ(by_first_face(at_necks(Mesh(moved))), by_first_face(at_necks(star)));
}

TEST(Necks, SeamsAreCheapInValleysAndDearWhereItIsFlat) {
  EXPECT_EQ(seam_factor(0), 1);
  EXPECT_EQ(seam_factor(3), 0.12);
  EXPECT_EQ(seam_factor(-kPi / 2), 0.75);
  EXPECT_NEAR(seam_factor(0.45), 1 / 2.718281828459045, 1e-12);
}

TEST(Necks, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(check(NeckOptions{.min_area = 0.6}), InvalidOption);
  EXPECT_THROW(check(NeckOptions{.eigenvectors = 0}), InvalidOption);
}

}  // namespace
}  // namespace plico
