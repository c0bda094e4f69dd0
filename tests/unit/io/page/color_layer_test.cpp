#include "plico/io/page/color_layer.h"

#include <gtest/gtest.h>

#include "plico/fabricate/fabricate.h"
#include "plico/geom/polygon.h"
#include "plico/io/page/dxf.h"
#include "plico/io/page/pdf.h"
#include "plico/io/page/svg.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

const std::vector<Color> kFaces{{0.9, 0, 0}, {0, 0.9, 0}, {0, 0, 0.9}, {0.9, 0.9, 0}};

struct Printed {
  PageLayout layout;
  PanelPaint paint;

  Drawing page(const DrawOptions& options = {}) const { return draw(layout, options, paint).at(0); }
};

// A tetrahedron of four colours.
Printed printed() {
  const Mesh mesh(tetrahedron());
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (const HalfedgeId h : mesh.halfedges(FaceId(0))) forest.is_fold[mesh.edge(h)] = 1;
  const Unfolding net = lay_flat(mesh, forest);
  LayoutOptions options;
  options.size.longest = 60;
  return {lay_out_pages(net, folded_shape(mesh), options).layout, plain_paint(net.sheet, kFaces)};
}

TEST(ColorLayer, EveryPanelHasItsColourAndItsTabsAStripOfIt) {
  const Printed model = printed();
  const Drawing page = model.page();
  for (const PlacedPart& part : model.layout.parts) {
    for (const PlacedPanel& panel : part.panels)
      EXPECT_EQ(color_under(page, centroid(panel.corners)), kFaces[panel.panel]);
    for (const Tab& tab : part.tabs) {
      const Vec2 middle = (tab.corners[0] + tab.corners[1]) / 2;
      const Vec2 out = -perpendicular(Vec2(tab.corners[1] - tab.corners[0])).normalized();
      const Color beside = color_under(page, middle - 0.5 * out);
      EXPECT_EQ(color_under(page, middle + (kBleed - 0.5) * out), beside);
      EXPECT_NE(color_under(page, middle + (kBleed + 0.5) * out), beside);
    }
  }
}

TEST(ColorLayer, StaysOffTheInsideOffBlackPrintersAndOffCutters) {
  const Printed model = printed();
  EXPECT_TRUE(model.page().is_painted());
  EXPECT_FALSE(model.page({.side = PaperSide::Inside}).is_painted());
  EXPECT_FALSE(model.page({.color = false}).is_painted());
  EXPECT_FALSE(model.page({.style = DrawStyle::Laser}).is_painted());
  const std::vector<Drawing> both = draw(model.layout, {.side = PaperSide::Both}, model.paint);
  EXPECT_TRUE(both.at(0).is_painted());
  EXPECT_FALSE(both.at(1).is_painted());
  EXPECT_EQ(write_dxf(model.page()), write_dxf(model.page({.color = false})));
}

TEST(ColorLayer, IsALayerOfItsOwnInFilesOfPaintedModelsOnly) {
  const Printed model = printed();
  EXPECT_NE(write_svg(model.page()).find("id=\"COLOR\""), std::string::npos);
  EXPECT_EQ(write_svg(model.page({.color = false})).find("COLOR"), std::string::npos);
  EXPECT_NE(write_pdf({model.page()}, "t", "c").find("(COLOR)"), std::string::npos);
  EXPECT_EQ(write_pdf({model.page({.color = false})}, "t", "c").find("COLOR"), std::string::npos);
}

}  // namespace
}  // namespace plico
