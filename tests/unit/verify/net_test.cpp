#include "plico/verify/net.h"

#include <gmock/gmock.h>

#include <array>

#include "plico/base/rng.h"

namespace plico {
namespace {

Mesh make_mesh(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  PolygonSoup soup;
  soup.points = points;
  for (const auto& face : faces) soup.add_face(face);
  return Mesh(soup);
}

Mesh cube() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                   {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

// The cross: the bottom, the four walls around it, the top on the first wall.
Unfolding cross_net(const Mesh& mesh) {
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges()) {
    const int f = mesh.face(mesh.halfedge(e)), g = mesh.face(mesh.twin(mesh.halfedge(e)));
    forest.is_fold[e] = std::min(f, g) == 0 || (std::min(f, g) == 1 && std::max(f, g) == 2);
  }
  return lay_flat(mesh, forest);
}

// Four triangles around a saddle of height h: the angles at its middle sum to 2 pi + 4 h^2.
Mesh saddle(double h) {
  return make_mesh({{0, 0, 0}, {1, 0, h}, {0, 1, -h}, {-1, 0, h}, {0, -1, -h}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

// All four in a fan, cut along one edge to the middle.
Unfolding fan_net(const Mesh& mesh) {
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  int folds = 0;
  for (EdgeId e : mesh.edges())
    if (!mesh.is_boundary(e) && folds < 3) forest.is_fold[e] = 1, ++folds;
  return lay_flat(mesh, forest);
}

std::vector<std::string> codes(const NetVerdict& verdict) {
  std::vector<std::string> result;
  for (const Defect& defect : verdict.defects)
    if (std::find(result.begin(), result.end(), defect.code) == result.end()) result.push_back(defect.code);
  return result;
}

int some_fold(const Unfolding& net) {
  for (int e = 0;; ++e)
    if (net.sheet.edges[e].assignment == Assignment::Mountain) return e;
}

class CubeNet : public testing::Test {
 protected:
  std::vector<std::string> found() const { return codes(verify_net(net, mesh)); }

  const Mesh mesh = cube();
  Unfolding net = cross_net(mesh);
};

TEST_F(CubeNet, IsANet) {
  const NetVerdict verdict = verify_net(net, mesh);
  EXPECT_TRUE(verdict.is_net()) << testing::PrintToString(codes(verdict));
  EXPECT_EQ(verdict.panels, 6);
  EXPECT_EQ(verdict.fold_edges, 5);
  EXPECT_EQ(verdict.overlaps.count, 0);
  EXPECT_LT(verdict.closing_error, 1e-14);
  EXPECT_LT(verdict.congruence_error, 1e-14);
}

TEST_F(CubeNet, InMillimetresIsStillTheNet) {
  for (Vec2& p : net.sheet.vertices) p *= 37.25;
  const NetVerdict verdict = verify_net(net, mesh);
  EXPECT_TRUE(verdict.is_net());
  EXPECT_NEAR(verdict.scale, 37.25, 1e-12);
}

TEST_F(CubeNet, InPiecesIsValidButNoNet) {
  net = lay_flat(mesh, {std::vector<char>(mesh.num_edges(), 0)});
  const NetVerdict verdict = verify_net(net, mesh);
  EXPECT_TRUE(verdict.valid());
  EXPECT_FALSE(verdict.is_net());
  EXPECT_EQ(verdict.parts, 6);
}

TEST_F(CubeNet, WrongSignOfAFoldIsFound) {
  Crease& fold = net.sheet.edges[some_fold(net)];
  fold.fold_angle = -fold.fold_angle;
  EXPECT_THAT(found(), testing::ElementsAre("net/angle", "net/assignment", "net/does-not-close"));
  fold.assignment = Assignment::Valley;
  EXPECT_THAT(found(), testing::ElementsAre("net/angle", "net/does-not-close"));
}

TEST_F(CubeNet, FoldAngleThatIsSlightlyOffIsFound) {
  net.sheet.edges[some_fold(net)].fold_angle += radians(1e-5);
  EXPECT_THAT(found(), testing::ElementsAre("net/angle", "net/does-not-close"));
}

TEST_F(CubeNet, WrongLettersAreFound) {
  net.sheet.edges[some_fold(net)].assignment = Assignment::Flat;
  EXPECT_THAT(found(), testing::ElementsAre("net/assignment"));
  net = cross_net(mesh);
  net.sheet.edges[some_fold(net)].assignment = Assignment::Boundary;
  EXPECT_THAT(found(), testing::ElementsAre("net/assignment"));
}

TEST_F(CubeNet, SwappedMatesAreFound) {
  std::vector<int> cut;
  for (int e = 0; e < net.sheet.num_edges(); ++e)
    if (net.mate[e] > e) cut.push_back(e);
  const int a = cut[0], b = cut[1], a2 = net.mate[a], b2 = net.mate[b];
  net.mate[a] = b2, net.mate[b2] = a, net.mate[b] = a2, net.mate[a2] = b;
  EXPECT_THAT(found(), testing::ElementsAre("net/mate"));
}

TEST_F(CubeNet, MissingMateIsFound) {
  for (int& mate : net.mate)
    if (mate >= 0) {
      mate = -1;
      break;
    }
  EXPECT_THAT(found(), testing::ElementsAre("net/mate"));
}

TEST_F(CubeNet, DuplicatedFaceIsFound) {
  net.mesh_face[3] = net.mesh_face[2];
  EXPECT_THAT(found(), testing::IsSupersetOf({"net/face-twice", "net/face-missing", "net/corners"}));
}

TEST_F(CubeNet, ExtraPanelIsFound) {
  const int first = net.sheet.num_vertices();
  std::vector<int>& copy = net.sheet.faces.emplace_back();
  for (int i = 0; i < 4; ++i) {
    const int v = net.sheet.faces[0][i];
    copy.push_back(first + i);
    net.sheet.vertices.push_back(net.sheet.vertices[v] + Vec2(50, 0));
    net.mesh_vertex.push_back(net.mesh_vertex[v]);
  }
  net.mesh_face.push_back(net.mesh_face[0]);
  net.part.push_back(1);
  EXPECT_THAT(found(), testing::ElementsAre("net/face-twice", "net/edge-missing"));
}

TEST_F(CubeNet, MovedVertexIsFound) {
  net.sheet.vertices[0] += Vec2(1e-7, 0);
  EXPECT_THAT(found(), testing::IsSupersetOf({"net/not-congruent", "net/does-not-close"}));
}

TEST_F(CubeNet, ReversedPanelIsFound) {
  // Mirrors the whole sheet: every panel lies on its front.
  for (Vec2& p : net.sheet.vertices) p.x() = -p.x();
  EXPECT_THAT(found(), testing::Contains("net/turned-over"));
}

TEST_F(CubeNet, WrongPartNumbersAreFound) {
  net.part[4] = 1;
  EXPECT_THAT(found(), testing::ElementsAre("net/parts"));
  net = lay_flat(mesh, {std::vector<char>(mesh.num_edges(), 0)});
  net.part[5] = 4;
  EXPECT_THAT(found(), testing::ElementsAre("net/parts"));
}

TEST_F(CubeNet, LooseAndMissingEdgesAreFound) {
  net.sheet.edges.push_back(net.sheet.edges.back());
  net.mate.push_back(-1);
  EXPECT_THAT(found(), testing::Contains("net/edge-loose"));
  net = cross_net(mesh);
  net.sheet.edges.pop_back();
  net.mate.clear();
  EXPECT_THAT(found(), testing::ElementsAre("net/edge-missing"));
}

TEST_F(CubeNet, NumbersOutOfRangeAreFound) {
  net.mesh_vertex[0] = 8;
  EXPECT_THAT(found(), testing::ElementsAre("net/other-mesh"));
  net = cross_net(mesh);
  net.sheet.faces[0][0] = 99;
  EXPECT_THAT(found(), testing::ElementsAre("net/numbers"));
}

TEST_F(CubeNet, ManyDefectsOfAKindAreCounted) {
  for (int& mate : net.mate) mate = -1;
  const NetVerdict verdict = verify_net(net, mesh);
  ASSERT_EQ(verdict.defects.size(), 6u);
  EXPECT_EQ(verdict.defects.back().message, "and 9 more of this kind");
}

TEST(NetVerdict, OverlapOfTenMillionthAroundASaddleIsFound) {
  const Mesh mesh = saddle(std::sqrt(1e-7 / 4));
  const NetVerdict verdict = verify_net(fan_net(mesh), mesh);
  EXPECT_EQ(verdict.overlaps.count, 1);
  EXPECT_THAT(codes(verdict), testing::ElementsAre("net/overlap"));
  EXPECT_NEAR(verdict.overlaps.worst.area, 0.5e-7, 1e-8);
}

TEST(NetVerdict, FlatFanTouchesItselfAndIsANet) {
  const Mesh mesh = saddle(0);
  EXPECT_TRUE(verify_net(fan_net(mesh), mesh).is_net());
}

TEST(NetVerdict, RingOfPanelsIsACycle) {
  // A flat fan laid out without any cut.
  const Mesh mesh = saddle(0);
  Unfolding net;
  for (VertexId v : mesh.vertices()) {
    net.sheet.vertices.emplace_back(mesh.point(v).x(), mesh.point(v).y());
    net.mesh_vertex.push_back(v);
  }
  for (FaceId f : mesh.faces()) {
    net.sheet.faces.emplace_back(mesh.corners(f).begin(), mesh.corners(f).end());
    net.mesh_face.push_back(f);
    net.part.push_back(0);
  }
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    net.sheet.edges.push_back(
        {mesh.from(h), mesh.to(h), mesh.is_boundary(e) ? Assignment::Boundary : Assignment::Flat, 0});
  }
  EXPECT_THAT(codes(verify_net(net, mesh)), testing::ElementsAre("net/cycle"));
}

TEST(NetVerdict, PanelsThatShareASideTheirFacesDoNotIsFound) {
  // Two separate triangles of a mesh, drawn as if they shared a side.
  const Mesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 5}, {0, 0, 5}, {0, -1, 5}}, {{0, 1, 2}, {3, 4, 5}});
  Unfolding net;
  net.sheet.vertices = {{0, 0}, {1, 0}, {0, 1}, {0, -1}};
  net.mesh_vertex = {0, 1, 2, 5};
  net.sheet.faces = {{0, 1, 2}, {1, 0, 3}};
  net.mesh_face = {0, 1};
  net.part = {0, 0};
  net.sheet.edges = {{0, 1, Assignment::Flat},
                     {1, 2, Assignment::Boundary},
                     {2, 0, Assignment::Boundary},
                     {0, 3, Assignment::Boundary},
                     {3, 1, Assignment::Boundary}};
  EXPECT_THAT(codes(verify_net(net, mesh)), testing::ElementsAre("net/corners"));
}

TEST(NetVerdict, CutShortIsNotValid) {
  const Mesh mesh = cube();
  std::stop_source source;
  source.request_stop();
  const NetVerdict verdict = verify_net(cross_net(mesh), mesh, {}, {.stop = source.get_token()});
  EXPECT_FALSE(verdict.complete);
  EXPECT_FALSE(verdict.valid());
}

}  // namespace
}  // namespace plico
