#include "motion_player.h"

#include <algorithm>
#include <map>

#include "plico/io/pattern/fold.h"
#include "plico/workflow/stack_mesh.h"
#include "plico/workflow/stack_motion.h"

namespace plico {

MotionPlayer::MotionPlayer(const std::string& bytes, const std::string& name) {
  FoldFile file = read_fold(bytes, name);
  const std::optional<ChainClaim> chain = chain_claim(file);
  if (chain) take_told_motion(file, *chain);
  const CreasePattern& sheet = file.net.sheet;
  linkage_ = chain ? chain_linkage_of(*chain) : make_linkage(sheet, file.net.mate);
  path_ = file.path ? *file.path
          : chain   ? FoldingPath{{{0, goal(linkage_)}, {1, goal(linkage_)}}}
                    : linear_path(linkage_);
  std::map<std::pair<int, int>, int> edge_between;
  for (int p = 0; p < linkage_.num_panels(); ++p) {
    const int corners = static_cast<int>(linkage_.panels[p].size());
    offsets_.push_back(offsets_.back() + corners);
    for (int i = 0; i < corners; ++i) {
      if (chain) {  // squares of a chain are not drawn on one sheet
        corner_edges_.push_back(num_edges_++);
        continue;
      }
      const std::pair<int, int> ends = std::minmax(sheet.faces[p][i], sheet.faces[p][(i + 1) % corners]);
      const auto [edge, is_new] = edge_between.try_emplace(ends, num_edges_);
      num_edges_ += is_new;
      corner_edges_.push_back(edge->second);
    }
  }
}

std::vector<float> MotionPlayer::flat_corners() const {
  std::vector<float> flat;
  for (const std::vector<Vec3>& panel : linkage_.panels)
    for (const Vec3& corner : panel)
      for (int axis : {0, 1}) flat.push_back(static_cast<float>(corner[axis]));
  return flat;
}

std::vector<float> MotionPlayer::corners_at(double time) const {
  const std::vector<Pose> poses = folding_map(linkage_, path_.at(std::clamp(time, 0.0, 1.0)));
  std::vector<float> corners;
  for (int p = 0; p < linkage_.num_panels(); ++p)
    for (const Vec3& corner : linkage_.panels[p])
      for (double x : Vec3(poses[p] * corner)) corners.push_back(static_cast<float>(x));
  return corners;
}

}  // namespace plico
