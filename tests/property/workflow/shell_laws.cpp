#include <gtest/gtest.h>

#include "plico/base/rng.h"
#include "plico/workflow/shell_shape.h"

namespace plico {
namespace {

// Parts whose points lie on a coarse grid that doubles cannot hold exactly: full of points that are coplanar, collinear
// or equal but for rounding. Some may be flat; these are made thick.
std::vector<ShapePart> grid_shape(Rng& rng) {
  std::vector<ShapePart> parts(2 + rng.below(5));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].name = "part" + std::to_string(i);
    for (int k = 0; k < 12; ++k) {
      const double x = rng.below(5), y = rng.below(5);
      parts[i].points.emplace_back(0.1 * (x + 2 * static_cast<double>(i)), 0.1 * y, 0.1 * rng.below(5));
    }
    parts[i].points.push_back(parts[i].points[0] + Vec3(0.03, 0.05, 0.07));
  }
  return parts;
}

TEST(ShellLaw, TheJudgeAcceptsTheShellsOfAnyShape) {
  for (int seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const std::vector<ShapePart> parts = grid_shape(rng);
    ShellOptions options;
    options.nested = seed % 3 == 0 ? NestedPolicy::Drop : seed % 3 == 1 ? NestedPolicy::Merge : NestedPolicy::Keep;
    const JudgedShells judged = shell_shape(parts, options, {});
    for (const Defect& defect : judged.verdict.defects) ADD_FAILURE() << defect.code << ": " << defect.message;
    EXPECT_TRUE(judged.verdict.complete);
    EXPECT_EQ(judged.shells.shells.size() + judged.shells.nested.size() + judged.shells.lost.size(), parts.size());
  }
}

}  // namespace
}  // namespace plico
