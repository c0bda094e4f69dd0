// plico stack: a mesh as one chain of thick squares that packs into a block.
#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/mesh/stl.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/voxel_options.h"
#include "plico/workflow/stack_mesh.h"

namespace plico::jobs {
namespace {

struct StackArgs : VoxelArgs {
  std::string base = "auto";
  double thickness = 0.1;
};

// "6x6"; "auto" leaves both 0.
void read_base(const std::string& text, StackMeshOptions& options) {
  if (text == "auto") return;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  const bool crossed = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  const auto depth = crossed ? std::from_chars(width.ptr + 1, end, options.depth) : width;
  if (!crossed || depth.ec != std::errc{} || depth.ptr != end || options.width < 1 || options.depth < 1)
    throw InvalidOption(fmt::format("base = {} must be auto or WxD, as 6x6, each at least 1", text));
}

void check_stack_output(const std::string& path) {
  for (const char* ending : {".fold", ".csv", ".stl"})
    if (path == "-" || path.ends_with(ending)) return;
  throw InvalidOption(fmt::format("{} does not end in .fold, .csv or .stl", path));
}

void report_stack(Session& session, const VoxelMesh& voxels, const StackedChain& chain) {
  const ChainVerdict& verdict = chain.verdict;
  nlohmann::json defects = nlohmann::json::array();
  for (const Defect& defect : verdict.defects) defects.push_back({{"code", defect.code}, {"message", defect.message}});
  session.report().update({{"panels", verdict.panels},
                           {"edges_with_four_squares", voxels.shell.edges_with_four},
                           {"other_pieces", voxels.other_pieces},
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
                           {"defects", defects},
                           {"verified", verdict.valid()},
                           {"ending", name(chain.found.ending)},
                           {"notes", voxels.notes}});
  session.print(fmt::format("chain      {} panels\n", verdict.panels));
  session.print(fmt::format("stack      {} x {} x {} layers, at least {}\n", verdict.width, verdict.depth,
                            verdict.height, verdict.ideal));
  session.print(fmt::format("compact    C = {:.4f}, volume ratio {:.4g}, {:.3f} slots a panel\n", chain.compactness,
                            chain.volume_ratio, chain.slots_per_panel));
  session.print(fmt::format("verified   {}\n", verdict.valid() ? "yes" : "no"));
  for (const std::string& note : voxels.notes) session.warn(note);
  for (const Defect& defect : verdict.defects) session.warn(fmt::format("{}: {}", defect.code, defect.message));
}

void write_chain(Session& session, const std::string& path, const VoxelMesh& voxels, const StackedChain& chain) {
  if (path.ends_with(".stl")) return session.write(path, write_stl(stack_solid(chain.claim)));
  if (path.ends_with(".csv")) return session.write(path, chain_table(voxels, chain.found.best, chain.claim));
  FoldFile file = chain_file(chain.claim);
  file.report = session.provenance().dump();
  session.write(path, write_fold(file));
}

int stack_file(const StackArgs& args, Session& session) {
  const std::vector<std::string> outputs = session.outputs("");
  for (const std::string& path : outputs) check_stack_output(path);
  StackMeshOptions options{.seed = session.seed(), .thickness = args.thickness};
  read_base(args.base, options);
  require(args.thickness > 0 && args.thickness < 0.5, "thickness", args.thickness, "above 0 and below 0.5 voxel sides");
  const VoxelMesh voxels = read_voxels(args, session);
  const JudgedCycle cycle = judged_cycle(voxels, {.seed = session.seed()}, session.run());
  if (!cycle.verdict.valid()) return kInternal;
  if (cycle.found.ending != Ending::Found) {
    session.warn(
        fmt::format("no cycle through all {} squares was found, {} cycles are left; with --refine 2 there is one",
                    voxels.shell.size(), cycle.found.left));
    return Session::exit_code(cycle.found.ending);
  }
  const StackedChain chain = stack_voxels(voxels, cycle.found.cycle, options, session.run());
  report_stack(session, voxels, chain);
  if (!chain.verdict.valid()) return kInternal;
  for (const std::string& path : outputs) write_chain(session, path, voxels, chain);
  // A stack with more layers than the ideal is an answer, too.
  return chain.found.ending == Ending::Exhausted ? kDone : Session::exit_code(chain.found.ending);
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
      .option("--thickness", "T", "of the panels, in voxel sides, in (0, 0.5)", args->thickness)
      .option("--base", "WxD", "of the stack, in panels; auto: the base with the least W + D + H", args->base)
      .action([args](Session& session) { return stack_file(*args, session); });
  add_voxel_options(job, *args);
  return job;
}

}  // namespace plico::jobs
