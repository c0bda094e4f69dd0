#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "fabricate_samples.h"
#include "plico/base/error.h"
#include "plico/fabricate/fabricate.h"
#include "plico/fabricate/net_sides.h"
#include "plico/fabricate/split.h"
#include "plico/verify/page_layout.h"

namespace plico {
namespace {

using samples::cube;
using samples::net_of;
using testing::HasSubstr;
using testing::IsEmpty;

LayoutOptions of_longest(double mm) {
  LayoutOptions options;
  options.size.longest = mm;
  return options;
}

LayoutResult cube_sheet(const LayoutOptions& options) {
  const Mesh mesh = cube();
  return lay_out_pages(net_of(mesh), folded_shape(mesh), options);
}

TEST(PageLayout, EveryShapeIsSoundAtTwoSizes) {
  for (const auto& [name, mesh] : samples::shapes()) {
    SCOPED_TRACE(name);
    const Unfolding net = net_of(mesh);
    const FoldedShape shape = folded_shape(mesh);
    for (double longest : {60.0, 140.0}) {
      LayoutOptions options = of_longest(longest);
      options.split = true;
      const LayoutResult result = lay_out_pages(net, shape, options);
      EXPECT_THAT(verify_layout(result.layout).problems, IsEmpty());
      EXPECT_GT(result.report.fill_ratio, 0);
      EXPECT_LT(result.report.fill_ratio, 1);
      std::size_t panels = 0;
      for (const PlacedPart& part : result.layout.parts) panels += part.panels.size();
      EXPECT_EQ(static_cast<int>(panels), mesh.num_faces());
    }
  }
}

// The cube's faces as six parts, so that there is much to place.
LayoutResult cube_in_six(const std::vector<PanelPlace>& places) {
  const Mesh mesh = cube();
  LayoutOptions options = of_longest(40);
  options.places = places;
  return lay_out_pages(lay_flat(mesh, FoldForest{std::vector<char>(mesh.num_edges(), 0)}), folded_shape(mesh), options);
}

TEST(PageLayout, APartLiesWhereItIsToldAndTheOthersGoAround) {
  const LayoutResult result = cube_in_six({{.panel = 3, .page = 1, .at = {100, 120}, .angle = radians(30)}});
  EXPECT_THAT(verify_layout(result.layout).problems, IsEmpty());
  const PlacedPart& part = result.layout.parts[result.report.printed_part[3]];
  const std::vector<Vec2>& corners = part.panels[0].corners;
  EXPECT_EQ(part.page, 1);
  EXPECT_NEAR((corners[0] - Vec2(100, 120)).norm(), 0, 1e-9);
  EXPECT_NEAR((corners[1] - corners[0]).normalized().y(), 0.5, 1e-9);
}

TEST(PageLayout, WhatItTellsOfPlacesLaysTheSamePage) {
  const LayoutResult first = cube_in_six({});
  const LayoutResult again = cube_in_six(first.report.places);
  ASSERT_EQ(again.report.pages, first.report.pages);
  for (std::size_t p = 0; p < first.layout.parts.size(); ++p)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR((again.layout.parts[p].panels[0].corners[i] - first.layout.parts[p].panels[0].corners[i]).norm(), 0,
                  1e-9);
}

TEST(PageLayout, PlacesThatOverlapOrLeaveThePaperAreToldByTheJudge) {
  const PanelPlace a{.panel = 0, .page = 0, .at = {80, 80}}, b{.panel = 1, .page = 0, .at = {90, 90}};
  EXPECT_GT(verify_layout(cube_in_six({a, b}).layout).overlaps, 0);
  EXPECT_GT(verify_layout(cube_in_six({{.panel = 0, .page = 0, .at = {2, 150}}}).layout).off_page, 0);
  EXPECT_THROW(cube_in_six({{.panel = 6}}), InvalidOption);
  EXPECT_THROW(cube_in_six({{.panel = 0, .page = 6}}), InvalidOption);
}

TEST(PageLayout, TheCubeHasSevenTabsOfFullDepth) {
  const LayoutReport report = cube_sheet(of_longest(40)).report;
  EXPECT_EQ(report.tabs.full, 7);
  EXPECT_EQ(report.tabs.omitted, 0);
  EXPECT_EQ(report.labels.placed, 14);
}

// The texts of the labels of a part, sorted.
std::vector<std::string> texts(const PlacedPart& part) {
  std::vector<std::string> all;
  for (const Label& label : part.labels) all.push_back(label.text);
  std::ranges::sort(all);
  return all;
}

TEST(PageLayout, AnIdIsANumberAndThePartThatTheOtherEdgeIsOn) {
  Unfolding net = net_of(cube());
  const NetSides sides(net);
  std::vector<char> cuts(net.sheet.num_edges());
  for (int e = 0; e < net.sheet.num_edges() && !std::ranges::count(cuts, 1); ++e) cuts[e] = sides.is_fold(e);
  net = cut_folds(net, cuts);
  ASSERT_EQ(net.num_parts(), 2);
  LayoutOptions options = of_longest(30);
  options.titles = {{"A", "head"}, {"B", ""}};
  const LayoutResult result = lay_out_pages(net, folded_shape(cube()), options);
  ASSERT_EQ(result.layout.parts.size(), 2u);
  std::set<std::string> here, there;
  for (const std::string& text : texts(result.layout.parts[0]))
    if (text.starts_with("B")) here.insert(text.substr(1));
  for (const std::string& text : texts(result.layout.parts[1]))
    if (text.starts_with("A")) there.insert(text.substr(1));
  EXPECT_FALSE(here.empty());
  EXPECT_EQ(here.count("1"), 1u);
  EXPECT_THAT(texts(result.layout.parts[0]), testing::Contains("A head, step 1"));
  for (const std::string& number : here) EXPECT_TRUE(there.contains(number)) << number;
}

TEST(PageLayout, SeamNumbersThatAreKnownAreKept) {
  Unfolding net = net_of(cube());
  const NetSides sides(net);
  std::vector<char> cuts(net.sheet.num_edges());
  for (int e = 0; e < net.sheet.num_edges(); ++e) cuts[e] = sides.is_fold(e);
  net = cut_folds(net, cuts);  // six squares, every seam between two of them
  LayoutOptions options = of_longest(30);
  options.seams.assign(net.sheet.num_edges(), 0);
  options.seams[0] = options.seams[net.mate[0]] = 77;
  int seen = 0;
  for (const PlacedPart& part : lay_out_pages(net, folded_shape(cube()), options).layout.parts)
    for (const std::string& text : texts(part)) seen += text.ends_with("77");
  EXPECT_EQ(seen, 2);
}

TEST(PageLayout, ASideHasTheAskedLength) {
  const LayoutResult cube_37 = cube_sheet(of_longest(37));
  for (const FoldLine& fold : cube_37.layout.parts[0].folds) EXPECT_NEAR((fold.a - fold.b).norm(), 37, 1e-9);
}

TEST(PageLayout, HeightIsMeasuredAlongTheUpAxis) {
  const Mesh mesh = samples::prism(samples::regular(4), 5);
  LayoutOptions options;
  options.size.height = 50;
  options.size.up = 'z';
  EXPECT_NEAR(lay_out_pages(net_of(mesh), folded_shape(mesh), options).report.scale, 10, 1e-9);
  options.size.up = 'y';
  options.size.height = 20;
  EXPECT_NEAR(lay_out_pages(net_of(mesh), folded_shape(mesh), options).report.scale, 10, 1e-9);
}

TEST(PageLayout, TwoSizesContradictEachOther) {
  LayoutOptions options = of_longest(40);
  options.size.width = 30;
  EXPECT_THROW(cube_sheet(options), InvalidOption);
}

TEST(PageLayout, BothEdgesOfASeamHaveTheSameIdAndNoOtherHas) {
  const Mesh mesh = samples::torus(6, 4);
  const Unfolding net = net_of(mesh);
  const LayoutResult result = lay_out_pages(net, folded_shape(mesh), of_longest(110));
  ASSERT_EQ(result.report.labels.omitted, 0);
  std::multiset<std::string> ids;
  for (const PlacedPart& part : result.layout.parts)
    for (const Label& label : part.labels) ids.insert(label.text);
  for (const std::string& id : ids) EXPECT_EQ(ids.count(id), 2u) << id;
  EXPECT_EQ(static_cast<int>(ids.size()), result.report.labels.placed + result.report.labels.leaders);
}

TEST(PageLayout, APartTooLargeNamesTheSizeThatFits) {
  try {
    cube_sheet(of_longest(120));
    FAIL() << "a cube net of 120 mm sides cannot fit A4";
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.code(), "fabricate/part-too-large");
    const std::string& hint = error.suggestion();
    ASSERT_THAT(hint, HasSubstr("--longest "));
    const double fits = std::stod(hint.substr(hint.find("--longest ") + 10));
    EXPECT_GT(fits, 50);
    EXPECT_NO_THROW(cube_sheet(of_longest(fits)));
  }
}

TEST(PageLayout, SplittingKeepsEveryPanelAndMatesTheNewSeams) {
  LayoutOptions options = of_longest(120);
  options.split = true;
  const LayoutResult result = cube_sheet(options);
  EXPECT_GT(result.report.parts, 1);
  EXPECT_EQ(result.report.folds_cut, result.report.parts - 1);
  EXPECT_EQ(result.report.labels.placed, 2 * (7 + result.report.folds_cut));
  EXPECT_TRUE(verify_layout(result.layout).sound());
}

// Pieces grow towards every panel of so small a net, so it does not matter which panel comes first.
TEST(PageLayout, SplitsAreTheSameHoweverPanelsAreNumbered) {
  for (int seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const auto radius = [seed](int v) { return Rng(seed).stream(v).uniform(0.5, 1.3); };
    Unfolding net = net_of(samples::ball(2, 5, radius));
    const std::vector<char> cuts = cuts_to_fit(NetSides(net), Vec2(2.5, 3));
    EXPECT_GT(std::ranges::count(cuts, 1), 0);
    std::ranges::reverse(net.sheet.faces);
    EXPECT_EQ(cuts_to_fit(NetSides(net), Vec2(2.5, 3)), cuts);
  }
}

TEST(PageLayout, APanelTooLargeIsAnErrorEvenWhenSplitting) {
  LayoutOptions options = of_longest(250);
  options.split = true;
  try {
    cube_sheet(options);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_EQ(error.code(), "fabricate/panel-too-large");
  }
}

TEST(PageLayout, FlatFoldsAreMarkedFlat) {
  const Mesh mesh = samples::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                                     {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  int flat = 0;
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges())  // a tree that keeps the diagonal of the base
    forest.is_fold[e] = mesh.face(mesh.halfedge(e)) == 0 || mesh.face(mesh.halfedge(e)) == 1;
  const LayoutResult result = lay_out_pages(lay_flat(mesh, forest), folded_shape(mesh), of_longest(60));
  for (const FoldLine& fold : result.layout.parts[0].folds) flat += fold.assignment == Assignment::Flat;
  EXPECT_EQ(flat, 1);
}

TEST(PageLayout, EveryPageHasALegendAndARulerOfAHundredMillimetres) {
  LayoutOptions options = of_longest(110);
  options.split = true;
  const LayoutResult result = cube_sheet(options);
  for (const Page& page : result.layout.pages) {
    EXPECT_NE(page.key_form, KeyForm::None);
    EXPECT_EQ(page.ruler, 100);
  }
}

TEST(Tabs, RulesForTheSide) {
  const auto tabs = [](TabSide side) {
    LayoutOptions options = of_longest(40);
    options.tabs.side = side;
    return cube_sheet(options).report.tabs.tabs.size();
  };
  EXPECT_EQ(tabs(TabSide::None), 0u);
  EXPECT_EQ(tabs(TabSide::First), 7u);
  EXPECT_EQ(tabs(TabSide::Second), 7u);
  EXPECT_EQ(tabs(TabSide::Alternate), 7u);
  EXPECT_GT(tabs(TabSide::Both), 7u);
}

TEST(Tabs, VeryShortEdgesHaveNone) {
  const LayoutReport report = cube_sheet(of_longest(2.5)).report;
  EXPECT_EQ(report.tabs.tabs.size(), 0u);
  EXPECT_EQ(report.tabs.short_seams, 7);
}

TEST(Tabs, SeamsWithoutATabAreMarkedOnBothEdges) {
  const Mesh mesh = cube();
  LayoutOptions options = of_longest(40);
  options.tabs.shortest_edge = 41;
  const LayoutResult result = lay_out_pages(net_of(mesh), folded_shape(mesh), options);
  EXPECT_TRUE(result.layout.has_taped_seams);
  for (const Label& label : result.layout.parts[0].labels) EXPECT_TRUE(label.text.ends_with("°")) << label.text;
  EXPECT_FALSE(cube_sheet(of_longest(40)).layout.has_taped_seams);
}

TEST(Tabs, OptionsOutOfRangeAreNamed) {
  LayoutOptions options = of_longest(40);
  options.tabs.angle = radians(85);
  EXPECT_THROW(cube_sheet(options), InvalidOption);
  options.tabs.angle = radians(45);
  options.tabs.depth = 0;
  EXPECT_THROW(cube_sheet(options), InvalidOption);
}

TEST(Page, SizesByNameAndByNumbers) {
  EXPECT_EQ(paper_size("A4"), Vec2(210, 297));
  EXPECT_EQ(paper_size("letter"), Vec2(215.9, 279.4));
  EXPECT_NEAR((paper_size("12x18in") - Vec2(304.8, 457.2)).norm(), 0, 1e-9);
  EXPECT_THROW(paper_size("napkin"), InvalidOption);
  EXPECT_THROW(paper_size("x20"), InvalidOption);
}

TEST(Page, IsoSheetsHalveAndMarginsDifferBySide) {
  EXPECT_EQ(paper_size("A0"), Vec2(841, 1189));
  EXPECT_EQ(paper_size("a5"), Vec2(148, 210));
  EXPECT_EQ(paper_size("B4"), Vec2(250, 353));
  const Margins m = parse_margins("8,12mm,2cm,1");
  EXPECT_EQ(m.low(), Vec2(1, 20));
  EXPECT_EQ(m.high(), Vec2(12, 8));
  EXPECT_EQ(printable({{100, 100}, m}), Vec2(87, 72));
  EXPECT_THROW(parse_margins("1,2,3"), InvalidOption);
}

TEST(Marks, EverySeamHasTwoStrokesAndEveryPartASquare) {
  LayoutOptions options = of_longest(40);
  options.marks = {true, true};
  const LayoutResult result = cube_sheet(options);
  int squares = 0, strokes = 0;
  for (const Mark& mark : result.layout.parts[0].marks) ++(mark.closed ? squares : strokes);
  EXPECT_EQ(squares, 1);
  EXPECT_EQ(strokes, 14);
}

// The judge itself must see faults.
TEST(VerifySheet, SeesPanelsThatOverlapTabsThatStickOutAndPartsOffThePage) {
  const LayoutResult result = cube_sheet(of_longest(40));
  PageLayout layout = result.layout;
  layout.parts.push_back(layout.parts[0]);
  EXPECT_GE(verify_layout(layout).overlaps, 6);

  layout = result.layout;
  Tab& tab = layout.parts[0].tabs[0];
  const Vec2 out = tab.corners[3] - tab.corners[0];
  tab.corners[2] += 10 * out;
  tab.corners[3] += 10 * out;
  EXPECT_GE(verify_layout(layout).misfit_tabs, 1);

  layout = result.layout;
  layout.parts[0].panels[0].corners[0] = Vec2(3, 4);
  EXPECT_GE(verify_layout(layout).off_page, 1);
  EXPECT_GE(verify_layout(layout).open_outlines, 1);
}

}  // namespace
}  // namespace plico
