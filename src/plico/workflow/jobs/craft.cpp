// plico craft: the main job, all in one folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/workflow/craft.h"
#include "plico/workflow/jobs/job_files.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/print_options.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/read_shape.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/shell_pieces.h"
#include "plico/workflow/simplify_mesh.h"

namespace plico::jobs {
namespace {

constexpr int kManyPanels = 400;  // an evening's work

struct CraftArgs {
  std::string mesh, foldable = "linear", repair = "safe", parts = "one", coplanar = "join", optimize = "hands";
  int faces = 0;  // 0: as many as there are
  bool shells = false;
  double concavity = 0.05;
  PrintArgs print;
};

std::string stem(const std::string& path) {
  return path == "-" ? std::string("model") : std::filesystem::path(path).stem().string();
}

CraftOptions craft_options(const CraftArgs& args, Session& session) {
  CraftOptions options;
  options.name = stem(args.mesh);
  options.made_by = session.provenance().dump();
  options.unfold.search.seed = session.seed();
  options.law = args.foldable == "linear"    ? std::optional(FoldingLaw::Linear)
                : args.foldable == "uniform" ? std::optional(FoldingLaw::Uniform)
                                             : std::nullopt;
  if (args.parts != "one") options.parts.emplace();
  if (args.parts != "one") set_wish(*options.parts, args.parts);
  options.wish = hand_wish(args.optimize);
  options.layout = layout_options(args.print);
  // Who says how large it is wants it, on as many pages as it takes.
  options.layout.split = options.layout.split || options.layout.size.is_given();
  options.draw = draw_options(args.print, options.name);
  options.one_svg = args.print.one_svg;
  return options;
}

std::string motion_text(const CraftResult& result) {
  if (!result.motion) return "none: " + result.why_no_motion;
  const PathProof& proof = result.motion->proof;
  if (result.proven()) return fmt::format("{}, proven free of collision at every moment", result.motion_kind);
  if (proof.verdict == PathVerdict::Collides)
    return fmt::format("none found; the best, {}, collides at t = {:.3g} (panels {} and {})", result.motion_kind,
                       proof.to, proof.panel_a, proof.panel_b);
  return fmt::format("{}, not proven", result.motion_kind);
}

void print_pieces(const Session& session, const Kit& kit) {
  for (int i = 0; i < kit.parts.num_parts(); ++i) {
    const ProvenPart& piece = kit.part[i];
    const std::string motion =
        piece.motion ? fmt::format("{} motion {}", name(piece.motion->method), piece.proven() ? "proven" : "not proven")
                     : std::string(piece.net.sheet.num_faces() == 1 ? "nothing turns" : "no motion");
    session.print(fmt::format("piece {:<4} {} panels, {}\n", kit.parts.names[i], piece.net.sheet.num_faces(), motion));
  }
}

void print_result(const CraftArgs& args, const Session& session, const std::string& folder, const CraftResult& result) {
  session.print(fmt::format("net        {} panels, {} {}, {}\n", result.verdict.panels, result.verdict.parts,
                            result.verdict.parts == 1 ? "part" : "parts",
                            result.verdict.valid() ? "verified free of overlap" : "NOT verified"));
  session.print(fmt::format("motion     {}\n", motion_text(result)));
  if (result.kit) print_pieces(session, *result.kit);
  if (result.drawn)
    session.print(layout_text(result.layout.report));
  else
    session.print(fmt::format("pages      none, as the time was over; plico print {}/{}.fold makes them\n", folder,
                              stem(args.mesh)));
  session.print(fmt::format("files      {}: ", folder));
  for (const CraftFile& file : result.files) session.print(fmt::format("{} ", file.name));
  session.print("\n");
}

Mesh mesh_to_craft(Mesh mesh, const CraftArgs& args, Session& session) {
  if (args.faces == 0) return args.coplanar == "join" ? with_flat_regions_whole(std::move(mesh), session) : mesh;
  SimplifiedMesh simple = simplify_mesh(mesh, kept_sharp(args.faces));
  session.report()["simplified"] = {{"faces_before", simple.faces_before}, {"distance", simple.distance}};
  session.print(fmt::format("faces      {} of {}, {:.2f} % of the diagonal away at most\n", simple.mesh.num_faces(),
                            simple.faces_before, 100 * simple.distance / diagonal(mesh)));
  for (const std::string& note : simple.notes) session.warn(note);
  return std::move(simple.mesh);
}

// Fewer faces, larger pages, parts: what was not tried out is only to try.
std::string to_try(const CraftResult& result) {
  std::vector<std::string> ways;
  if (result.verdict.panels > kManyPanels) ways.emplace_back("--faces 300");
  if (!result.kit) ways.emplace_back("--parts auto");
  return ways.empty() ? "" : fmt::format("; or try {}", fmt::join(ways, ", "));
}

std::string what_helps(const CraftResult& result) {
  if (!result.larger) return fmt::format("; no size up to four times this one helps{}", to_try(result));
  const LargerPages& larger = *result.larger;
  return fmt::format("; this net at --longest {:.0f}mm leaves out {} ids and {} tabs, on {} {}{}", larger.longest_mm,
                     larger.work.omitted, larger.work.bare, larger.pages, larger.pages == 1 ? "page" : "pages",
                     to_try(result));
}

// What hands cannot do is said, with what would help.
void warn_of_small_edges(const Session& session, const CraftResult& result) {
  const HandWork& work = result.work;
  if (!work.too_small()) return;
  session.warn(fmt::format(
      "hard to build by hand: {} of {} edges are shorter than {:g} mm, {} of {} edge ids do not fit, {} of {} seams "
      "have no room for a tab{}",
      work.small, work.edges, kSmallEdge, work.omitted, work.ids, work.bare, work.seams, what_helps(result)));
}

// Folds that may tear; at the size that is told this very net has none.
void warn_of_weak_folds(const Session& session, const CraftResult& result) {
  const LayoutReport& layout = result.layout.report;
  const HandMeasures& hands = layout.hands;
  if (hands.weak == 0) return;
  const double longest = layout.final_size.maxCoeff();
  const double larger = std::ceil(longest * kShortestFold / hands.shortest_carrying);
  session.warn(fmt::format(
      "{} {} under {:g} mm {} more than {} panels and may tear{}; try {}--weak-folds cut", hands.weak,
      hands.weak == 1 ? "fold" : "folds", kShortestFold, hands.weak == 1 ? "carries" : "carry", kLightBranchPanels,
      hands.least_weak > 0 ? fmt::format(" (no net of this shape has fewer than {})", hands.least_weak) : "",
      larger <= 2 * longest ? fmt::format("--longest {:.0f}mm, or ", larger) : ""));
}

// Pieces that have no motion free of collision, by their names; empty where the whole is one.
std::string pieces_that_stay_flat(const CraftResult& result) {
  std::vector<std::string> names;
  for (int i = 0; result.kit && i < result.kit->parts.num_parts(); ++i)
    if (result.kit->part[i].net.sheet.num_faces() > 1 && !result.kit->part[i].proven())
      names.push_back(result.kit->parts.names[i]);
  if (names.empty()) return "";
  return fmt::format(" for piece{} {}", names.size() == 1 ? "" : "s", fmt::join(names, ", "));
}

// Where the whole search found no motion: parts fold where one piece does not, and any shape can be printed flat.
std::string remedy_for_motion(const CraftArgs& args, const CraftResult& result) {
  const bool cut_short = result.ending == Ending::TimedOut || result.ending == Ending::Stopped;
  const bool all_fold = result.kit && pieces_that_stay_flat(result).empty();
  if (args.foldable == "none" || result.proven() || all_fold || result.verdict.panels < 2 || cut_short) return "";
  const std::string file = args.mesh == "-" ? "FILE" : quoted(args.mesh);
  return fmt::format("plico craft {} {}", file,
                     args.parts == "one" && !args.shells ? "--parts auto" : "--foldable none");
}

void warn_of_no_motion(const CraftArgs& args, const CraftResult& result, Session& session) {
  const std::string remedy = remedy_for_motion(args, result);
  if (remedy.empty()) return;
  session.report()["craft"]["try"] = remedy;
  session.warn(fmt::format("no motion free of collision was found{}; try {}", pieces_that_stay_flat(result), remedy));
}

// The shells of a shape in parts; of one that hangs together, those of its nearly convex parts.
ShellPieces shells_to_craft(const CraftArgs& args, Session& session) {
  std::vector<ShapePart> parts = read_shape_parts(args.mesh, "auto", "", session);
  if (parts.size() == 1)
    parts = nearly_convex_parts(read_mesh(args.mesh, args.repair, session), {args.concavity}, session.run());
  ShellOptions options;
  options.seed = session.seed();
  ShellPieces pieces = shell_pieces(parts, options, session.run());
  for (const std::string& note : pieces.notes) session.warn(note);
  const Shells& shells = pieces.judged.shells;
  session.print(fmt::format("shells     {} of {} parts, {:.3g} % of the hulls' union lost, {} joints\n",
                            pieces.pieces.num_parts(), parts.size(), 100 * shells.loss(), pieces.joints.size()));
  session.print(
      fmt::format("verified   {}\n", pieces.judged.verdict.valid() ? "shells are convex and disjoint, exactly" : "no"));
  session.report()["shells"] = {{"parts", parts.size()},          {"shells", pieces.pieces.num_parts()},
                                {"loss", shells.loss()},          {"least_kept", shells.least_kept()},
                                {"joints", pieces.joints.size()}, {"valid", pieces.judged.verdict.valid()}};
  return pieces;
}

void check_shell_usage(const CraftArgs& args) {
  if (!args.shells) return;
  if (args.parts != "one") throw InvalidOption("--shells makes its own parts", "leave --parts out");
  if (args.faces > 0)
    throw InvalidOption("--shells takes the shape as it is", "leave --faces out, or run plico simplify first");
  if (args.mesh == "-") throw InvalidOption("--shells reads its file twice, so it cannot be standard input");
  require(args.concavity > 0, "concavity", args.concavity, "above 0");
}

int write_result(const CraftArgs& args, const Mesh& mesh, const std::string& folder, const CraftResult& result,
                 Session& session) {
  for (const CraftFile& file : result.files) session.write(folder + "/" + file.name, file.bytes);
  session.report()["craft"] = craft_report(mesh, result);
  print_result(args, session, folder, result);
  warn_of_no_motion(args, result, session);
  if (!args.shells && result.drawn) warn_of_small_edges(session, result);
  if (result.drawn) warn_of_weak_folds(session, result);
  for (const Defect& defect : result.verdict.defects) session.warn(defect.message);
  for (const Defect& defect : result.joint_defects) session.warn(defect.message);
  if (result.kit)
    for (const std::string& note : result.kit->notes) session.warn(note);
  for (const std::string& problem : result.layout_verdict.problems) session.warn(problem);
  if (!result.sound()) return kInternal;
  return Session::exit_code(result.ending);
}

int craft_shells(const CraftArgs& args, Session& session) {
  CraftOptions options = craft_options(args, session);
  ShellPieces pieces = shells_to_craft(args, session);
  if (!pieces.judged.verdict.valid()) {
    for (const Defect& defect : pieces.judged.verdict.defects) session.warn(defect.message);
    return kInternal;
  }
  const std::string folder = session.output_folder(stem(args.mesh));
  options.pieces = std::move(pieces.pieces);
  options.joints = std::move(pieces.joints);
  options.layout.size.up = up_axis(args.print.up, pieces.mesh, session);
  options.paint = read_paint_of(args.mesh, session);
  return write_result(args, pieces.mesh, folder, craft(pieces.mesh, options, session.run()), session);
}

int craft_file(const CraftArgs& args, Session& session) {
  check_shell_usage(args);
  craft_options(args, session);  // what is wrong is told before the folder is made
  if (args.shells) return craft_shells(args, session);
  PaintedMesh given = read_painted_mesh(args.mesh, args.repair, session);
  const std::string folder = session.output_folder(stem(args.mesh));
  const Mesh mesh = mesh_to_craft(std::move(given.mesh), args, session);
  warn_of_many_faces(mesh, args.mesh, session);
  CraftOptions options = craft_options(args, session);
  options.layout.size.up = up_axis(args.print.up, mesh, session);
  options.paint = std::move(given.paint);
  return write_result(args, mesh, folder, craft(mesh, options, session.run()), session);
}

}  // namespace

Job craft_job() {
  auto args = std::make_shared<CraftArgs>();
  Job job("craft", "From a mesh to printable pages, a net that folds and a page that shows it, in one folder");
  job.example("plico craft bird.obj -o bird", "pages, cut files, the folding net and index.html in the folder bird")
      .example("plico craft bird.obj --height 20cm --page A3 -o bird", "20 cm tall, on A3")
      .example("plico craft bird.obj --parts auto -o bird",
               "a kit: head, wings, legs, each with its own net and motion")
      .example("plico craft robot.obj --shells -o robot", "convex pieces, with marks where they are glued face to face")
      .example("plico craft bird.obj --foldable none --split -o bird", "any net, cut where it does not fit a page")
      .positional("mesh", "OBJ, OFF, STL or PLY file; '-' is standard input", args->mesh)
      .option("--faces", "N", "simplify the mesh to so many triangles first, as plico simplify does; 0: as it is",
              args->faces, at_least(0))
      .choice("--coplanar", "neighbouring faces in one plane are one panel, or kept as they are", args->coplanar,
              {"join", "keep"})
      .choice("--foldable", "look for a net whose linear or uniform motion is proven free of collision", args->foldable,
              {"linear", "uniform", "none"})
      .choice("--optimize",
              "make the net better and keep its proof: compact, with no weak folds; compact; or take the first found",
              args->optimize, {"hands", "page", "none"})
      .option("--parts", "WISH",
              "one net; or parts, as plico segment makes them: auto, cut at necks; fewest that fold; or a number",
              args->parts)
      .flag("--shells",
            "convex pieces, glued face to face: one for each part of the shape, or each nearly convex part of one mesh",
            args->shells)
      .option("--concavity", "X", "of those nearly convex parts, as for plico segment --by convexity", args->concavity,
              above(0));
  add_repair_option(job, args->repair);
  add_print_options(job, args->print);
  job.action([args](Session& session) { return craft_file(*args, session); });
  return job;
}

}  // namespace plico::jobs
