// plico stack: a mesh as one chain of thick squares that packs into a block.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/motion_report.h"
#include "plico/workflow/jobs/page_files.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/stack_files.h"
#include "plico/workflow/jobs/stack_options.h"
#include "plico/workflow/stack_motion.h"
#include "plico/workflow/stack_views.h"

namespace plico::jobs {
namespace {

using nlohmann::json;

void report_stack(const Session& session, const VoxelMesh& voxels, const StackedChain& chain, json& report) {
  const ChainVerdict& verdict = chain.verdict;
  report.update({{"panels", verdict.panels},
                 {"edges_with_four_squares", voxels.shell.edges_with_four},
                 {"other_pieces", voxels.other_pieces},
                 {"thickness", chain.claim.thickness},
                 {"trim", chain.claim.trim},
                 {"width", verdict.width},
                 {"depth", verdict.depth},
                 {"layers", verdict.height},
                 {"ideal_layers", verdict.ideal},
                 {"slots_per_panel", chain.slots_per_panel},
                 {"compactness", chain.compactness},
                 {"volume_ratio", chain.volume_ratio},
                 {"exchanges", chain.found.exchanges},
                 {"shape_error", verdict.shape_error},
                 {"stack_error", verdict.stack_error},
                 {"defects", defects_json(verdict.defects)},
                 {"verified", verdict.valid()},
                 {"ending", name(chain.found.ending)},
                 {"notes", voxels.notes}});
  session.print(fmt::format("chain      {} panels\n", verdict.panels));
  session.print(fmt::format("stack      {} x {} x {} layers, at least {}\n", verdict.width, verdict.depth,
                            verdict.height, verdict.ideal));
  session.print(fmt::format("compact    C = {:.4f}, volume ratio {:.4g}, {:.3f} slots a panel\n", chain.compactness,
                            chain.volume_ratio, chain.slots_per_panel));
  session.print(fmt::format("verified   {}\n", verdict.valid() ? "yes" : "no"));
  for (const Defect& defect : verdict.defects) session.warn(fmt::format("{}: {}", defect.code, defect.message));
}

void report_motion(const Session& session, const StackMotion& motion, const std::string& wish, json& report) {
  const ChainMotionVerdict& verdict = motion.verdict;
  report["motion"] = {{"wish", wish},
                      {"ending", name(motion.ending)},
                      {"chains", motion.chains},
                      {"waypoints", motion.path.waypoints.size()},
                      {"share", motion.share()},
                      {"verdict", name(verdict.verdict)},
                      {"steps_of_proof", verdict.steps},
                      {"defects", defects_json(verdict.defects)}};
  session.print(fmt::format("motion     {}\n", motion_text(motion, wish == "shape")));
  for (const Defect& defect : verdict.defects) session.warn(fmt::format("{}: {}", defect.code, defect.message));
}

// The chain that moves is the one that is written; a motion is asked for, or a page that shows one.
std::optional<StackMotion> find_motion(const StackArgs& args, const VoxelMesh& voxels, const StackMeshOptions& options,
                                       StackedChain& chain, const Run& run) {
  if (args.motion == "none") return std::nullopt;
  StackMotionOptions how;
  how.seed = options.seed;
  how.to_shape = args.motion == "shape";
  StackMotion motion = unpack_stack(voxels, chain, options, how, run);
  chain = motion.chain;
  return motion;
}

// One chain: found, judged, told, written.
int stack_piece(const StackArgs& args, const VoxelMesh& voxels, const std::vector<std::string>& outputs,
                Session& session, const Run& run, json& report) {
  for (const std::string& note : voxels.notes) session.warn(note);
  StackMeshOptions options = stacking_of(args, session);
  session.print(thickness_text(args, options));
  const int most_layers = args.box.empty() ? voxels.shell.size() : choose_base_in_box(args, voxels, options);
  const JudgedCycle cycle = judged_cycle(voxels, {.seed = session.seed()}, run);
  if (!cycle.verdict.valid()) return kInternal;
  if (cycle.found.ending != Ending::Found) session.warn(no_cycle_text(voxels, cycle));
  if (cycle.walk().empty()) return Session::exit_code(cycle.found.ending);
  StackedChain chain = stack_voxels(voxels, cycle.walk(), options, run);
  const std::optional<StackMotion> motion = find_motion(args, voxels, options, chain, run);
  report_stack(session, voxels, chain, report);
  if (motion) report_motion(session, *motion, args.motion, report);
  if (!chain.verdict.valid() || (motion && motion->verdict.verdict == PathVerdict::Collides)) return kInternal;
  if (!write_stack_files({args, voxels, chain, motion}, outputs, session, report)) return kInternal;
  if (motion && motion->ending != Ending::Found) return Session::exit_code(motion->ending);
  if (chain.verdict.height > most_layers) {
    session.warn(fmt::format("the box has room for {} layers; no stack as low as that was found", most_layers));
    return Session::exit_code(chain.found.ending);
  }
  // A stack with more layers than the ideal is an answer, too.
  return chain.found.ending == Ending::Exhausted ? kDone : Session::exit_code(chain.found.ending);
}

// Of the time that is left, what the first of so many squares may use.
Run share_of_time(const Run& run, double squares, double of_all) {
  if (!run.deadline) return run;
  const std::chrono::duration<double> left = *run.deadline - Run::Clock::now();
  return limited(run, std::max(0.0, left.count() * squares / of_all));
}

// A chain of each piece, the largest first; the worst of the exit codes.
int stack_pieces(const StackArgs& args, const VoxelPieces& all, const std::vector<std::string>& outputs,
                 Session& session) {
  double squares = 0;
  for (const VoxelShell& piece : all.pieces) squares += piece.size();
  json& chains = session.report()["chains"] = json::array();
  int worst = kDone;
  for (std::size_t i = 0; i < all.pieces.size(); ++i) {
    std::vector<std::string> paths;
    for (const std::string& path : outputs) paths.push_back(numbered_path(path, i, all.pieces.size()));
    session.print(fmt::format("piece      {} of {}\n", i + 1, all.pieces.size()));
    chains.push_back(json::object());
    const Run run = share_of_time(session.run(), all.pieces[i].size(), squares);
    worst = std::max(worst, stack_piece(args, piece_of(all, i), paths, session, run, chains.back()));
    squares -= all.pieces[i].size();
  }
  return worst;
}

bool shows_motion(const std::string& path) { return path.ends_with(".html") || path.ends_with(".glb"); }

int stack_file(StackArgs& args, Session& session) {
  const std::vector<std::string> outputs = session.outputs("");
  for (const std::string& path : outputs) check_stack_output(path);
  const auto moving = std::ranges::find_if(outputs, shows_motion);
  if (args.motion.empty()) args.motion = moving != outputs.end() ? "shape" : "none";
  if (args.motion == "none" && moving != outputs.end())
    throw InvalidOption(fmt::format("{} shows a motion, and --motion none asks for none", *moving), "--motion shape");
  if (args.all && std::ranges::count(outputs, "-") > 0)
    throw InvalidOption("--all may write several files, which standard output does not hold", "-o chain.fold");
  stacking_of(args, session);  // refuses what is wrong before anything is read
  VoxelPieces pieces = read_voxels(args, session);
  if (args.all) return stack_pieces(args, pieces, outputs, session);
  const VoxelMesh voxels = largest_piece(std::move(pieces));
  if (!voxels.other_pieces.empty()) session.warn("--all makes a chain of each piece");
  return stack_piece(args, voxels, outputs, session, session.run(), session.report());
}

}  // namespace

Job stack_job() {
  auto args = std::make_shared<StackArgs>();
  Job job("stack", "A mesh as one chain of thick squares that packs into a block");
  job.example("plico stack bird.obj --cells 20 -o bird.fold -o stack.stl", "the most compact stack for its thickness")
      .example("plico stack bird.obj --squares 500 --thickness 0.2 --base 4x4 -o bird.fold",
               "on a base of 4 x 4 panels")
      .example("plico stack bird.obj --cells 20 -o panels.csv && plico stack bird.obj --cells 20 --json",
               "what each panel is and where it lies; every figure")
      .example("plico stack bird.obj --cells 10 --thickness 0.02 -o bird.fold -o motion.html",
               "and its proven motion from the stack to the shape, as a page")
      .example("plico stack bird.obj --cells 10 --side 30mm -o bird.pdf",
               "the chain as sheets to cut, with numbered panels and joints")
      .action([args](Session& session) { return stack_file(*args, session); });
  add_stack_options(job, *args);
  return job;
}

}  // namespace plico::jobs
