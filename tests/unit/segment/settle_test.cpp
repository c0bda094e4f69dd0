#include "plico/segment/settle.h"

#include <gmock/gmock.h>

#include <set>

#include "plico/mesh/segmentation.h"
#include "plico/segment/given.h"
#include "shapes_in_parts.h"

namespace plico {
namespace {

double seam_length(const DualGraph& graph, const std::vector<int>& part) {
  double sum = 0;
  for (int f = 0; f < graph.num_faces(); ++f)
    for (const DualGraph::Arc& arc : graph.arcs(f))
      if (part[f] < part[arc.to]) sum += arc.length;
  return sum;
}

// Of faces ring by ring; every third of a ring is one ring further: a seam with teeth.
std::vector<int> cut_after_ring(const Mesh& mesh, int ring, bool teeth) {
  std::vector<int> part;
  for (int f = 0; f < mesh.num_faces(); ++f) part.push_back(f / 12 > ring + (teeth && f % 3 == 0 ? 1 : 0));
  return part;
}

TEST(SettleSeams, ARaggedSeamBecomesTheRingBesideIt) {
  const Mesh mesh = dumbbell();
  const DualGraph graph(mesh);
  std::vector<int> part = cut_after_ring(mesh, 5, true);
  const double straight = seam_length(graph, cut_after_ring(mesh, 5, false));
  ASSERT_GT(seam_length(graph, part), straight * 1.01);
  settle_seams(graph, std::vector<int>(mesh.num_faces(), 0), part);
  EXPECT_LE(seam_length(graph, part), straight * (1 + 1e-9));
  EXPECT_EQ(connected_pieces(mesh, part), part);
}

TEST(SettleSeams, SeamsThatWereThereStay) {
  const Mesh mesh = dumbbell();
  const std::vector<int> start = cut_after_ring(mesh, 5, true);
  std::vector<int> part = start;
  settle_seams(DualGraph(mesh), start, part);
  EXPECT_EQ(part, start);
}

TEST(SettleSeams, FacesThatAreHeldTogetherStayTogether) {
  const Mesh mesh = dumbbell();
  DualGraph graph(mesh);
  for (int i = 0; i < 12; ++i) graph.hold(5 * 12 + i, 6 * 12 + i);  // no seam on the lower end of the tube
  std::vector<int> part = cut_after_ring(mesh, 6, true);
  settle_seams(graph, std::vector<int>(mesh.num_faces(), 0), part);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(part[5 * 12 + i], part[6 * 12 + i]);
}

}  // namespace
}  // namespace plico
