#include "plico/workflow/prove_part.h"

#include <algorithm>

#include "plico/base/error.h"
#include "plico/unfold/search.h"

namespace plico {
namespace {

constexpr int kMediumPart = 300;  // faces

FoldingLaw law_of(PartMotion motion) {
  return motion == PartMotion::Uniform ? FoldingLaw::Uniform : FoldingLaw::Linear;
}

// A net without regard to motion.
void find_part_net(const ProvePartOptions& options, const Run& run, ProvenPart& part) {
  SearchResult found = find_net(part.shape.mesh, {.seed = options.seed}, run);
  part.ending = found.ending;
  part.forest = std::move(found.forest);
  part.proven_impossible = found.proven_impossible;
  part.steps = found.steps;
}

void find_part_net_and_motion(const ProvePartOptions& options, const Run& run, ProvenPart& part) {
  const long scaled = options.steps * kMediumPart / std::max(part.shape.mesh.num_faces(), kMediumPart);
  const auto search = [&](long steps) {
    return find_foldable_net(
        part.shape.mesh, {.seed = options.seed, .law = law_of(options.motion), .max_steps = std::max(steps, 1L)}, run);
  };
  FoldableNet found = search(scaled);
  if (found.ending == Ending::Exhausted && !found.proven_impossible && found.collisions <= kNearMiss)
    found = search(10 * scaled);
  part.ending = found.ending;
  part.forest = std::move(found.tree);
  part.proven_impossible = found.proven_impossible;
  part.crossing = std::move(found.crossing);
  part.steps = found.steps;
  const MotionMethod by = options.motion == PartMotion::Uniform ? MotionMethod::Uniform : MotionMethod::Linear;
  if (found.ending == Ending::Found) part.motion = Motion{by, std::move(found.path), found.proof};
}

// No law folds the net: a planner may.
void plan_part_motion(const ProvePartOptions& options, const Run& run, ProvenPart& part) {
  const Linkage linkage = linkage_of(part.net);
  MotionOutcome planned = plan(linkage, {.seed = options.seed}, run);
  if (planned.motions.empty()) return;
  if (planned.proven()) part.ending = Ending::Found, part.proven_impossible = false;
  part.motion = std::move(planned.motions.front());
}

}  // namespace

ProvenPart prove_part(const Mesh& mesh, const std::vector<FaceId>& faces, const ProvePartOptions& options,
                      const Run& run) {
  require(options.steps >= 1, "steps", options.steps, "at least 1");
  ProvenPart part;
  part.shape = submesh(mesh, faces);
  // A single panel has nothing to find and nothing that moves.
  if (options.motion == PartMotion::None || faces.size() == 1)
    find_part_net(options, run, part);
  else
    find_part_net_and_motion(options, run, part);
  part.net = lay_flat(part.shape.mesh, part.forest);
  part.verdict = verify_net(part.net, part.shape.mesh);
  const bool may_plan = options.motion == PartMotion::Any && part.crossing.empty();
  if (may_plan && !part.proven() && part.verdict.is_net()) plan_part_motion(options, run, part);
  if (part.ending == Ending::Found && !part.verdict.is_net()) part.ending = Ending::Exhausted;
  return part;
}

}  // namespace plico
