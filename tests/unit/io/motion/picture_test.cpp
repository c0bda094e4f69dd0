// Stills and the viewer page.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "linkage_samples.h"
#include "plico/base/error.h"
#include "plico/io/motion/png.h"
#include "plico/io/motion/viewer.h"

namespace plico {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

using Pixel = std::array<int, 4>;
Pixel pixel(const Picture& picture, int x, int y) {
  const std::uint8_t* at = picture.rgba.data() + 4 * (std::size_t(y) * picture.width + x);
  return {at[0], at[1], at[2], at[3]};
}

PictureOptions from_above() {
  PictureOptions options;
  options.width = options.height = 64;
  options.transparent = true;
  options.camera.azimuth = 0;
  options.camera.elevation = radians(89.9);
  return options;
}

TEST(Picture, FrontAndBackHaveTheirOwnColours) {
  const Linkage linkage = make_linkage(square_strip({0}));
  PictureOptions options = from_above();
  const Pixel front = pixel(render(linkage, flat(linkage), options), 20, 32);
  options.camera.elevation = radians(-89.9);
  const Pixel back = pixel(render(linkage, flat(linkage), options), 20, 32);
  EXPECT_EQ(front[3], 255);
  EXPECT_EQ(back[3], 255);
  EXPECT_GT(front[0] - front[2], 60);  // amber
  EXPECT_LT(back[0] - back[2], 40);    // paper
}

TEST(Picture, EverythingFitsAndTheRestIsTransparent) {
  const Linkage linkage = make_linkage(square_strip({0}));
  const Picture picture = render(linkage, flat(linkage), from_above());
  int covered = 0;
  for (int i = 0; i < 64; ++i) {
    for (const Pixel& p : {pixel(picture, i, 0), pixel(picture, i, 63), pixel(picture, 0, i), pixel(picture, 63, i)})
      EXPECT_EQ(p[3], 0);
    covered += pixel(picture, i, 32)[3] == 255;
  }
  EXPECT_NEAR(covered, 0.86 * 64, 3);  // the strip is wider than high and fills the width up to the margin
}

TEST(Picture, NearerPanelsHideFartherOnes) {
  // The right square lies on the left one, its back up.
  const Linkage linkage = make_linkage(square_strip({radians(179)}));
  const Picture picture = render(linkage, goal(linkage), from_above());
  const Pixel middle = pixel(picture, 32, 32);
  EXPECT_LT(middle[0] - middle[2], 40);
}

// A triangle that closes a flat pyramid behind it, `height` deep: its flaps are folded back and meet at the apex.
CreasePattern flat_pyramid(double height) {
  const double inradius = std::sqrt(3) / 6, slant = std::hypot(inradius, height);
  CreasePattern sheet;
  sheet.vertices = {{0, 0}, {1, 0}, {0.5, std::sqrt(3) / 2}};
  sheet.faces = {{0, 1, 2}};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec2 a = sheet.vertices[i], b = sheet.vertices[j];
    sheet.faces.push_back({j, i, sheet.num_vertices()});
    sheet.vertices.push_back((a + b) / 2 - slant * perpendicular(b - a));
    const double angle = std::atan2(height, inradius) - kPi;
    sheet.edges.push_back({i, j, assignment_of(angle), angle});
  }
  return sheet;
}

// Pixels unlike the one in the middle of what is drawn, more than `rim` pixels away from its outline.
int marks_inside(const Picture& picture, int rim) {
  const auto inside = [&](int x, int y) {
    for (const auto& [dx, dy] : {std::pair(rim, 0), {-rim, 0}, {0, rim}, {0, -rim}})
      if (x + dx < 0 || x + dx >= picture.width || y + dy < 0 || y + dy >= picture.height ||
          pixel(picture, x + dx, y + dy)[3] == 0)
        return false;
    return true;
  };
  int marks = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      marks += inside(x, y) && pixel(picture, x, y) != pixel(picture, picture.width / 2, picture.height / 2);
  return marks;
}

TEST(Picture, EdgesBehindAPanelDoNotShineThroughAtTheCornersTheyShare) {
  PictureOptions options = from_above();
  options.width = options.height = 200;
  for (double thickness : {0.0, 1e-4}) {
    Linkage linkage = make_linkage(flat_pyramid(0.03));
    linkage.thickness = thickness;
    EXPECT_EQ(marks_inside(render(linkage, goal(linkage), options), 7), 0) << thickness;
  }
}

TEST(Picture, EdgesInFrontOfAPanelAreSeen) {
  PictureOptions options = from_above();
  options.width = options.height = 200;
  options.camera.elevation = radians(-89.9);
  const Linkage linkage = make_linkage(flat_pyramid(0.03));
  EXPECT_GT(marks_inside(render(linkage, goal(linkage), options), 7), 100);  // three edges from the corners to the apex
}

TEST(Picture, SizeHasBounds) {
  const Linkage linkage = make_linkage(square_strip({0}));
  PictureOptions options;
  options.width = 9000;
  EXPECT_THROW(render(linkage, flat(linkage), options), InvalidOption);
}

TEST(Png, IsAPngOfTheSameBytesEveryTime) {
  const Linkage linkage = make_linkage(square_strip({1}));
  const std::string png = render_png(linkage, goal(linkage), from_above());
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(png[19], 64);
  EXPECT_EQ(png, render_png(linkage, goal(linkage), from_above()));
}

ViewerInput strip_input() {
  ViewerInput input;
  input.title = "a strip";
  input.linkage = make_linkage(square_strip({1, -kPi}));
  return input;
}

json data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"plico-data\">";
  const std::size_t begin = page.find(open) + open.size();
  return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Viewer, TellsThePageTheTreeAndTheAngles) {
  const json data = data_of(viewer_page(strip_input()));
  EXPECT_EQ(data["panels"].size(), 3u);
  EXPECT_EQ(data["panels"][1], json({1, 0, 2, 0, 2, 1, 1, 1}));
  EXPECT_EQ(data["hinges"][1]["target"], -kPi);
  EXPECT_EQ(data["order"][0], 1);
  EXPECT_EQ(data["keys"][0], json({{"times", {0, 1}}, {"angles", {0, 1}}}));
  EXPECT_EQ(data["proof"]["status"], "unchecked");
}

TEST(Viewer, PageNeedsNothingElse) {
  const std::string page = viewer_page(strip_input());
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
  EXPECT_THAT(page, Not(HasSubstr("<link rel=\"stylesheet\"")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  for (const char* mark : {"@STYLE@", "@SCRIPT@", "@DATA@"}) EXPECT_THAT(page, Not(HasSubstr(mark)));
}

TEST(Viewer, TextCannotLeaveItsPlace) {
  ViewerInput input = strip_input();
  input.title = "</script><script>alert(1)</script>";
  const std::string page = viewer_page(input);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(data_of(page)["title"], input.title);
}

TEST(Viewer, WhatDoesNotFitIsAnError) {
  ViewerInput input = strip_input();
  input.report = "[1]";
  EXPECT_THROW(viewer_page(input), InvalidInput);
  input = strip_input();
  input.collisions = {{0, 1, 0, 7}};
  EXPECT_THROW(viewer_page(input), InvalidInput);
  input = strip_input();
  input.path = path_through({{0, {0}}, {1, {1}}});
  EXPECT_THROW(viewer_page(input), InvalidInput);
}

}  // namespace
}  // namespace plico
