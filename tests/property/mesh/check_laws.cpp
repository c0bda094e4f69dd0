#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/mesh/check.h"
#include "plico/mesh/repair.h"
#include "plico/mesh/self_intersections.h"

namespace plico {
namespace {

// Random polygons on few points: full of everything that can be wrong.
PolygonSoup random_soup(Rng& rng) {
  PolygonSoup soup;
  const int points = 4 + rng.below(8);
  for (int i = 0; i < points; ++i) soup.points.emplace_back(rng.below(3), rng.below(3), rng.below(3));
  for (int f = 1 + rng.below(20); f > 0; --f) {
    std::vector<int> face(static_cast<std::size_t>(2 + rng.below(5)));
    for (int& v : face) v = rng.below(points + (rng.below(50) == 0));
    soup.add_face(face);
  }
  return soup;
}

// Codes of what is wrong with the faces as shapes in space; Mesh looks at the combinatorics alone.
bool is_about_geometry(const std::string& code) {
  static const std::set<std::string> codes = {"mesh/degenerate", "mesh/not-planar", "mesh/not-simple",
                                              "mesh/duplicate-face"};
  return codes.count(code) > 0;
}

TEST(CheckLaw, UsableIsExactlyWhatMeshTakes) {
  int usable = 0, refused = 0;
  for (int seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const PolygonSoup soup = random_soup(rng);
    const CheckReport report = check_mesh(soup);
    const bool topology_fails = std::any_of(report.problems.begin(), report.problems.end(), [](const Problem& problem) {
      return problem.severity == Severity::Error && !is_about_geometry(problem.code);
    });
    if (topology_fails) {
      EXPECT_THROW(Mesh{soup}, InvalidInput);
      EXPECT_THROW(require_mesh(soup), InvalidInput);
      ++refused;
    } else if (report.usable()) {
      EXPECT_NO_THROW(Mesh{soup});
      EXPECT_NO_THROW(require_mesh(soup));
      ++usable;
    } else {
      EXPECT_THROW(require_mesh(soup), InvalidInput);
    }
  }
  EXPECT_GT(usable, 10);
  EXPECT_GT(refused, 20);
}

TEST(RepairLaw, NoErrorIsLeftAndASecondRepairRemovesNothing) {
  for (int seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const PolygonSoup soup = random_soup(rng);
    const Repaired once = repair(soup);
    if (once.soup.num_faces() == 0) continue;
    EXPECT_TRUE(check_mesh(once.soup).usable());
    EXPECT_TRUE(check_mesh(soup).usable() || !once.done.empty()) << "errors went silently";
    // Joining equal points again may take other fans apart, but never loses a face.
    const Repaired twice = repair(once.soup);
    EXPECT_EQ(twice.soup.num_faces(), once.soup.num_faces());
  }
}

TEST(CheckLaw, TheNumberOfProblemsDoesNotDependOnTheOrder) {
  for (int seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const PolygonSoup soup = random_soup(rng);
    std::vector<int> order(soup.points.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(rng.below(static_cast<int>(i)))]);
    PolygonSoup shuffled = soup;
    for (std::size_t v = 0; v < order.size(); ++v) shuffled.points[static_cast<std::size_t>(order[v])] = soup.points[v];
    for (int& v : shuffled.corners)
      if (v < static_cast<int>(order.size())) v = order[static_cast<std::size_t>(v)];
    EXPECT_EQ(check_mesh(soup).count(Severity::Error), check_mesh(shuffled).count(Severity::Error));
    EXPECT_EQ(self_intersections(soup), self_intersections(shuffled));
  }
}

}  // namespace
}  // namespace plico
