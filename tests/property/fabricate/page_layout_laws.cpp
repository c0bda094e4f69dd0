#include <gmock/gmock.h>

#include "fabricate_samples.h"
#include "plico/fabricate/fabricate.h"
#include "plico/fabricate/net_sides.h"
#include "plico/io/page/drawing.h"
#include "plico/io/page/dxf.h"
#include "plico/io/page/pdf.h"
#include "plico/io/page/svg.h"
#include "plico/verify/page_layout.h"

namespace plico {
namespace {

using testing::IsEmpty;

// A star of random radii cut open by a random spanning tree: its unfolding may overlap itself.
struct RandomNet {
  Mesh mesh;
  Unfolding net;
};

RandomNet random_net(Rng& rng) {
  const Rng radii = rng.stream(1);
  const Mesh mesh =
      samples::ball(2 + rng.below(5), 4 + rng.below(6), [&](int v) { return radii.stream(v).uniform(0.6, 1.2); });
  SearchOptions options;
  options.seed = rng.next();
  return {mesh, lay_flat(mesh, find_net(mesh, options).forest)};
}

LayoutOptions random_options(Rng& rng) {
  LayoutOptions options;
  options.size.longest = rng.uniform(40, 160);
  options.page.size = rng.below(2) ? Vec2(210, 297) : Vec2(279.4, 215.9);
  options.page.margin = rng.uniform(0, 15);
  options.place.gap = rng.uniform(0, 6);
  options.tabs.side = static_cast<TabSide>(rng.below(6));
  options.tabs.depth = rng.uniform(2, 9);
  options.tabs.angle = radians(rng.uniform(25, 75));
  options.marks = {rng.below(2) == 1, rng.below(2) == 1};
  options.split = true;
  return options;
}

TEST(SheetLaw, RandomNetsWithRandomOptionsAreSound) {
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const RandomNet r = random_net(rng);
    const LayoutResult result = lay_out_pages(r.net, folded_shape(r.mesh), random_options(rng));
    EXPECT_THAT(verify_layout(result.layout).problems, IsEmpty());
    EXPECT_EQ(result.report.pages, static_cast<int>(result.layout.pages.size()));
  }
}

TEST(SheetLaw, PlacingIsARigidMotionThatMirrorsNothing) {
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const RandomNet r = random_net(rng);
    LayoutOptions options = random_options(rng);
    options.size.longest = 50;
    const LayoutResult result = lay_out_pages(r.net, folded_shape(r.mesh), options);
    std::vector<int> next(result.layout.parts.size(), 0);
    ASSERT_EQ(result.report.folds_cut, 0);
    for (int f = 0; f < r.net.sheet.num_faces(); ++f) {
      const PlacedPanel& panel = result.layout.parts[r.net.part[f]].panels[next[r.net.part[f]]++];
      const std::vector<Vec2> before = polygon(r.net.sheet, f);
      for (std::size_t i = 0; i + 2 < before.size(); ++i) {
        const Vec2 a = before[i + 1] - before[i], b = before[i + 2] - before[i];
        const Vec2 p = panel.corners[i + 1] - panel.corners[i], q = panel.corners[i + 2] - panel.corners[i];
        const double s = result.report.scale;
        EXPECT_NEAR(p.norm(), s * a.norm(), 1e-9);
        EXPECT_NEAR(cross(p, q), s * s * cross(a, b), 1e-9);
      }
    }
  }
}

TEST(SheetLaw, CuttingFoldsKeepsPanelsInPlaceAndPairsTheNewEdges) {
  for (int seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const RandomNet r = random_net(rng);
    const NetSides sides(r.net);
    std::vector<char> is_cut(r.net.sheet.num_edges(), 0);
    int cuts = 0;
    for (int e = 0; e < r.net.sheet.num_edges(); ++e)
      if (sides.is_fold(e) && rng.below(5) == 0) is_cut[e] = 1, ++cuts;
    const Unfolding cut = cut_folds(r.net, is_cut);
    EXPECT_EQ(cut.num_parts(), r.net.num_parts() + cuts);
    EXPECT_EQ(cut.sheet.num_edges(), r.net.sheet.num_edges() + cuts);
    for (int f = 0; f < r.net.sheet.num_faces(); ++f) EXPECT_EQ(polygon(cut.sheet, f), polygon(r.net.sheet, f));
    for (int e = 0; e < cut.sheet.num_edges(); ++e) {
      if (cut.mate[e] < 0) continue;
      EXPECT_EQ(cut.mate[cut.mate[e]], e);
      EXPECT_EQ(cut.mesh_edge[cut.mate[e]], cut.mesh_edge[e]);
    }
  }
}

TEST(SheetLaw, TheSameSheetGivesTheSameBytes) {
  for (int seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const RandomNet r = random_net(rng);
    const LayoutOptions options = random_options(rng);
    const auto bytes = [&] {
      const std::vector<Drawing> pages = draw(lay_out_pages(r.net, folded_shape(r.mesh), options).layout);
      return write_pdf(pages, "net", "plico") + write_svg(pages[0]) + write_dxf(pages[0]);
    };
    EXPECT_EQ(bytes(), bytes());
  }
}

}  // namespace
}  // namespace plico
