#include "plico/io/motion/angle_plot.h"

#include <gmock/gmock.h>

#include "linkage_samples.h"
#include "plico/base/error.h"

namespace plico {
namespace {

using testing::HasSubstr;
using testing::Not;

int count(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(AnglePlot, CreasesThatMoveAlikeShareACurve) {
  const Linkage linkage = make_linkage(square_strip({1, -1, 0.5, 0, 1}));
  const std::string svg = write_angle_plot(linear_path(linkage), {.title = "a < b"});
  EXPECT_EQ(count(svg, "<polyline"), 2);
  EXPECT_THAT(svg, HasSubstr("1 mountain, 2 valleys"));
  EXPECT_THAT(svg, HasSubstr(">1 valley<"));
  EXPECT_THAT(svg, HasSubstr("1 stays flat"));
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_EQ(svg, write_angle_plot(linear_path(linkage), {.title = "a < b"}));
  EXPECT_THAT(write_angle_plot(linear_path(linkage), {.title = "a\x01 & b"}), HasSubstr(">a &amp; b<"));
}

TEST(AnglePlot, SmallGroupsAreGrey) {
  const Linkage linkage = make_linkage(square_strip({0.1, 0.2, 0.3, 0.3, 0.4}));
  const std::string svg = write_angle_plot(linear_path(linkage), {.curves_in_color = 2});
  EXPECT_THAT(svg, HasSubstr(">2 valleys<"));
  EXPECT_THAT(svg, HasSubstr("2 more, 2 curves"));
  EXPECT_EQ(count(svg, "<polyline"), 4);
}

TEST(AnglePlot, NothingToPlotAndBadOptions) {
  const Linkage still = make_linkage(square_strip({0}));
  EXPECT_THAT(write_angle_plot(linear_path(still)), Not(HasSubstr("<polyline")));
  EXPECT_THROW(write_angle_plot({}), InvalidInput);
  EXPECT_THROW(write_angle_plot(linear_path(still), {.curves_in_color = 9}), InvalidOption);
}

}  // namespace
}  // namespace plico
