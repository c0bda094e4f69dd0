#include "plico/verify/parts.h"

#include <gmock/gmock.h>

#include "plico/mesh/measures.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

using testing::Contains;
using testing::Field;

// A cube in two parts: its first face, and the other five as a tree.
class CubeInTwo : public testing::Test {
 protected:
  CubeInTwo() {
    const HalfedgeId around = *mesh.halfedges(FaceId(0)).begin();
    FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
    std::vector<char> reached(6, 0);
    reached[0] = 1;
    std::vector<FaceId> queue{mesh.face(mesh.twin(around))};
    reached[queue[0]] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (HalfedgeId h : mesh.halfedges(queue[i]))
        if (const FaceId f = mesh.face(mesh.twin(h)); !reached[f])
          reached[f] = 1, forest.is_fold[mesh.edge(h)] = 1, queue.push_back(f);
    net = lay_flat(mesh, forest);
    claim.names = {"lid", "box"};
    claim.faces = {{0}, {1, 2, 3, 4, 5}};
    claim.pieces = {{net.part[0]}, {net.part[1]}};
    claim.seam.assign(net.sheet.edges.size(), 0);
    int number = 0;
    for (int e = 0; e < net.sheet.num_edges(); ++e) {
      const int mate = net.mate[e];
      if (mate < e) continue;
      const HalfedgeId h = mesh.halfedge(EdgeId(net.mesh_edge[e]));
      if (mesh.face(h) == 0 || mesh.face(mesh.twin(h)) == 0) claim.seam[e] = claim.seam[mate] = ++number;
    }
  }

  void expect_defect(const char* code) {
    const PartsVerdict verdict = verify_parts(claim, net, mesh);
    EXPECT_FALSE(verdict.valid());
    EXPECT_THAT(verdict.defects, Contains(Field(&Defect::code, code)));
  }

  Mesh mesh{cube()};
  Unfolding net;
  PartsClaim claim;
};

TEST_F(CubeInTwo, IsAccepted) {
  const PartsVerdict verdict = verify_parts(claim, net, mesh);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.in_one_piece, 2);
  EXPECT_EQ(verdict.seam_edges, 4);
  EXPECT_NEAR(verdict.seam_length, 4 * length(mesh, EdgeId(0)), 1e-12);
}

TEST_F(CubeInTwo, AFaceInTwoPartsOrNoneIsFound) {
  claim.faces[0] = {0, 1};
  expect_defect("parts/faces");
  claim.faces = {{0}, {1, 2, 3, 4}};
  expect_defect("parts/faces");
  claim.faces = {{0, 99}, {1, 2, 3, 4, 5}};
  expect_defect("parts/faces");
}

TEST_F(CubeInTwo, ASeamWithTwoNumbersOrNoneIsFound) {
  const int e = static_cast<int>(std::find(claim.seam.begin(), claim.seam.end(), 1) - claim.seam.begin());
  claim.seam[e] = 9;
  expect_defect("parts/seam");
  claim.seam[e] = 0;
  expect_defect("parts/seam");
  claim.seam[e] = 2;
  expect_defect("parts/seam");
}

TEST_F(CubeInTwo, ANumberOnAFoldIsFound) {
  const int e = static_cast<int>(std::find(net.mate.begin(), net.mate.end(), -1) - net.mate.begin());
  claim.seam[e] = 9;
  expect_defect("parts/seam");
}

TEST_F(CubeInTwo, PartsThatFallApartAreFound) {
  // The opposite of face 0 is the one face that shares no edge with it.
  std::vector<char> beside(6, 0);
  for (HalfedgeId h : mesh.halfedges(FaceId(0))) beside[mesh.face(mesh.twin(h))] = 1;
  claim.faces = {{0}, {}};
  for (int f = 1; f < 6; ++f) claim.faces[beside[f]].push_back(f);
  expect_defect("parts/connected");
}

TEST_F(CubeInTwo, NamesThatRepeatAndPiecesOfOthersAreFound) {
  claim.names[1] = "lid";
  expect_defect("parts/name");
  std::swap(claim.pieces[0], claim.pieces[1]);
  expect_defect("parts/pieces");
}

TEST_F(CubeInTwo, AnOrderOfAssemblyWithoutEveryPartIsFound) {
  claim.steps = {2, 1};
  EXPECT_TRUE(verify_parts(claim, net, mesh).valid());
  claim.steps = {1, 1};
  expect_defect("parts/order");
  claim.steps = {0, 1};
  expect_defect("parts/order");
  claim.steps = {1, 3};
  expect_defect("parts/order");
}

TEST_F(CubeInTwo, APieceCalledLikeAnotherOrWithoutItsMotionIsFound) {
  claim.alone.resize(2);
  claim.alone[net.part[0]].title = "lid";
  claim.alone[net.part[1]].title = "box";
  EXPECT_TRUE(verify_parts(claim, net, mesh).valid());
  claim.folds = {1, 1};
  expect_defect("parts/motion");
  claim.folds = {1, 0};
  EXPECT_TRUE(verify_parts(claim, net, mesh).valid()) << "one panel has no motion";
  claim.alone[net.part[0]].title = "box";
  expect_defect("parts/title");
}

TEST_F(CubeInTwo, SeamsThatNoEdgeIsSaidToHaveAreFound) {
  claim.seam.assign(claim.seam.size(), 0);
  net.mate.clear();
  expect_defect("parts/seam");
}

TEST_F(CubeInTwo, AJointOfFacesOfOtherPartsIsFound) {
  claim.joints.push_back({0, 1, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 1, 0});
  expect_defect("joint/part");
  expect_defect("joint/turned");
}

}  // namespace
}  // namespace plico
