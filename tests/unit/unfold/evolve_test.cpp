#include "plico/unfold/evolve.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "judged_net.h"
#include "mesh_samples.h"
#include "plico/base/error.h"
#include "plico/unfold/genes.h"
#include "plico/unfold/heuristics.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

TEST(Evolve, FindsOneNetOfABumpySphereForEverySeed) {
  const Mesh mesh = bumpy_sphere(1, 0.3, 3);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const EvolveResult result = evolve_net(mesh, {.seed = seed});
    EXPECT_EQ(result.ending, Ending::Found);
    EXPECT_EQ(result.parts, 1);
    EXPECT_EQ(result.overlaps, 0);
    EXPECT_TRUE(judge(mesh, result.forest).is_net());
  }
}

// Small populations of a mesh whose heuristic trees overlap, so that generations do run.
const EvolveOptions kSmall{.seed = 7, .population = 60, .children = 15, .max_generations = 20};

TEST(Evolve, GetsBetterOverGenerationsAndNeverWorse) {
  const Mesh mesh = bumpy_sphere(2, 0.4, 3);
  EvolveOptions options = kSmall;
  options.max_generations = 0;
  const EvolveResult first = evolve_net(mesh, options);
  EXPECT_EQ(first.ending, Ending::Exhausted);
  EXPECT_GT(first.overlaps, 0);
  EXPECT_EQ(first.overlaps, first.start_overlaps);
  options.max_generations = 100;
  const EvolveResult later = evolve_net(mesh, options);
  EXPECT_EQ(later.start_overlaps, first.start_overlaps);
  EXPECT_LT(later.overlaps, first.overlaps);
}

TEST(Evolve, IsTheSameForOneAndTwoThreads) {
  const Mesh mesh = bumpy_sphere(2, 0.4, 3);
  plico::Run two;
  two.threads = 2;
  const EvolveResult a = evolve_net(mesh, kSmall), b = evolve_net(mesh, kSmall, two);
  EXPECT_GT(a.generations, 0);
  EXPECT_EQ(a.forest, b.forest);
  EXPECT_EQ(a.generations, b.generations);
}

TEST(Evolve, CutsTheBestTreeIntoPartsWhenItsTimeIsOver) {
  const Mesh mesh = bumpy_sphere(3, 0.2, 1);
  const EvolveResult result = evolve_net(mesh, {}, limited(plico::Run{}, 0));
  EXPECT_EQ(result.ending, Ending::TimedOut);
  EXPECT_EQ(result.generations, 0);
  EXPECT_GT(result.parts, 1);
  EXPECT_EQ(static_cast<int>(result.in_the_way.size()), result.overlaps);
  EXPECT_TRUE(judge(mesh, result.forest).valid());
}

TEST(Evolve, RejectsOptionsOutOfRange) {
  EXPECT_THROW(evolve_net(tetrahedron_mesh(), {.population = 1}), InvalidOption);
  EXPECT_THROW(evolve_net(tetrahedron_mesh(), {.children = 400}), InvalidOption);
  EXPECT_THROW(evolve_net(tetrahedron_mesh(), {.crossover_probability = 1.5}), InvalidOption);
  EXPECT_THROW(evolve_net(tetrahedron_mesh(), {.mutation_variance = -1}), InvalidOption);
  EXPECT_THROW(evolve_net(tetrahedron_mesh(), {.max_generations = -1}), InvalidOption);
  try {
    check(EvolveOptions{.tournament = 500});
    FAIL();
  } catch (const InvalidOption& error) {
    EXPECT_STREQ(error.what(), "tournament = 500 must be in [1, population = 400]");
  }
}

TEST(FaultCounter, ASaddleCutOnceOverlapsLocallyAndAConvexVertexNever) {
  const Mesh fan = saddle_fan(8, kPi / 3);  // an angle sum of 8 pi / 3 around vertex 0
  const FlatFaces faces(fan);
  const FaultCounter count(faces);
  Rng rng(1);
  for (int seed = 0; seed < 20; ++seed) {
    Genes genes(fan.num_edges());
    for (double& gene : genes) gene = rng.uniform();
    EXPECT_EQ(count.local_overlaps(lightest_forest(fan, genes)), 1);  // eight folds in a ring: a tree cuts one
  }
  const Mesh tetra = tetrahedron_mesh();
  const FlatFaces convex(tetra);
  EXPECT_EQ(FaultCounter(convex).local_overlaps(lightest_forest(tetra, Genes(6, 0.5))), 0);
}

// R7: a local overlap is two faces around one vertex that overlap, so N_l > 0 implies N_o > 0.
TEST(FaultCounter, EveryLocalOverlapIsAnOverlap) {
  const Mesh mesh = bumpy_sphere(1, 0.5, 2);
  const FlatFaces faces(mesh);
  const FaultCounter count(faces);
  Rng rng(4);
  int seen = 0;
  for (int i = 0; i < 200; ++i) {
    Genes genes(mesh.num_edges());
    for (double& gene : genes) gene = rng.uniform();
    const Faults faults = count(lightest_forest(mesh, genes));
    EXPECT_GE(faults.overlaps, faults.local_overlaps > 0 ? 1 : 0);
    seen += faults.local_overlaps;
  }
  EXPECT_GT(seen, 0);
}

TEST(Operators, CrossoverTakesEveryGeneFromAParentAndAboutHalfFromEach) {
  Rng rng(1);
  const Genes mother(10'000, 0.25), father(10'000, 0.75);
  const Genes child = uniform_crossover(mother, father, rng);
  const auto from_mother = std::count(child.begin(), child.end(), 0.25);
  EXPECT_EQ(from_mother + std::count(child.begin(), child.end(), 0.75), 10'000);
  EXPECT_NEAR(static_cast<double>(from_mother), 5000, 250);  // five standard deviations
  EXPECT_EQ(uniform_crossover(mother, mother, rng), mother);
}

TEST(Operators, MutationChangesItsShareOfGenesAndStaysInRange) {
  Rng rng(2);
  Genes genes(50'000, 0.5);
  mutate(genes, 0.02, 0.3, rng);
  EXPECT_NEAR(static_cast<double>(50'000 - std::count(genes.begin(), genes.end(), 0.5)), 1000, 160);
  EXPECT_GE(*std::min_element(genes.begin(), genes.end()), 0);
  EXPECT_LE(*std::max_element(genes.begin(), genes.end()), 1);
  const Genes before = genes;
  mutate(genes, 0, 0.3, rng);
  mutate(genes, 1, 0, rng);
  EXPECT_EQ(genes, before);
}

// The best of 100 wins a tournament of t with probability 1 - 0.99^t.
TEST(Operators, TournamentPicksTheBestAsOftenAsItIsDrawn) {
  Rng rng(3);
  std::vector<double> fitness(100);
  for (int i = 0; i < 100; ++i) fitness[i] = -std::abs(i - 37);
  int wins = 0;
  for (int i = 0; i < 20'000; ++i) wins += tournament(fitness, 7, rng) == 37 ? 1 : 0;
  EXPECT_NEAR(wins / 20'000.0, 1 - std::pow(0.99, 7), 0.01);
}

}  // namespace
}  // namespace plico
