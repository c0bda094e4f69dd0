#include "plico/workflow/stack_views.h"

#include <fmt/format.h>

#include "plico/fold/plain_hinges.h"
#include "plico/io/motion/gltf.h"
#include "plico/io/motion/png.h"
#include "plico/workflow/show_proof.h"

namespace plico {

ViewerInput unpacking_page(const StackMotion& motion) {
  ViewerInput page;
  page.linkage = chain_linkage_of(motion.chain.claim);
  page.path = motion.path;
  page.motion = "unpacking";
  show_proof(page, motion.verdict);
  return page;
}

std::string unpacking_animation(const StackMotion& motion) {
  return write_glb(plain_hinged(chain_linkage_of(motion.chain.claim)), plain_path(motion.path));
}

std::string stack_picture(const ChainClaim& claim) {
  const Linkage chain = chain_linkage_of(claim);
  return render_png(chain, Eigen::Map<const Configuration>(claim.stack.data(), chain.num_hinges()));
}

std::string motion_text(const StackMotion& motion, bool to_shape) {
  if (motion.verdict.verdict == PathVerdict::Collides)
    return fmt::format("collides at t = {:.3g} (panels {} and {})", motion.verdict.from, motion.verdict.panel_a,
                       motion.verdict.panel_b);
  const std::string proof = motion.verdict.free() ? "proven free of collision at every moment" : "not proven";
  if (!to_shape) return fmt::format("from the stack to one pile, {}", proof);
  if (motion.ending == Ending::Found) return fmt::format("from the stack to the shape, {}", proof);
  return fmt::format("none found in {} chains; the best opens {:.0f} % of the hinges, {}", motion.chains,
                     100 * motion.share(), proof);
}

bool points_are_elsewhere(const FoldFile& file, const ChainClaim& claim) {
  if (file.path_points.empty()) return false;
  FoldFile again = file;
  const Linkage chain = chain_linkage_of(claim);
  set_path(again, chain, *file.path);
  const double side =
      (claim.sheet.vertices[claim.sheet.faces[0][1]] - claim.sheet.vertices[claim.sheet.faces[0][0]]).norm();
  for (std::size_t i = 0; i < again.path_points.size(); ++i) {
    if (i >= file.path_points.size() || file.path_points[i].size() != again.path_points[i].size()) return true;
    for (std::size_t v = 0; v < again.path_points[i].size(); ++v)
      if ((file.path_points[i][v] - again.path_points[i][v]).norm() > 1e-7 * side) return true;
  }
  return false;
}

}  // namespace plico
