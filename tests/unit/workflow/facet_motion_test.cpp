// Which sheets need panels that bend, and what is told of it.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>

#include "pattern_samples.h"
#include "plico/fold/planar_faces.h"
#include "plico/origami/bases.h"
#include "plico/origami/patterns.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

using testing::Contains;
using testing::HasSubstr;

// A triangle of a Resch tessellation: its corners, and the crease that each side becomes where two of them meet.
struct ReschTriangle {
  std::array<int, 3> corners;
  std::array<double, 3> folds;  // of the sides from corner i to corner i + 1
};

// The triangle tessellation of Ron Resch: tucks, large triangles whose centre is joined to their corners and to the
// middles of their sides, with the small triangles between them. Folded, the small ones tile a plane, and the tucks
// stand on it as walls: folded in two along the long spokes, at 120 degrees to each other along the short ones.
class Resch {
 public:
  CreasePattern sheet() {
    for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, -1}, {-1, 2}, {-1, -1}, {-2, 1}, {1, -2}}) add_tuck(i, j);
    for (int i = -4; i <= 4; ++i)
      for (int j = -4; j <= 4; ++j) add_small(i, j);
    add_edges();
    return std::move(sheet_);
  }

 private:
  static constexpr double kSide = -kPi / 2, kLong = kPi, kShort = -kPi / 3;
  using Place = std::pair<int, int>;  // in the lattice of the small triangles

  int vertex(Place at) {
    const auto [found, added] = vertices_.try_emplace(at, sheet_.num_vertices());
    if (added) sheet_.vertices.emplace_back(at.first + 0.5 * at.second, std::sqrt(0.75) * at.second);
    return found->second;
  }

  // Of the middles (i, j), (i + 1, j) and (i, j + 1).
  void add_tuck(int i, int j) {
    const Place around[] = {{i, j}, {i + 1, j - 1}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i - 1, j + 1}};
    std::array<int, 6> ring;  // middles and corners in turn
    for (int k = 0; k < 6; ++k) ring[k] = vertex(around[k]);
    const int centre = sheet_.num_vertices();
    sheet_.vertices.push_back((sheet_.vertices[ring[0]] + sheet_.vertices[ring[2]] + sheet_.vertices[ring[4]]) / 3);
    for (int k = 0; k < 6; ++k)
      triangles_.push_back(
          {{centre, ring[k], ring[(k + 1) % 6]}, {k % 2 ? kLong : kShort, kSide, k % 2 ? kShort : kLong}});
  }

  // The triangle of (i, j), (i + 1, j) and (i, j + 1), when it is no part of a tuck and its corners are in the sheet.
  void add_small(int i, int j) {
    if ((i - j) % 3 == 0) return;
    const Place corners[] = {{i, j}, {i + 1, j}, {i, j + 1}};
    for (const Place& corner : corners)
      if (!vertices_.count(corner)) return;
    triangles_.push_back({{vertex(corners[0]), vertex(corners[1]), vertex(corners[2])}, {kSide, kSide, kSide}});
  }

  void add_edges() {
    std::map<std::pair<int, int>, int> edge;
    for (const ReschTriangle& t : triangles_) {
      sheet_.faces.emplace_back(t.corners.begin(), t.corners.end());
      for (int k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t.corners[k], t.corners[(k + 1) % 3]);
        const auto [found, added] = edge.try_emplace({a, b}, sheet_.num_edges());
        if (added)
          sheet_.edges.push_back({a, b, Assignment::Boundary, 0});
        else
          sheet_.edges[found->second] = {a, b, assignment_of(t.folds[k]), t.folds[k]};
      }
    }
  }

  CreasePattern sheet_;
  std::map<Place, int> vertices_;
  std::vector<ReschTriangle> triangles_;
};

void expect_bends_are_told(const CreasePattern& sheet, double least_share) {
  const MotionOutcome whole = plan_origami(sheet, {.facets = FacetPolicy::None});
  const MotionOutcome cut = plan_origami(sheet);
  ASSERT_TRUE(cut.proven());
  EXPECT_GT(cut.progress, least_share);
  EXPECT_GT(cut.progress, whole.proven() ? whole.progress : 0);
  ASSERT_EQ(cut.bends.size(), sheet.faces.size());  // one a panel
  EXPECT_GT(*std::max_element(cut.bends.begin(), cut.bends.end()), radians(1));
  EXPECT_THAT(cut.notes, Contains(HasSubstr("cut by flat creases")));
}

// 80 % with the shortest diagonals, 91 % with others.
TEST(FacetMotion, ASquareTwistFoldsWithPanelsThatBend) { expect_bends_are_told(square_twist(), 0.88); }

TEST(FacetMotion, AHyparFoldsWithPanelsThatBend) { expect_bends_are_told(pleated_square(3), 0.15); }

TEST(FacetMotion, AReschTessellationFoldsToItsGoal) {
  const CreasePattern sheet = Resch().sheet();
  const MotionOutcome outcome = plan_origami(sheet);
  ASSERT_TRUE(outcome.proven());
  EXPECT_GT(outcome.progress, 0.98);
  EXPECT_TRUE(outcome.bends.empty());
}

TEST(FacetMotion, AMiuraNeedsNone) {
  const MotionOutcome outcome = plan_origami(miura({.columns = 4, .rows = 4}));
  ASSERT_TRUE(outcome.proven());
  EXPECT_EQ(outcome.ending, Ending::Found);
  EXPECT_TRUE(outcome.bends.empty());
  EXPECT_FALSE(outcome.sheet.has_value());
}

TEST(FacetMotion, FacetsOfAMiuraStayFlatWhenAllAreCut) {
  const MotionOutcome whole = plan_origami(miura({.columns = 3, .rows = 3}), {.facets = FacetPolicy::All});
  ASSERT_TRUE(whole.proven());
  EXPECT_GT(whole.progress, 0.98);
}

}  // namespace
}  // namespace plico
