#include <gtest/gtest.h>

#include <optional>

#include "effort.h"
#include "linkage_samples.h"
#include "plico/motion/collision.h"
#include "plico/verify/path.h"

namespace plico {
namespace {

FoldingPath random_path(const Linkage& linkage, Rng& rng) {
  FoldingPath path{{{0, flat(linkage)}}};
  for (int w = 1, stops = rng.below(3); w <= stops; ++w) {
    Configuration config = goal(linkage);
    for (double& angle : config) angle *= rng.uniform();
    path.waypoints.push_back({static_cast<double>(w) / (stops + 1), config});
  }
  path.waypoints.push_back({1, goal(linkage)});
  return path;
}

std::optional<double> first_collision(const Linkage& linkage, const FoldingPath& path, int samples) {
  CollisionChecker checker(linkage);
  for (int i = 0; i <= samples; ++i)
    if (const double t = static_cast<double>(i) / samples; checker.collides(path.at(t))) return t;
  return {};
}

TEST(PathLaw, TheProofAgreesWithTenThousandSamples) {
  int free = 0, collided = 0;
  for (int seed = 1; seed <= num_cases(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Linkage linkage = make_linkage(random_triangles(4 + rng.below(4), rng.uniform(0.5, 3.1), rng));
    const FoldingPath path = random_path(linkage, rng);
    const PathProof proof = prove_path(linkage, path);
    const std::optional<double> seen = first_collision(linkage, path, 10000);
    EXPECT_NE(proof.verdict, PathVerdict::Undecided);
    EXPECT_FALSE(seen && proof.verdict != PathVerdict::Collides) << "seen at " << *seen;
    // What the samples missed must be there at the time that the proof names.
    if (proof.verdict == PathVerdict::Collides) {
      EXPECT_TRUE(CollisionChecker(linkage).collides(path.at(proof.to)));
    }
    (proof.verdict == PathVerdict::Free ? free : collided)++;
  }
  EXPECT_GT(free, kSanitized ? 0 : 30);
  EXPECT_GT(collided, kSanitized ? 0 : 30);
}

}  // namespace
}  // namespace plico
