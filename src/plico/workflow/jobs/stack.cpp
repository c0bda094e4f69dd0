// plico stack: a mesh as one chain of thick squares that packs into a block.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/fabricate/runs.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/mesh/stl.h"
#include "plico/verify/page_layout.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/motion_report.h"
#include "plico/workflow/jobs/page_files.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/voxel_options.h"
#include "plico/workflow/stack_motion.h"
#include "plico/workflow/stack_views.h"

namespace plico::jobs {
namespace {

struct StackArgs : VoxelArgs {
  std::string base = "auto", box, motion, page = "A4";
  double thickness = 0.1, side_mm = 25;
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

// The three lengths of "6x6x4.5", in the mesh's unit.
Vec3 read_box(const std::string& text) {
  Vec3 box = Vec3::Zero();
  const char *at = text.data(), *end = at + text.size();
  bool good = true;
  for (int i = 0; i < 3 && good; ++i) {
    if (i > 0) good = at != end && *at++ == 'x';
    const auto read = std::from_chars(at, end, box[i]);
    good = good && read.ec == std::errc{} && std::isfinite(box[i]) && box[i] > 0;
    at = read.ptr;
  }
  if (!good || at != end) throw InvalidOption(fmt::format("box = {} must be WxDxH, as 6x6x4.5, each above 0", text));
  return box;
}

// Chooses the best base whose ideal stack fits into the box; how many layers do.
int choose_base_in_box(const StackArgs& args, const VoxelMesh& voxels, StackMeshOptions& options) {
  if (args.base != "auto") throw InvalidOption("a base and a box exclude each other", "--box only");
  const Vec3 box = read_box(args.box);
  const double side = voxels.solid.side;
  const int panels = voxels.shell.size();
  const auto count = [&](double length, double unit) {
    return static_cast<int>(std::min<double>(std::floor(length / unit + 1e-9), panels));
  };
  const StackBox room{count(box.x(), side), count(box.y(), side), count(box.z(), side * args.thickness)};
  const std::optional<StackBox> base = best_base_in(room, panels, args.thickness);
  if (!base)
    throw InvalidOption(fmt::format(
        "box = {} has room for {} x {} panels in {} layers, not for the {} of the chain, which need a "
        "volume of at least {:.4g}",
        args.box, room.width, room.depth, room.height, panels, panels * args.thickness * side * side * side));
  options.width = base->width;
  options.depth = base->depth;
  return room.height;
}

void check_stack_output(const std::string& path) {
  for (const char* ending : {".fold", ".csv", ".stl", ".html", ".png", ".svg", ".dxf", ".pdf"})
    if (path == "-" || path.ends_with(ending)) return;
  throw InvalidOption(fmt::format("{} does not end in .fold, .csv, .stl, .html, .png, .svg, .dxf or .pdf", path));
}

bool is_sheet(const std::string& path) {
  return path.ends_with(".svg") || path.ends_with(".dxf") || path.ends_with(".pdf");
}

void report_stack(Session& session, const VoxelMesh& voxels, const StackedChain& chain) {
  const ChainVerdict& verdict = chain.verdict;
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
  for (const std::string& note : voxels.notes) session.warn(note);
  for (const Defect& defect : verdict.defects) session.warn(fmt::format("{}: {}", defect.code, defect.message));
}

std::string stem(const std::string& path) {
  const std::size_t first = path.find_last_of('/') + 1;
  return path.substr(first, path.rfind('.') - first);
}

// The runs of the chain, judged before they are drawn; false when they are not sound.
bool lay_out_sheets(Session& session, const StackArgs& args, const StackedChain& chain, PageLayout& layout) {
  RunOptions options;
  options.side = args.side_mm;
  options.trim = chain.claim.trim / chain.verdict.side * args.side_mm;
  options.page.size = paper_size(args.page);
  layout = lay_out_runs(chain.claim.sheet, options);
  session.report()["sheets"] = {
      {"runs", layout.parts.size()}, {"pages", layout.pages.size()}, {"side_mm", args.side_mm}};
  session.print(fmt::format("sheets     {} runs on {} pages, squares of {:g} mm\n", layout.parts.size(),
                            layout.pages.size(), args.side_mm));
  const LayoutVerdict verdict = verify_layout(layout);
  for (const std::string& problem : verdict.problems) session.warn(problem);
  return verdict.sound();
}

void write_sheets(Session& session, const std::string& path, const PageLayout& layout) {
  DrawOptions how;
  how.title = stem(path);
  how.flat_creases = true;
  how.ruler = false;
  write_pages(session, path, draw(layout, how), how.title);
}

void write_chain(Session& session, const std::string& path, const VoxelMesh& voxels, const StackedChain& chain,
                 const std::optional<StackMotion>& motion) {
  if (path.ends_with(".stl")) return session.write(path, write_stl(stack_solid(chain.claim)));
  if (path.ends_with(".csv")) return session.write(path, chain_table(voxels, chain.found.best, chain.claim));
  if (path.ends_with(".png")) return session.write(path, stack_picture(chain.claim));
  if (path.ends_with(".html")) {
    ViewerInput page = unpacking_page(*motion);
    page.title = stem(path);
    page.report = session.provenance().dump();
    return session.write(path, viewer_page(page));
  }
  write_fold_files(motion ? chain_motion_file(*motion) : chain_file(chain.claim), {path}, session);
}

void report_motion(Session& session, const StackMotion& motion, const std::string& wish) {
  const ChainMotionVerdict& verdict = motion.verdict;
  session.report()["motion"] = {{"wish", wish},
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
                                       StackedChain& chain, Session& session) {
  if (args.motion == "none") return std::nullopt;
  StackMotionOptions how;
  how.seed = session.seed();
  how.to_shape = args.motion == "shape";
  StackMotion motion = unpack_stack(voxels, chain, options, how, session.run());
  chain = motion.chain;
  return motion;
}

bool is_page(const std::string& path) { return path.ends_with(".html"); }

int stack_file(StackArgs& args, Session& session) {
  const std::vector<std::string> outputs = session.outputs("");
  for (const std::string& path : outputs) check_stack_output(path);
  if (args.motion.empty()) args.motion = std::ranges::any_of(outputs, is_page) ? "shape" : "none";
  if (args.motion == "none" && std::ranges::any_of(outputs, is_page))
    throw InvalidOption("a page shows a motion, and --motion none asks for none", "--motion shape");
  StackMeshOptions options{.seed = session.seed(), .thickness = args.thickness};
  read_base(args.base, options);
  require(args.thickness > 0 && args.thickness < 0.5, "thickness", args.thickness, "above 0 and below 0.5 voxel sides");
  require(args.side_mm > 0, "side", args.side_mm, "above 0");
  paper_size(args.page);  // refuses a size that there is not before anything is searched
  const VoxelMesh voxels = read_voxels(args, session);
  const int most_layers = args.box.empty() ? voxels.shell.size() : choose_base_in_box(args, voxels, options);
  const JudgedCycle cycle = judged_cycle(voxels, {.seed = session.seed()}, session.run());
  if (!cycle.verdict.valid()) return kInternal;
  if (cycle.found.ending != Ending::Found) session.warn(no_cycle_text(voxels, cycle));
  if (cycle.walk().empty()) return Session::exit_code(cycle.found.ending);
  StackedChain chain = stack_voxels(voxels, cycle.walk(), options, session.run());
  const std::optional<StackMotion> motion = find_motion(args, voxels, options, chain, session);
  report_stack(session, voxels, chain);
  if (motion) report_motion(session, *motion, args.motion);
  if (!chain.verdict.valid() || (motion && motion->verdict.verdict == PathVerdict::Collides)) return kInternal;
  PageLayout sheets;
  if (std::ranges::any_of(outputs, is_sheet) && !lay_out_sheets(session, args, chain, sheets)) return kInternal;
  for (const std::string& path : outputs)
    if (is_sheet(path))
      write_sheets(session, path, sheets);
    else
      write_chain(session, path, voxels, chain, motion);
  if (motion && motion->ending != Ending::Found) return Session::exit_code(motion->ending);
  if (chain.verdict.height > most_layers) {
    session.warn(fmt::format("the box has room for {} layers; no stack as low as that was found", most_layers));
    return Session::exit_code(chain.found.ending);
  }
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
      .example("plico stack bird.obj --cells 10 --thickness 0.02 -o bird.fold -o motion.html",
               "and its proven motion from the stack to the shape, as a page")
      .example("plico stack bird.obj --cells 10 --side 30mm -o bird.pdf",
               "the chain as sheets to cut, with numbered panels and joints")
      .option("--thickness", "T", "of the panels, in voxel sides", args->thickness, {0, 0.5, false, false})
      .choice(
          "--motion",
          "plan and prove how the stack unfolds: into one pile, or on into the shape; a page (.html) asks for shape",
          args->motion, {"none", "pile", "shape"})
      .option("--base", "WxD", "of the stack, in panels; auto: the base with the least W + D + H", args->base)
      .option("--box", "WxDxH", "the stack must fit into it, in the mesh's unit; its base is the best that does",
              args->box)
      .length("--side", "of a square on sheets (.svg, .dxf, .pdf)", args->side_mm)
      .option("--page", "SIZE", "of the sheets: A4, Letter, ..., or WIDTHxHEIGHT", args->page)
      .action([args](Session& session) { return stack_file(*args, session); });
  add_voxel_options(job, *args);
  return job;
}

}  // namespace plico::jobs
