#include "plico/unfold/optimize.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_samples.h"
#include "plico/base/error.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/geom/rectangle_fit.h"
#include "plico/shapes/named_shapes.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/search.h"
#include "plico/verify/net.h"

namespace plico {
namespace {

FoldForest some_net(const Mesh& mesh) {
  SearchResult found = find_net(mesh, {.starts = 1, .grow_by = Heuristic::SteepestEdge});
  EXPECT_EQ(found.ending, Ending::Found);
  return std::move(found.forest);
}

OptimizeOptions quick(const NetFeatures& weights) { return {.weights = weights, .steps = 20'000, .starts = 1}; }

bool is_net(const Mesh& mesh, const FoldForest& forest) { return verify_net(lay_flat(mesh, forest), mesh).is_net(); }

TEST(Optimize, EachWishIsFulfilledByAVerifiedNet) {
  const Mesh mesh = bumpy_sphere(2, 0.25, 3);
  const FoldForest net = some_net(mesh);
  const OptimizeResult cut = optimize_net(mesh, net, quick({.cut_length = 1}));
  EXPECT_LT(cut.after.cut_length, 0.97 * cut.before.cut_length);
  EXPECT_GE(cut.after.cut_length, least_cut_length(mesh) * (1 - 1e-12));
  const OptimizeResult hull = optimize_net(mesh, net, quick({.hull_area = 1}));
  EXPECT_LT(hull.after.hull_area, 0.9 * hull.before.hull_area);
  const OptimizeResult box = optimize_net(mesh, net, quick({.box_area = 1}));
  EXPECT_LT(box.after.box_area, 0.9 * box.before.box_area);
  const OptimizeResult branch = optimize_net(mesh, net, quick({.longest_branch = 1}));
  EXPECT_LT(branch.after.longest_branch, branch.before.longest_branch);
  for (const OptimizeResult* result : {&cut, &hull, &box, &branch}) {
    EXPECT_EQ(result->ending, Ending::Found);
    EXPECT_TRUE(is_net(mesh, result->forest));
  }
}

TEST(Optimize, ReportsTheFeaturesOfItsNets) {
  const Mesh mesh = bumpy_sphere(1, 0.2, 2);
  const FoldForest net = some_net(mesh);
  const OptimizeResult result = optimize_net(mesh, net, quick({.cut_length = 1, .hull_area = 1, .longest_branch = 1}));
  EXPECT_EQ(net_features(mesh, net).hull_area, result.before.hull_area);
  EXPECT_EQ(net_features(mesh, result.forest).cut_length, result.after.cut_length);
  EXPECT_EQ(net_features(mesh, result.forest).longest_branch, result.after.longest_branch);
}

TEST(Optimize, FeaturesOfTheCubesCross) {
  const Mesh mesh(make_shape("cube"));
  const OptimizeResult best = optimize_net(mesh, some_net(mesh), quick({.longest_branch = 1}));
  const double side = std::sqrt(net_features(mesh, best.forest).cut_length / 7);  // seven of the twelve edges are cut
  EXPECT_DOUBLE_EQ(side * side * 7, least_cut_length(mesh));
  EXPECT_EQ(best.after.longest_branch, 2);  // one face is two steps away from any other
}

TEST(Optimize, NeverWorseAndDeterministicForEveryThreadCount) {
  const Mesh mesh = bumpy_sphere(2, 0.3, 5);
  const FoldForest net = some_net(mesh);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    OptimizeOptions options = quick({.hull_area = 1});
    options.steps = 3'000;
    options.seed = seed;
    const OptimizeResult one = optimize_net(mesh, net, options), two = optimize_net(mesh, net, options, {.threads = 2});
    EXPECT_LE(one.after.hull_area, one.before.hull_area);
    EXPECT_EQ(one.forest, two.forest);
  }
}

TEST(Optimize, TheBestNetStaysAsItIs) {
  const Mesh mesh = tetrahedron_mesh();
  OptimizeOptions options = quick({.cut_length = 1});
  options.starts = 0;
  const OptimizeResult result = optimize_net(mesh, some_net(mesh), options);
  EXPECT_LE(result.after.cut_length, result.before.cut_length);
  EXPECT_TRUE(is_net(mesh, result.forest));
}

// Every piece of the net in the plane, when it is cut at some of its folds.
std::vector<std::vector<Vec2>> hulls_of_pieces(const Mesh& mesh, const FoldForest& net, const std::vector<char>& cuts) {
  FoldForest pieces = net;
  for (std::size_t e = 0; e < cuts.size(); ++e)
    if (cuts[e]) pieces.is_fold[e] = 0;
  const Unfolding laid = lay_flat(mesh, pieces);
  std::vector<std::vector<Vec2>> hulls(laid.num_parts());
  for (int f = 0; f < laid.sheet.num_faces(); ++f)
    for (int v : laid.sheet.faces[f]) hulls[laid.part[f]].push_back(laid.sheet.vertices[v]);
  for (auto& hull : hulls) hull = convex_hull(std::move(hull));
  return hulls;
}

TEST(Optimize, PiecesOfANetBecomeCompactAndGoOnFittingTheirRoom) {
  const Mesh mesh = bumpy_sphere(2, 0.25, 3);
  const FoldForest net = some_net(mesh);
  OptimizeOptions options = quick({.hull_area = 1});
  options.starts = 0;
  options.cuts.assign(mesh.num_edges(), 0);
  int folds = 0;
  for (EdgeId e : mesh.edges())
    if (net.is_fold[e] && ++folds % 50 == 25) options.cuts[e] = 1;
  const auto fits = [&](const auto& hull) { return angle_that_fits(hull, options.room).has_value(); };
  const auto before = hulls_of_pieces(mesh, net, options.cuts);
  options.room = Vec2(1, 1.4);
  while (!std::ranges::all_of(before, fits)) options.room *= 1.05;
  const OptimizeResult result = optimize_net(mesh, net, options);
  const auto after = hulls_of_pieces(mesh, result.forest, options.cuts);
  double area = 0;
  for (const auto& hull : after) area += signed_area(hull);
  EXPECT_EQ(after.size(), before.size());
  EXPECT_NEAR(area, result.after.hull_area, 1e-9 * area);
  EXPECT_LT(result.after.hull_area, 0.9 * result.before.hull_area);
  EXPECT_TRUE(std::ranges::all_of(after, fits));
  EXPECT_TRUE(is_net(mesh, result.forest));
  options.starts = 1;  // nets grown afresh have other folds
  EXPECT_THROW(optimize_net(mesh, net, options), InvalidOption);
}

TEST(Optimize, EndsAtTheDeadlineWithANet) {
  const Mesh mesh = bumpy_sphere(3, 0.25, 1);
  const FoldForest net = some_net(mesh);
  OptimizeOptions options = quick({.hull_area = 1});
  options.steps = 1'000'000'000;
  const OptimizeResult result = optimize_net(mesh, net, options, limited({}, 0.3));
  EXPECT_EQ(result.ending, Ending::TimedOut);
  EXPECT_LE(result.after.hull_area, result.before.hull_area);
  EXPECT_TRUE(is_net(mesh, result.forest));
}

TEST(Optimize, RefusesWhatIsNoNetAndBadOptions) {
  const Mesh mesh = bumpy_sphere(1, 0.2, 2);
  EXPECT_THROW(optimize_net(mesh, {std::vector<char>(mesh.num_edges(), 0)}), InvalidInput);
  EXPECT_THROW(check(OptimizeOptions{.weights = {}}), InvalidOption);
  EXPECT_THROW(check(OptimizeOptions{.weights = {.cut_length = -1, .hull_area = 2}}), InvalidOption);
  EXPECT_THROW(check(OptimizeOptions{.lanes = 0}), InvalidOption);
  EXPECT_THROW(weights_for("beauty"), InvalidOption);
}

}  // namespace
}  // namespace plico
