#include "plico/origami/assign.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/fold/planar_faces.h"
#include "plico/origami/bases.h"
#include "plico/origami/pattern_check.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> in_radians(std::vector<double> sectors) {
  for (double& sector : sectors) sector = radians(sector);
  return sectors;
}

// Of all choices at a vertex with these sectors, how many fold flat.
int num_flat(const std::vector<double>& sectors) {
  int count = 0;
  for (unsigned choice = 0; choice < 1U << sectors.size(); ++choice) {
    std::vector<int> folds;
    for (std::size_t i = 0; i < sectors.size(); ++i) folds.push_back(choice >> i & 1U ? 1 : -1);
    count += folds_flat(in_radians(sectors), folds);
  }
  return count;
}

CreasePattern without_letters(CreasePattern sheet) {
  for (Crease& crease : sheet.edges)
    if (crease.assignment == Assignment::Mountain || crease.assignment == Assignment::Valley)
      crease.assignment = Assignment::Unassigned, crease.fold_angle = 0;
  return sheet;
}

// A triangle whose sides carry squares: at each corner the triangle's 60 degrees lie between 90 and 90, so every two
// of its three sides must fold to different sides.
CreasePattern triangle_of_squares() {
  CreasePattern sheet;
  const double h = std::sqrt(3.0) / 2;
  sheet.vertices = {{0, 0}, {1, 0}, {0.5, h}};
  for (int i = 0; i < 3; ++i) sheet.edges.push_back({i, (i + 1) % 3, Assignment::Unassigned});
  for (int i = 0; i < 3; ++i) {
    const Vec2 along = sheet.vertices[(i + 1) % 3] - sheet.vertices[i], out(along.y(), -along.x());
    for (int end : {i, (i + 1) % 3}) {
      sheet.vertices.push_back(sheet.vertices[end] + out);
      sheet.edges.push_back({end, sheet.num_vertices() - 1, Assignment::Unassigned});
    }
  }
  for (int i = 0; i < 6; ++i) sheet.edges.push_back({3 + i, 3 + (i + 1) % 6, Assignment::Boundary});
  sheet.faces = planar_faces(sheet.vertices, sheet.edges);
  return sheet;
}

TEST(FoldsFlat, EqualSectorsWantMountainsAndValleysToDifferByTwo) {
  EXPECT_EQ(num_flat({90, 90, 90, 90}), 8);           // 2 * (4 choose 1)
  EXPECT_EQ(num_flat({60, 60, 60, 60, 60, 60}), 30);  // 2 * (6 choose 2)
}

TEST(FoldsFlat, ALittleSectorBetweenBigOnesHasAMountainAndAValley) {
  const std::vector<double> sectors = in_radians({100, 40, 80, 140});
  EXPECT_TRUE(folds_flat(sectors, {1, 1, -1, 1}));
  EXPECT_FALSE(folds_flat(sectors, {-1, 1, 1, 1}));
  EXPECT_EQ(num_flat({100, 40, 80, 140}), 4);
}

TEST(FoldsFlat, TwoEqualLittleSectorsLeaveOneCrease) {
  EXPECT_EQ(num_flat({40, 40, 140, 140}), 6);  // 3 choices of the run that leave a valley, then 90-90 with it: 2 * 3
}

TEST(FoldsFlat, SectorsThatMissKawasakiNeverDo) {
  EXPECT_EQ(num_flat({80, 100, 110, 70}), 0);
  EXPECT_EQ(num_flat({120, 120, 120}), 0);
}

TEST(Assign, GivesEveryCreaseALetterThatItsVerticesFoldFlatWith) {
  for (const CreasePattern& sheet : {miura({.columns = 5, .rows = 4}), square_twist(), waterbomb_base(), sailboat()}) {
    const AssignResult found = assign_creases(without_letters(sheet));
    ASSERT_EQ(found.ending, Ending::Found);
    EXPECT_GT(found.assigned, 0);
    for (const VertexFacts& facts : vertex_facts(found.sheet)) {
      EXPECT_EQ(facts.mountains + facts.valleys, static_cast<int>(facts.edges.size()));
      EXPECT_LT(facts.residual, 1e-6);
      EXPECT_EQ(std::abs(facts.mountains - facts.valleys), 2);
    }
  }
}

TEST(Assign, KeepsTheLettersThatAreThere) {
  CreasePattern sheet = without_letters(miura({.columns = 4, .rows = 4}));
  const std::vector<int> hinge = hinge_of_edge(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e)
    if (hinge[e] == 3) sheet.edges[e].assignment = Assignment::Mountain, sheet.edges[e].fold_angle = -kPi;
  const AssignResult found = assign_creases(sheet), again = assign_creases(sheet);
  ASSERT_EQ(found.ending, Ending::Found);
  for (int e = 0; e < sheet.num_edges(); ++e) {
    EXPECT_EQ(found.sheet.edges[e].assignment, again.sheet.edges[e].assignment);
    EXPECT_TRUE(hinge[e] != 3 || found.sheet.edges[e].assignment == Assignment::Mountain);
  }
}

TEST(Assign, GoesOnToTheNextChoiceWhenOneDoesNotSuit) {
  const CreasePattern sheet = without_letters(waterbomb_base());
  AssignOptions options;
  int asked = 0;
  options.suits = [&](const CreasePattern&) { return ++asked == 3; };
  const AssignResult third = assign_creases(sheet, options);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(third.suits);
  options.suits = [&](const CreasePattern&) { return false; };
  options.max_refused = 4;
  const AssignResult first = assign_creases(sheet, options);
  EXPECT_EQ(first.ending, Ending::Found);
  EXPECT_FALSE(first.suits);
  EXPECT_NE(goal(make_linkage(first.sheet)), goal(make_linkage(third.sheet)));
}

TEST(Assign, NamesTheVertexThatCannotFoldFlat) {
  CreasePattern sheet = without_letters(square_twist());
  const int moved = vertex_facts(sheet).front().vertex;
  sheet.vertices[moved] += Vec2(0.05, 0.02);
  const AssignResult found = assign_creases(sheet);
  EXPECT_EQ(found.ending, Ending::Exhausted);
  ASSERT_EQ(found.vertices.size(), 1u);
  EXPECT_THAT(found.why, HasSubstr("(Kawasaki)"));
  EXPECT_EQ(found.assigned, 0);
}

TEST(Assign, NamesTheVerticesThatCannotFoldFlatTogether) {
  const AssignResult found = assign_creases(triangle_of_squares());
  EXPECT_EQ(found.ending, Ending::Exhausted);
  EXPECT_THAT(found.vertices, ElementsAre(0, 1, 2));
  EXPECT_THAT(found.why, HasSubstr("these 3 do not together"));
}

TEST(Assign, ARunThatIsOverEndsIt) {
  std::stop_source stop;
  stop.request_stop();
  plico::Run run;
  run.stop = stop.get_token();
  EXPECT_EQ(assign_creases(without_letters(square_twist()), {}, run).ending, Ending::Stopped);
}

TEST(Assign, RefusesATolerance0) { EXPECT_THROW(assign_creases(square_twist(), {.angle = 0}), InvalidOption); }

}  // namespace
}  // namespace plico
