#include "plico/stack/peel_bodies.h"

#include <algorithm>

namespace plico {
namespace {

std::vector<OrientedBox> boxes_at(const std::vector<Pose>& poses, const std::vector<OrientedBox>& flat) {
  std::vector<OrientedBox> boxes;
  for (std::size_t p = 0; p < poses.size(); ++p) boxes.push_back(placed(flat[p], poses[p]));
  return boxes;
}

}  // namespace

StandingTrees::StandingTrees(const std::vector<OrientedBox>& boxes) {
  std::vector<Eigen::AlignedBox3d> around;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 half = boxes[i].axes.cwiseAbs() * boxes[i].half;
    around.emplace_back(Vec3(boxes[i].center - half), Vec3(boxes[i].center + half));
    if (around.size() < kBlock && i + 1 < boxes.size()) continue;
    trees_.emplace_back(around);
    around.clear();
  }
}

PeelBodies::PeelBodies(const Linkage& chain, int sign, double air)
    : chain_(chain),
      sign_(sign),
      half_side_((chain.panels[0][1] - chain.panels[0][0]).norm() / 2),
      half_thickness_(chain.thickness / 2),
      air_(air * chain.thickness),
      pose_(folding_map(chain, goal(chain))),
      standing_([&] {
        std::vector<OrientedBox> flat;
        for (int p = 0; p < chain.num_panels(); ++p) flat.push_back(panel(p));
        return boxes_at(pose_, flat);
      }()),
      trees_(standing_) {}

OrientedBox PeelBodies::panel(int p) const {
  const std::vector<Vec3>& outline = chain_.panels[p];
  return {(outline[0] + outline[2]) / 2, Eigen::Matrix3d::Identity(), {half_side_, half_side_, half_thickness_ - air_}};
}

OrientedBox PeelBodies::pile(int first, int last, int on) const {
  OrientedBox box = panel(on);
  const int count = last - first + 1;
  // The pile goes on upon the front of `on` when its next hinge is a valley.
  const double up = on + 1 < num_panels() && pile_angle(on) < 0 ? -1 : 1;
  box.half.z() = count * half_thickness_ - air_;
  box.center.z() += up * (2 * (first - on) + count - 1) * half_thickness_;
  return box;
}

std::vector<OrientedBox> PeelBodies::tower(int on) const {
  std::vector<OrientedBox> pieces;
  int count = std::max(1, static_cast<int>(half_side_ / half_thickness_));
  for (int first = on + 1; first < num_panels(); first += count, count *= 2)
    pieces.push_back(pile(first, std::min(first + count, num_panels()) - 1, on));
  return pieces;
}

}  // namespace plico
