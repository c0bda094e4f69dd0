#include <gtest/gtest.h>

#include "plico/base/rng.h"
#include "plico/io/mesh/obj.h"
#include "plico/io/mesh/off.h"
#include "plico/io/mesh/ply.h"
#include "plico/io/mesh/stl.h"

namespace plico {
namespace {

// Any polygons at all: a reader does not care whether they make a surface. Magnitudes of all sizes.
PolygonSoup random_soup(Rng& rng) {
  PolygonSoup soup;
  const int points = 3 + rng.below(40), faces = 1 + rng.below(40);
  for (int i = 0; i < points; ++i) {
    const double scale = std::pow(10, rng.uniform(-12, 12));
    soup.points.emplace_back(scale * rng.normal(), scale * rng.normal(), rng.below(3) - 1.0);
  }
  for (int f = 0; f < faces; ++f) {
    std::vector<int> face(3 + static_cast<std::size_t>(rng.below(rng.below(10) == 0 ? 400 : 5)));
    for (int& v : face) v = rng.below(points);
    soup.add_face(face);
  }
  return soup;
}

void expect_same(const PolygonSoup& a, const PolygonSoup& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.offsets, b.offsets);
}

TEST(MeshFileLaw, WhatIsWrittenReadsBackExactly) {
  for (int seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const PolygonSoup soup = random_soup(rng);
    expect_same(soup, read_obj(write_obj(soup)).soup);
    expect_same(soup, read_off(write_off(soup)).soup);
    for (PlyEncoding encoding : {PlyEncoding::Text, PlyEncoding::LittleEndian, PlyEncoding::BigEndian})
      expect_same(soup, read_ply(write_ply(soup, encoding)).soup);
  }
}

TEST(MeshFileLaw, StlKeepsTrianglesToFloatPrecision) {
  for (int seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    PolygonSoup soup;
    for (int i = 0; i < 30; ++i) soup.points.emplace_back(rng.normal(), rng.normal(), rng.normal());
    for (int f = 0; f < 40; ++f) soup.add_face({rng.below(30), rng.below(30), rng.below(30)});
    const PolygonSoup text = read_stl(write_stl_text(soup)).soup, binary = read_stl(write_stl(soup)).soup;
    ASSERT_EQ(text.num_faces(), 40);
    ASSERT_EQ(binary.num_faces(), 40);
    for (std::size_t c = 0; c < soup.corners.size(); ++c) {
      const Vec3& p = soup.points[static_cast<std::size_t>(soup.corners[c])];
      EXPECT_EQ(text.points[static_cast<std::size_t>(text.corners[c])], p);
      EXPECT_EQ(binary.points[static_cast<std::size_t>(binary.corners[c])], p.cast<float>().cast<double>());
    }
  }
}

}  // namespace
}  // namespace plico
