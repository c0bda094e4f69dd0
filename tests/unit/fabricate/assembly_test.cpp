#include "plico/fabricate/assembly.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plico/fabricate/fabricate.h"
#include "plico/shapes/shapes.h"
#include "plico/verify/page_layout.h"

namespace plico {
namespace {

// Every face of a cube by itself.
Unfolding loose_cube(const Mesh& mesh) { return lay_flat(mesh, {std::vector<char>(mesh.num_edges(), 0)}); }

TEST(Assembly, EveryStepIsGluedOntoEarlierOnes) {
  const Mesh mesh(cube());
  const Unfolding net = loose_cube(mesh);
  const std::vector<AssemblyStep> steps = assembly_order(NetSides(net));
  ASSERT_EQ(steps.size(), 6U);
  EXPECT_EQ(steps[0].part, 0);
  EXPECT_TRUE(steps[0].onto.empty());
  std::vector<int> built;
  for (const AssemblyStep& step : steps) {
    EXPECT_EQ(step.onto.empty(), built.empty());
    for (int other : step.onto) EXPECT_NE(std::find(built.begin(), built.end(), other), built.end());
    built.push_back(step.part);
  }
  EXPECT_EQ(steps[5].onto.size(), 4U);  // the last face closes the cube
}

TEST(Assembly, AGivenOrderIsKept) {
  const Mesh mesh(cube());
  const Unfolding net = loose_cube(mesh);
  const std::vector<AssemblyStep> steps = assembly_order(NetSides(net), {6, 5, 4, 3, 2, 1});
  for (int i = 0; i < 6; ++i) EXPECT_EQ(steps[i].part, 5 - i);
}

TEST(Assembly, PartsAreLetteredAndPagesFollowInTheOrderOfAssembly) {
  const Mesh mesh(cube());
  LayoutOptions options;
  options.size.longest = 110;  // one or two faces a page
  const LayoutReport lettered = lay_out_pages(loose_cube(mesh), folded_shape(mesh), options).report;
  ASSERT_GT(lettered.pages, 2);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(lettered.part_names[lettered.steps[i].part], std::string(1, 'A' + i));
  options.rank = {6, 5, 4, 3, 2, 1};
  options.titles = {{"A", ""}, {"B", ""}, {"C", ""}, {"D", ""}, {"E", ""}, {"F", ""}};
  const LayoutReport named = lay_out_pages(loose_cube(mesh), folded_shape(mesh), options).report;
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(named.part_names[named.steps[i].part], std::string(1, 'F' - i));
  for (const LayoutReport& report : {lettered, named}) {
    int latest = -1;  // of the first pages that are opened, none waits for a later one
    for (const AssemblyStep& step : report.steps) {
      EXPECT_LE(report.page_of_part[step.part], latest + 1);
      latest = std::max(latest, report.page_of_part[step.part]);
    }
  }
}

TEST(Assembly, PagesShowWhereTheirPartsAreAndTheirStepsAndTheJudgeLooksAtThePicture) {
  const Mesh mesh(cube());
  const Unfolding net = loose_cube(mesh);
  LayoutOptions options;
  options.size.longest = 60;
  LayoutResult result = lay_out_pages(net, folded_shape(mesh), options);
  EXPECT_EQ(result.report.pages_without_picture, 0);
  for (int page = 0; page < result.report.pages; ++page) {
    const Inset& inset = result.layout.pages[page].inset.value();
    const auto here = std::count_if(inset.panels.begin(), inset.panels.end(), [](const auto& p) { return p.here; });
    const auto parts = std::count_if(result.layout.parts.begin(), result.layout.parts.end(),
                                     [&](const PlacedPart& p) { return p.page == page; });
    EXPECT_EQ(inset.panels.size(), 6U);
    EXPECT_EQ(here, parts);
    EXPECT_EQ(inset.lines.front().substr(0, 5), "step ");
  }
  EXPECT_TRUE(verify_layout(result.layout).sound());
  result.layout.pages[0].inset->at = result.layout.parts[0].panels[0].corners[0] - Vec2(5, 5);
  EXPECT_FALSE(verify_layout(result.layout).sound());
}

}  // namespace
}  // namespace plico
