#include "plico/workflow/judge_pieces.h"

#include "plico/io/pattern/fold_pieces.h"

namespace plico {

std::vector<PieceVerdict> judge_pieces(const FoldFile& kit, double clearance, const Run& run) {
  const std::vector<FoldFile> files = piece_files(kit);
  std::vector<PieceVerdict> verdicts(files.size());
  Run alone = run;
  alone.threads = 1;
  alone.progress = nullptr;  // pieces are judged side by side
  parallel_for(run, static_cast<int>(files.size()), [&](int i) {
    PieceVerdict& verdict = verdicts[i];
    const FoldFile& file = files[i];
    const Linkage linkage = make_linkage(file.net.sheet, file.net.mate);
    verdict.title = kit.pieces[i].title;
    verdict.panels = linkage.num_panels();
    verdict.hinges = linkage.num_hinges();
    if (!file.path) return;
    verdict.waypoints = static_cast<int>(file.path->waypoints.size());
    verdict.claims = judge_motion(file, linkage, {}, alone);
    verdict.proof = prove_path(linkage, *file.path, {.clearance = clearance}, alone);
  });
  return verdicts;
}

}  // namespace plico
