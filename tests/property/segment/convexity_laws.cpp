#include <gtest/gtest.h>

#include <set>

#include "../../effort.h"
#include "../../mesh_samples.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/segmentation.h"
#include "plico/segment/convexity.h"
#include "plico/segment/given.h"
#include "plico/verify/concavity.h"

namespace plico {
namespace {

constexpr double kBound = 0.03;

Mesh random_bumpy(int seed) { return bumpy_sphere(2, 0.6, static_cast<std::uint64_t>(seed)); }

TEST(ConvexityLaw, PartsAreConnectedAndKeepTheBoundAsJudged) {
  for (int seed = 1; seed <= num_cases(10); ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = random_bumpy(seed);
    const std::vector<int> labels = cut_by_convexity(mesh, {kBound});
    const Segmentation parts = segmentation_by_labels(mesh, labels);
    EXPECT_LE(concavity_bound(mesh, parts), kBound * diagonal(mesh) * (1 + 1e-12));
    EXPECT_EQ(by_labels(mesh, labels).num_parts(), parts.num_parts());  // connected
  }
}

TEST(ConvexityLaw, ThreadsAndThePowerOfTwoOfTheUnitChangeNothing) {
  for (int seed = 1; seed <= num_cases(4); ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = random_bumpy(seed);
    PolygonSoup larger = mesh.soup();
    for (Vec3& p : larger.points) p *= 4;
    const std::vector<int> labels = cut_by_convexity(mesh, {kBound});
    plico::Run two;
    two.threads = 2;
    EXPECT_EQ(cut_by_convexity(mesh, {kBound}, two), labels);
    EXPECT_EQ(cut_by_convexity(Mesh(larger), {kBound}), labels);
  }
}

}  // namespace
}  // namespace plico
