#include "plico/workflow/shell_pieces.h"

#include <gtest/gtest.h>

#include "plico/mesh/measures.h"
#include "plico/verify/joints.h"

namespace plico {
namespace {

ShapePart box(const std::string& name, const Vec3& low, const Vec3& high) {
  ShapePart part{name, {}};
  for (int i = 0; i < 8; ++i)
    part.points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
  return part;
}

// A post that is sunk into a block, off its middle.
std::vector<ShapePart> post_in_block() {
  return {box("block", {0, 0, 0}, {4, 3, 2}), box("post", {0.5, 1, 1.5}, {1.5, 2, 5})};
}

TEST(ShellPieces, OfAPostSunkIntoABlockMeetInOneJoint) {
  const ShellPieces pieces = shell_pieces(post_in_block());
  ASSERT_EQ(pieces.pieces.names, (std::vector<std::string>{"block", "post"}));
  EXPECT_EQ(pieces.mesh.num_faces(), 12);  // no triangles are left of flat facets
  ASSERT_EQ(pieces.joints.size(), 1u);
  const Joint& joint = pieces.joints[0];
  EXPECT_TRUE(verify_joints(pieces.mesh, {{joint.first_face, joint.second_face, joint.polygon}}).empty());
  EXPECT_TRUE(pieces.judged.verdict.valid());
}

TEST(ShellPieces, PutTogetherAreTheMesh) {
  const ShellPieces pieces = shell_pieces(post_in_block());
  Kit kit = make_kit(pieces.mesh, pieces.pieces);
  kit.joints = pieces.joints;
  EXPECT_EQ(kit.num_proven(), 2);
  const std::vector<Pose> home = assembled(pieces.mesh, kit.net);
  const Linkage linkage = linkage_of(kit.net);
  const std::vector<Pose> folded = folding_map(linkage, goal(linkage));
  for (int p = 0; p < linkage.num_panels(); ++p) {
    const std::span<const int> corners = pieces.mesh.corners(FaceId(kit.net.mesh_face[p]));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 here = home[p] * folded[p] * linkage.panels[p][i];
      EXPECT_LT((here - pieces.mesh.point(VertexId(corners[i]))).norm(), 1e-9);
    }
  }
}

TEST(ShellPieces, AreBuiltInTheOrderOfTheirJoints) {
  std::vector<ShapePart> parts = post_in_block();
  parts.push_back(box("tip", {0.8, 1.3, 4.8}, {1.2, 1.7, 6}));  // touches the post alone
  const ShellPieces pieces = shell_pieces(parts);
  EXPECT_EQ(assembly_steps(pieces.mesh, pieces.pieces, pieces.joints), (std::vector<int>{1, 2, 3}));
}

TEST(ShellPieces, OfNestedPartsAreToldAsDropped) {
  const ShellPieces pieces = shell_pieces({box("block", {0, 0, 0}, {4, 3, 2}), box("seed", {1, 1, 1}, {2, 2, 1.5})});
  EXPECT_EQ(pieces.pieces.num_parts(), 1);
  ASSERT_EQ(pieces.notes.size(), 1u);
  EXPECT_EQ(pieces.notes[0], "seed lies in block: dropped");
}

}  // namespace
}  // namespace plico
