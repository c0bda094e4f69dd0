#include "plico/fold/planar_faces.h"

#include <gmock/gmock.h>

#include "plico/base/error.h"

namespace plico {
namespace {

using testing::ElementsAre;
using Faces = std::vector<std::vector<int>>;

std::vector<Crease> edges(const std::vector<std::pair<int, int>>& pairs, Assignment letter = Assignment::Unassigned) {
  std::vector<Crease> result;
  for (const auto& [a, b] : pairs) result.push_back({a, b, letter});
  return result;
}

const std::vector<Vec2> kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(PlanarFaces, SquareWithDiagonalHasTwoCounterClockwiseTriangles) {
  const Faces faces = planar_faces(kSquare, edges({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}));
  EXPECT_THAT(faces, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(2, 3, 0)));
}

TEST(PlanarFaces, FreeEdgesAndBridgesBorderNothing) {
  std::vector<Vec2> at = kSquare;
  at.insert(at.end(), {{2, 0}, {3, 0}, {3, 1}, {0.5, 0.5}});
  // Two cells joined by the bridge 1-4, and an edge that ends inside the first.
  const Faces faces = planar_faces(at, edges({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 6}, {6, 4}, {0, 7}}));
  EXPECT_THAT(faces, ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(4, 5, 6)));
}

TEST(PlanarFaces, BoundaryLoopInsideAFrameIsAHole) {
  std::vector<Vec2> at{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  std::vector<Crease> frame =
      edges({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}}, Assignment::Boundary);
  for (int i = 0; i < 4; ++i) frame.push_back({i, i + 4, Assignment::Mountain});
  EXPECT_EQ(planar_faces(at, frame).size(), 4u);
  for (Crease& e : frame) e.assignment = Assignment::Unassigned;
  EXPECT_EQ(planar_faces(at, frame).size(), 5u) << "an unassigned loop is a panel";
}

TEST(PlanarFaces, PiecesThatMeetInAVertexKeepSimpleFaces) {
  const std::vector<Vec2> at{{0, 0}, {4, 0}, {0, 4}, {1, 0.5}, {0.5, 1}};
  const Faces faces = planar_faces(at, edges({{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}}));
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_THAT(faces[0], ElementsAre(0, 1, 2));
  EXPECT_THAT(faces[1], ElementsAre(0, 3, 4));
}

TEST(PlanarFaces, EdgesThatMeetAwayFromAVertexAreRefused) {
  const std::vector<Vec2> at{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {1, -1}};
  const auto refused = [&](const std::vector<std::pair<int, int>>& pairs) {
    try {
      planar_faces(at, edges(pairs));
    } catch (const InvalidInput& error) {
      return error.code() == "fold/edges-cross";
    }
    return false;
  };
  EXPECT_TRUE(refused({{0, 2}, {1, 3}})) << "crossing";
  EXPECT_TRUE(refused({{0, 1}, {4, 5}})) << "ending on an edge";
  EXPECT_TRUE(refused({{0, 1}, {0, 4}})) << "along each other";
  EXPECT_FALSE(refused({{0, 1}, {1, 2}, {0, 2}}));
}

}  // namespace
}  // namespace plico
