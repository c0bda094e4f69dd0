#include "plico/workflow/stand.h"

#include <gtest/gtest.h>

#include "plico/mesh/measures.h"
#include "plico/mesh/upright.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/foldable_net.h"

namespace plico {
namespace {

TEST(Stand, TheFoldedModelIsTheMeshWithItsUpAxisAlongZ) {
  for (const char* name : {"house", "pyramid", "star"}) {
    for (char up : {'y', 'z'}) {
      SCOPED_TRACE(name);
      const Mesh mesh(make_shape(name));
      const Unfolding net = lay_flat(mesh, find_foldable_net(mesh).tree);
      ASSERT_EQ(net.num_parts(), 1);
      const Linkage linkage = linkage_of(net);
      const Eigen::Matrix3d turn = stand_of(net, linkage, mesh, up).at(1);
      const std::vector<Pose> poses = folding_map(linkage, goal(linkage));
      for (int p = 0; p < linkage.num_panels(); ++p) {
        const Vec3 front = turn * (poses[p].linear() * Vec3::UnitZ());
        EXPECT_NEAR((front - z_up_from(up) * normal(mesh, FaceId(net.mesh_face[p]))).norm(), 0, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace plico
