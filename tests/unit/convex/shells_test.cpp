#include "plico/convex/shells.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/base/rng.h"

namespace plico {
namespace {

ShapePart box_part(const std::string& name, const Vec3& low, const Vec3& high) {
  ShapePart part{name, {}};
  for (int i = 0; i < 8; ++i)
    part.points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return part;
}

// A chain of overlapping blobs, each with its neighbours and some with the ones after them.
std::vector<ShapePart> blobs(std::uint64_t seed, int count) {
  Rng rng(seed);
  std::vector<ShapePart> parts;
  for (int i = 0; i < count; ++i) {
    ShapePart part{"blob" + std::to_string(i), {}};
    for (int k = 0; k < 20; ++k) {
      const double x = rng.normal(), y = rng.normal();
      part.points.push_back(Vec3(1.2 * i, 0, 0) + 0.6 * Vec3(x, y, rng.normal()));
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

void expect_disjoint(const Shells& shells) {
  for (const ShellContact& contact : shells.contacts) {
    for (const Vec3& p : shells.shells[contact.first].body.points) ASSERT_EQ(side_of_plane(contact.plane, p), -1);
    for (const Vec3& p : shells.shells[contact.second].body.points) ASSERT_EQ(side_of_plane(contact.plane, p), 1);
  }
}

TEST(DisjointShells, OfOneConvexPartIsItsHull) {
  const Shells shells = disjoint_shells({box_part("box", {0, 0, 0}, {1, 2, 3})});
  ASSERT_EQ(shells.shells.size(), 1u);
  EXPECT_NEAR(volume(shells.shells[0].body), 6, 1e-12);
  EXPECT_NEAR(shells.loss(), 0, 1e-12);
  EXPECT_TRUE(shells.contacts.empty());
}

TEST(DisjointShells, OfAnElbowTouchInTheMitre) {
  const Shells shells = disjoint_shells({box_part("x", {0, 0, 0}, {5, 1, 1}), box_part("y", {0, 0, 0}, {1, 5, 1})});
  EXPECT_NEAR(shells.loss(), 0, 1e-9);
  ASSERT_EQ(shells.contacts.size(), 1u);
  EXPECT_EQ(shells.contacts[0].polygon.size(), 4u);
  EXPECT_NEAR(std::abs(shells.contacts[0].plane.normal.dot(Vec3(1, -1, 0))), std::sqrt(2), 1e-6);
  expect_disjoint(shells);
}

TEST(DisjointShells, OfBoxesThatOnlyTouchAreTheBoxes) {
  const Shells shells =
      disjoint_shells({box_part("low", {0, 0, 0}, {1, 1, 1}), box_part("high", {0.5, 0, 1}, {2, 1, 2})});
  EXPECT_NEAR(shells.loss(), 0, 1e-9);
  ASSERT_EQ(shells.contacts.size(), 1u);
  EXPECT_FALSE(shells.contacts[0].cut);
  EXPECT_EQ(shells.contacts[0].polygon.size(), 4u);
  expect_disjoint(shells);
}

TEST(DisjointShells, AreDisjointExactlyWhateverTheMethod) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (CutMethod method : {CutMethod::Lsf, CutMethod::Svm, CutMethod::SvmOffset, CutMethod::Full})
      expect_disjoint(disjoint_shells(blobs(seed, 5), {.method = method, .svm = {.samples = 200}}));
}

TEST(DisjointShells, SweepsNeverLoseVolume) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    double last = 0;
    for (int sweeps = 0; sweeps <= 4; ++sweeps) {
      const Shells shells = disjoint_shells(blobs(seed, 6), {.least_kept = 0, .max_sweeps = sweeps});
      EXPECT_GE(shells.shell_volume, last * (1 - 1e-9));
      last = shells.shell_volume;
    }
  }
}

TEST(DisjointShells, DoNotDependOnThreads) {
  const Shells one = disjoint_shells(blobs(1, 6)), four = disjoint_shells(blobs(1, 6), {}, {.threads = 4});
  ASSERT_EQ(one.shells.size(), four.shells.size());
  for (std::size_t i = 0; i < one.shells.size(); ++i) EXPECT_EQ(one.shells[i].body.points, four.shells[i].body.points);
}

TEST(DisjointShells, NestedPartsAreDroppedMergedOrKept) {
  const std::vector<ShapePart> parts = {box_part("small", {0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}),
                                        box_part("large", {0, 0, 0}, {1, 1, 1})};
  const Shells dropped = disjoint_shells(parts);
  EXPECT_EQ(dropped.nested, std::vector<int>{0});
  EXPECT_EQ(dropped.hosts, std::vector<int>{1});
  EXPECT_EQ(dropped.shells.size(), 1u);
  EXPECT_NEAR(dropped.loss(), 0, 1e-12);
  EXPECT_EQ(disjoint_shells(parts, {.nested = NestedPolicy::Merge}).shells.size(), 1u);
  const Shells kept = disjoint_shells(parts, {.nested = NestedPolicy::Keep});
  EXPECT_EQ(kept.shells.size(), 2u);
  EXPECT_GE(kept.least_kept(), 0.0999);
  EXPECT_GT(kept.loss(), 0.2);  // half of the large one goes so that the small one stays
}

TEST(DisjointShells, OfTwoEqualPartsAreOne) {
  const std::vector<ShapePart> parts = {box_part("a", {0, 0, 0}, {1, 1, 1}), box_part("b", {0, 0, 0}, {1, 1, 1})};
  EXPECT_EQ(disjoint_shells(parts).shells.size(), 1u);
}

TEST(DisjointShells, AProtectedPartKeepsMore) {
  std::vector<ShapePart> parts = {box_part("bar", {0, 0, 0}, {5, 1, 1}),
                                  box_part("knob", {2, 0.2, 0.5}, {2.6, 0.8, 1.2})};
  for (Vec3& p : parts[1].points) p.z() += 0.2 * p.x();
  const Shells plain = disjoint_shells(parts, {.nested = NestedPolicy::Keep});
  const Shells guarded = disjoint_shells(parts, {.nested = NestedPolicy::Keep, .protect = {"knob"}});
  EXPECT_GE(guarded.shells[1].kept_volume, plain.shells[1].kept_volume);
}

std::string code_of(const std::vector<ShapePart>& parts) {
  try {
    disjoint_shells(parts);
  } catch (const InvalidInput& error) {
    return error.code();
  }
  return "none";
}

TEST(DisjointShells, RefuseWhatHasNoVolume) {
  EXPECT_EQ(code_of({}), "shell/no-parts");
  EXPECT_EQ(code_of({{"dot", {{0, 0, 0}}}}), "shell/flat-part");
  EXPECT_EQ(code_of({{"sheet", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}}), "shell/flat-part");
  EXPECT_EQ(code_of({{"nan", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, NAN}}}}), "shell/not-a-number");
  EXPECT_EQ(code_of(std::vector<ShapePart>(kMaxParts + 1)), "shell/too-many-parts");
  EXPECT_THROW(disjoint_shells({box_part("a", {0, 0, 0}, {1, 1, 1})}, {.protect = {"b"}}), InvalidOption);
  EXPECT_THROW(disjoint_shells({box_part("a", {0, 0, 0}, {1, 1, 1})}, {.least_kept = 1}), InvalidOption);
}

TEST(DisjointShells, OfARunThatIsOverAreStillDisjoint) {
  const Shells shells = disjoint_shells(blobs(1, 5), {}, limited({}, 0));
  EXPECT_EQ(shells.ending, Ending::TimedOut);
  expect_disjoint(shells);
}

}  // namespace
}  // namespace plico
