#include "plico/io/page/svg.h"

#include <gtest/gtest.h>

#include <regex>

namespace plico {
namespace {

// A page with one cut from the origin.
Drawing page_of(double width, double height) {
  Drawing page;
  page.size = {width, height};
  page.title = "a page";
  page.pens.push_back(Pen{});
  page.strokes.push_back({Layer::Cut, {Vec2(0, 0), Vec2(100, 0)}, false, 0});
  return page;
}

int count(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

TEST(Svg, SeveralPagesStandInARowInOneLayerEach) {
  const std::string svg = write_svg(std::vector<Drawing>{page_of(210, 297), page_of(297, 210), page_of(210, 297)});
  EXPECT_NE(svg.find("width=\"737mm\" height=\"297mm\" viewBox=\"0 0 737 297\""), std::string::npos);
  EXPECT_EQ(count(svg, "<inkscape:page "), 3);
  EXPECT_EQ(count(svg, "x=\"220\" y=\"0\" width=\"297\" height=\"210\""), 1);
  EXPECT_EQ(count(svg, "id=\"CUT\""), 1);
  EXPECT_EQ(count(svg, "M0 297L100 297"), 2);
  EXPECT_EQ(count(svg, "M0 210L100 210"), 1);
  EXPECT_EQ(count(svg, R"(translate\(527 0\))"), 5);  // in each layer
}

TEST(Svg, OnePageIsWrittenAsItIs) {
  const Drawing page = page_of(210, 297);
  EXPECT_EQ(write_svg(std::vector<Drawing>{page}), write_svg(page));
  EXPECT_EQ(count(write_svg(page), "inkscape:page|translate"), 0);
}

}  // namespace
}  // namespace plico
