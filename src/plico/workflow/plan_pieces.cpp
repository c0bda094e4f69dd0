#include "plico/workflow/plan_pieces.h"

#include <algorithm>

#include "plico/base/error.h"
#include "plico/fold/net_piece.h"

namespace plico {
namespace {

std::vector<std::optional<Motion>> motions_of(const std::vector<NetPiece>& pieces, const MotionOptions& options,
                                              const Run& run) {
  std::vector<std::optional<Motion>> motions(pieces.size());
  Run alone = run;
  alone.threads = 1;
  alone.progress = nullptr;  // pieces are planned side by side
  parallel_for(run, static_cast<int>(pieces.size()), [&](int i) {
    if (pieces[i].hinge.empty()) return;
    MotionOutcome outcome = plan(make_linkage(pieces[i].net.sheet, pieces[i].net.mate), options, alone);
    if (!outcome.motions.empty()) motions[i] = std::move(outcome.motions.front());
  });
  return motions;
}

}  // namespace

MotionOutcome plan_pieces(const Unfolding& net, const MotionOptions& options, const Run& run) {
  if (options.alternatives > 1)
    throw InvalidOption("alternatives are for one piece, this is a kit", "leave --alternatives out");
  const std::vector<NetPiece> pieces = pieces_of(net);
  const std::vector<std::optional<Motion>> motions = motions_of(pieces, options, run);
  const Linkage whole = make_linkage(net.sheet, net.mate);
  std::vector<std::optional<FoldingPath>> paths(pieces.size());
  std::optional<MotionMethod> common;
  double clearance = options.clearance;  // the largest of all pieces suits all
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!motions[i]) continue;
    paths[i] = motions[i]->path;
    clearance = std::max(clearance, motions[i]->proof.clearance);
    common = common.value_or(motions[i]->method) == motions[i]->method ? motions[i]->method : MotionMethod::LazyPrm;
  }
  MotionOutcome outcome;
  FoldingPath path = joined_path(whole, pieces, paths);
  const PathProof proof = prove_path(whole, path, {.clearance = clearance}, run);
  outcome.motions.push_back({common.value_or(MotionMethod::Linear), std::move(path), proof});
  outcome.ending = outcome.proven() ? Ending::Found : run.over() ? run.ending() : Ending::Exhausted;
  return outcome;
}

}  // namespace plico
