#include "plico/mesh/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "plico/base/error.h"

namespace plico {
namespace {

PolygonSoup triangle_with(double x) {
  PolygonSoup soup;
  soup.points = {{x, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.add_face({0, 1, 2});
  return soup;
}

std::string code_of(const PolygonSoup& soup) {
  try {
    Mesh mesh(soup);
  } catch (const InvalidInput& error) {
    return error.code();
  }
  return "";
}

TEST(MeshInMemory, IsCheckedAsReadersCheckFiles) {
  EXPECT_EQ(code_of(triangle_with(0)), "");
  EXPECT_EQ(code_of(triangle_with(std::numeric_limits<double>::quiet_NaN())), "mesh/not-a-number");
  EXPECT_EQ(code_of(triangle_with(std::numeric_limits<double>::infinity())), "mesh/not-a-number");
  PolygonSoup points_only;
  points_only.points = {{0, 0, 0}};
  EXPECT_EQ(code_of(points_only), "mesh/empty");
  EXPECT_EQ(code_of({}), "mesh/empty");
}

}  // namespace
}  // namespace plico
