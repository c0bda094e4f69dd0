#include "plico/workflow/segment_mesh.h"

#include <algorithm>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/segment/seams.h"
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
  FoldableNet found = find_foldable_net(
      part.shape.mesh, {.seed = options.seed, .law = law_of(options.motion), .max_steps = std::max(scaled, 1L)}, run);
  part.ending = found.ending;
  part.forest = std::move(found.tree);
  part.proven_impossible = found.proven_impossible;
  part.steps = found.steps;
  const MotionMethod by = options.motion == PartMotion::Uniform ? MotionMethod::Uniform : MotionMethod::Linear;
  if (found.ending == Ending::Found) part.motion = Motion{by, std::move(found.path), found.proof};
}

// No law folds the net: a planner may.
void plan_part_motion(const ProvePartOptions& options, const Run& run, ProvenPart& part) {
  const Linkage linkage = linkage_of(part.net);
  MotionOutcome planned = plan_motion(linkage, {.seed = options.seed}, limited(run, options.planning_seconds));
  if (planned.motions.empty()) return;
  if (planned.proven()) part.ending = Ending::Found, part.proven_impossible = false;
  part.motion = std::move(planned.motions.front());
}

// The pieces of the whole net are numbered part by part.
void number_pieces(SegmentResult& result) {
  Unfolding& net = result.net;
  std::vector<int> part_of_piece(net.num_parts());
  for (std::size_t p = 0; p < net.part.size(); ++p) part_of_piece[net.part[p]] = result.parts.part[net.mesh_face[p]];
  std::vector<int> order(part_of_piece.size()), number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return part_of_piece[i] < part_of_piece[j]; });
  result.pieces.resize(result.parts.num_parts());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[order[i]] = static_cast<int>(i);
    result.pieces[part_of_piece[order[i]]].push_back(static_cast<int>(i));
  }
  for (int& piece : net.part) piece = number[piece];
}

void join_nets(const Mesh& mesh, SegmentResult& result) {
  FoldForest all{std::vector<char>(mesh.num_edges(), 0)};
  for (const ProvenPart& part : result.part)
    for (std::size_t e = 0; e < part.shape.edge.size(); ++e)
      if (part.forest.is_fold[e]) all.is_fold[part.shape.edge[e]] = 1;
  result.net = lay_flat(mesh, all);
  number_pieces(result);
  // The judge is never cut short: whatever is returned has been judged.
  result.verdict = verify_net(result.net, mesh);
}

}  // namespace

int SegmentResult::num_proven() const {
  return static_cast<int>(std::count_if(part.begin(), part.end(), [](const ProvenPart& p) { return p.proven(); }));
}

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
  if (options.motion == PartMotion::Any && !part.proven() && part.verdict.is_net())
    plan_part_motion(options, run, part);
  if (part.ending == Ending::Found && !part.verdict.is_net()) part.ending = Ending::Exhausted;
  return part;
}

SegmentResult prove_parts(const Mesh& mesh, Segmentation parts, const ProvePartOptions& options, const Run& run) {
  SegmentResult result;
  result.parts = std::move(parts);
  const std::vector<std::vector<FaceId>> faces = faces_of_parts(result.parts);
  result.part.resize(faces.size());
  Run alone = run;
  alone.threads = 1;
  alone.progress = nullptr;  // parts are worked on side by side
  parallel_for(run, result.parts.num_parts(),
               [&](int i) { result.part[i] = prove_part(mesh, faces[i], options, alone); });
  join_nets(mesh, result);
  const bool all = result.num_proven() == result.parts.num_parts() && result.verdict.valid();
  result.ending = all ? Ending::Found : run.over() ? run.ending() : Ending::Exhausted;
  return result;
}

std::vector<int> assembly_steps(const Mesh& mesh, const Segmentation& parts) {
  const std::vector<SeamLength> seams = seam_lengths(mesh, parts);
  std::vector<int> step(parts.num_parts(), 0);
  std::vector<double> area_of(parts.num_parts(), 0), joined(parts.num_parts(), 0);
  for (FaceId f : mesh.faces()) area_of[parts.part[f]] += area(mesh, f);
  for (int next = 1; next <= parts.num_parts(); ++next) {
    int best = -1;
    for (int p = 0; p < parts.num_parts(); ++p) {
      if (step[p] > 0) continue;
      if (best < 0 || joined[p] > joined[best] || (joined[p] == joined[best] && area_of[p] > area_of[best])) best = p;
    }
    step[best] = next;
    for (const SeamLength& seam : seams) {
      if (seam.a == best) joined[seam.b] += seam.length;
      if (seam.b == best) joined[seam.a] += seam.length;
    }
  }
  return step;
}

}  // namespace plico
