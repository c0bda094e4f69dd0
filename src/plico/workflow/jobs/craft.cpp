// plico craft: the main job, all in one folder.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/mesh/measures.h"
#include "plico/workflow/craft.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/print_options.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/simplify_mesh.h"

namespace plico::jobs {
namespace {

struct CraftArgs {
  std::string mesh, foldable = "linear", repair = "safe", parts = "one", coplanar = "join", optimize = "hands";
  int faces = 0;  // 0: as many as there are
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
  if (args.parts != "one") options.parts = SegmentOptions{.prove = {}};
  if (args.parts != "one") set_wish(*options.parts, args.parts);
  options.wish = hand_wish(args.optimize);
  options.layout = layout_options(args.print);
  // Who says how large it is wants it, on as many pages as it takes.
  options.layout.split = options.layout.split || options.layout.size.is_given();
  options.draw = draw_options(args.print, options.name);
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

void print_pieces(const Session& session, const Mesh& mesh, const Kit& kit) {
  const std::vector<int> step = assembly_steps(mesh, kit.parts);
  for (int i = 0; i < kit.parts.num_parts(); ++i) {
    const ProvenPart& piece = kit.part[i];
    const std::string motion =
        piece.motion ? fmt::format("{} motion {}", name(piece.motion->method), piece.proven() ? "proven" : "not proven")
                     : std::string(piece.net.sheet.num_faces() == 1 ? "nothing turns" : "no motion");
    session.print(fmt::format("piece {:<4} {} panels, {}\n", kit.parts.names[i], piece.net.sheet.num_faces(), motion));
  }
  std::string order;
  for (int at = 1; at <= kit.parts.num_parts(); ++at)
    order += " " + kit.parts.names[std::ranges::find(step, at) - step.begin()];
  session.print(fmt::format("build     {}\n", order));
}

void print_result(const Session& session, const std::string& folder, const Mesh& mesh, const CraftResult& result) {
  session.print(fmt::format("net        {} panels, {} {}, {}\n", result.verdict.panels, result.verdict.parts,
                            result.verdict.parts == 1 ? "part" : "parts",
                            result.verdict.valid() ? "verified free of overlap" : "NOT verified"));
  session.print(fmt::format("motion     {}\n", motion_text(result)));
  if (result.kit) print_pieces(session, mesh, *result.kit);
  session.print(layout_text(result.layout.report));
  session.print(fmt::format("files      {}: ", folder));
  for (const CraftFile& file : result.files) session.print(fmt::format("{} ", file.name));
  session.print("\n");
}

Mesh mesh_to_craft(const CraftArgs& args, Session& session) {
  Mesh mesh = read_mesh(args.mesh, args.repair, session);
  if (args.faces == 0) return args.coplanar == "join" ? with_flat_regions_whole(std::move(mesh), session) : mesh;
  SimplifiedMesh simple = simplify_mesh(mesh, kept_sharp(args.faces));
  session.report()["simplified"] = {{"faces_before", simple.faces_before}, {"distance", simple.distance}};
  session.print(fmt::format("faces      {} of {}, {:.2f} % of the diagonal away at most\n", simple.mesh.num_faces(),
                            simple.faces_before, 100 * simple.distance / diagonal(mesh)));
  for (const std::string& note : simple.notes) session.warn(note);
  return std::move(simple.mesh);
}

// What hands cannot do is said, with what would help.
void warn_of_small_edges(const Session& session, const CraftResult& result) {
  const HandWork work = hand_work(result);
  if (!work.too_small()) return;
  session.warn(fmt::format(
      "hard to build by hand: {} of {} edges are shorter than {:g} mm, {} of {} edge ids do not fit; try {}--longest "
      "{:.0f}mm --split, or --parts auto",
      work.small, work.edges, kSmallEdge, work.omitted, work.ids,
      result.net.sheet.num_faces() > 400 ? "--faces 300, " : "", work.longest_mm));
}

int craft_file(const CraftArgs& args, Session& session) {
  craft_options(args, session);  // wrong ones are told before the folder is made
  const std::string folder = session.output_folder(stem(args.mesh));
  const Mesh mesh = mesh_to_craft(args, session);
  CraftOptions options = craft_options(args, session);
  options.layout.size.up = up_axis(args.print.up, mesh, session);
  const CraftResult result = craft(mesh, options, session.run());
  for (const CraftFile& file : result.files) session.write(folder + "/" + file.name, file.bytes);
  session.report()["craft"] = craft_report(mesh, result);
  print_result(session, folder, mesh, result);
  warn_of_small_edges(session, result);
  for (const Defect& defect : result.verdict.defects) session.warn(defect.message);
  for (const std::string& problem : result.layout_verdict.problems) session.warn(problem);
  if (!result.sound()) return kInternal;
  return Session::exit_code(result.ending);
}

}  // namespace

Job craft_job() {
  auto args = std::make_shared<CraftArgs>();
  Job job("craft", "From a mesh to printable pages, a net that folds and a page that shows it, in one folder");
  job.example("plico craft bird.obj -o bird", "pages, cut files, the folding net and index.html in the folder bird")
      .example("plico craft bird.obj --height 20cm --page A3 -o bird", "20 cm tall, on A3")
      .example("plico craft bird.obj --parts auto -o bird",
               "a kit: head, wings, legs, each with its own net and motion")
      .example("plico craft bird.obj --foldable none --split -o bird", "any net, cut where it does not fit a page")
      .positional("mesh", "OBJ, OFF, STL or PLY file; '-' is standard input", args->mesh)
      .option("--faces", "N", "simplify the mesh to so many triangles first, as plico simplify does; 0: as it is",
              args->faces)
      .choice("--coplanar", "neighbouring faces in one plane are one panel, or kept as they are", args->coplanar,
              {"join", "keep"})
      .choice("--foldable", "look for a net whose linear or uniform motion is proven free of collision", args->foldable,
              {"linear", "uniform", "none"})
      .choice("--optimize",
              "make the net better and keep its proof: compact, with no weak folds; compact; or take the first found",
              args->optimize, {"hands", "page", "none"})
      .option("--parts", "WISH",
              "one net; or parts, as plico segment makes them: auto, cut at necks; fewest that fold; or a number",
              args->parts);
  add_repair_option(job, args->repair);
  add_print_options(job, args->print);
  job.action([args](Session& session) { return craft_file(*args, session); });
  return job;
}

}  // namespace plico::jobs
