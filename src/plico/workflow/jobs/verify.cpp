// plico verify: judges what a FOLD file claims, from scratch.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
#include "plico/io/pattern/fold.h"
#include "plico/verify/deformation.h"
#include "plico/verify/flat_layers.h"
#include "plico/verify/net.h"
#include "plico/verify/parts.h"
#include "plico/verify/path.h"
#include "plico/workflow/end_layers.h"
#include "plico/workflow/jobs/face_orders.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/motion_report.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/judge_motion.h"
#include "plico/workflow/judge_pieces.h"
#include "plico/workflow/parts_file.h"
#include "plico/workflow/plan_motion.h"
#include "plico/workflow/stack_motion.h"
#include "plico/workflow/stack_views.h"

namespace plico::jobs {
namespace {

using nlohmann::json;

struct VerifyArgs {
  std::string file, mesh, repair = "safe";
  double clearance = 0, noise = 0;
  int samples = 100;
};

json to_json(const Overlaps& overlaps) {
  json pairs = json::array();
  for (const OverlappingPair& pair : overlaps.listed)
    pairs.push_back({{"panels", {pair.a, pair.b}}, {"area", pair.area}});
  return {{"count", overlaps.count}, {"worst_area", overlaps.worst.area}, {"pairs", std::move(pairs)}};
}

std::string lines_of(const std::vector<Defect>& defects) {
  std::string text;
  for (const Defect& defect : defects) text += fmt::format("  {}: {}\n", defect.code, defect.message);
  return text;
}

std::string count(long n, const std::string& one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

void report_net(Session& session, const NetVerdict& verdict) {
  json& report = session.report();
  report["kind"] = "net";
  report["panels"] = verdict.panels;
  report["parts"] = verdict.parts;
  report["fold_edges"] = verdict.fold_edges;
  report["scale"] = verdict.scale;
  report["overlaps"] = to_json(verdict.overlaps);
  report["congruence_error"] = verdict.congruence_error;
  report["mate_error"] = verdict.mate_error;
  report["angle_error_deg"] = degrees(verdict.angle_error);
  report["closing_error"] = verdict.closing_error;
  report["defects"] = defects_json(verdict.defects);
  report["valid"] = verdict.valid();
  report["net"] = verdict.is_net();
  session.print(fmt::format("net        {}, {}, {}\n", count(verdict.panels, "panel"), count(verdict.parts, "part"),
                            count(verdict.fold_edges, "fold")));
  session.print(fmt::format("overlap    {}\n", count(verdict.overlaps.count, "pair")));
  session.print(fmt::format("panels     off by {:.2g} of the diagonal\n", verdict.congruence_error));
  session.print(fmt::format("folds      off by {:.2g} degrees\n", degrees(verdict.angle_error)));
  session.print(fmt::format("closing    off by {:.2g} of the diagonal\n", verdict.closing_error));
  session.print(lines_of(verdict.defects));
}

void print_verified(const Session& session, bool complete, bool valid) {
  session.print(fmt::format("verified   {}\n", !complete ? "not finished" : valid ? "yes" : "no"));
}

// The mesh on the command line; none when there is none.
std::optional<Mesh> given_mesh(const FoldFile& file, const VerifyArgs& args, Session& session) {
  if (args.mesh.empty()) return std::nullopt;
  return read_mesh_of_net(args.mesh, args.repair, file.net.sheet.num_faces(), session);
}

// Without a mesh the net is held against its own folded form; one that makes no surface is a defect like any other.
NetVerdict judge(const FoldFile& file, const std::optional<Mesh>& mesh, const VerifyArgs& args, const Run& run) {
  if (mesh) {
    NetVerdict verdict = verify_net(file.net, *mesh, {}, run);
    if (std::optional<Defect> found = judge_folded_form(file, *mesh)) verdict.defects.push_back(std::move(*found));
    return verdict;
  }
  if (file.folded.empty())
    throw InvalidInput("verify/no-shape", fmt::format("{} has no folded form to hold the net against", args.file), {},
                       fmt::format("plico verify {} MESH", args.file));
  try {
    return verify_net(file.net, folded_mesh(file), {}, run);
  } catch (const InvalidInput& error) {
    NetVerdict verdict;
    verdict.panels = file.net.sheet.num_faces();
    verdict.parts = file.net.num_parts();
    verdict.defects.push_back({error.code(), error.what()});
    return verdict;
  }
}

int verify_net_file(const FoldFile& file, const std::optional<Mesh>& mesh, const VerifyArgs& args, Session& session) {
  const Run run = session.run();
  const NetVerdict verdict = judge(file, mesh, args, run);
  report_net(session, verdict);
  print_verified(session, verdict.complete, verdict.valid());
  if (!verdict.complete && run.over()) return Session::exit_code(run.ending());
  return verdict.valid() ? kDone : kNo;
}

// How often the motion still folds with inexact creases; a figure, not part of the verdict.
void report_noise(const FoldFile& file, const Linkage& linkage, const VerifyArgs& args, Session& session) {
  const NoiseVerdict verdict =
      fold_with_noise(linkage, *file.path, args.noise, args.samples, session.seed(), args.clearance, session.run());
  session.report()["noise"] = {{"angle_deg", degrees(args.noise)},
                               {"samples", verdict.samples},
                               {"folded", verdict.folded},
                               {"mean_stop", verdict.mean_stop}};
  session.print(
      fmt::format("noise      {} of {} fold with creases off by up to {:.3g} degrees, to t = {:.3g} on average\n",
                  verdict.folded, verdict.samples, degrees(args.noise), verdict.mean_stop));
}

json to_json(const PieceVerdict& piece) {
  json report = {{"title", piece.title},
                 {"panels", piece.panels},
                 {"hinges", piece.hinges},
                 {"waypoints", piece.waypoints},
                 {"defects", defects_json(piece.claims.defects)},
                 {"valid", piece.valid()}};
  if (piece.proof) report["motion"] = motion_json(*piece.proof);
  return report;
}

// Each piece with its motion. Lines are of those that have something to say.
void report_pieces(const Session& session, json& report, const std::vector<PieceVerdict>& pieces) {
  int moving = 0, free = 0;
  report["pieces"] = json::array();
  for (const PieceVerdict& piece : pieces) {
    report["pieces"].push_back(to_json(piece));
    moving += piece.moves();
    free += piece.moves() && piece.valid();
  }
  session.print(fmt::format("motion     {}, {} with a motion, {} proven free of collision at every moment\n",
                            count(static_cast<long>(pieces.size()), "piece"), moving, free));
  for (const PieceVerdict& piece : pieces) {
    if (!piece.moves() && piece.hinges > 0) session.print(fmt::format("  {} has no motion\n", piece.title));
    if (piece.valid()) continue;
    session.print(fmt::format("  {}: {}\n", piece.title, motion_line(*piece.proof)));
    for (const Defect& defect : piece.claims.defects)
      session.print(fmt::format("  {}: {}: {}\n", defect.code, piece.title, defect.message));
  }
}

void report_parts(Session& session, const PartsVerdict& verdict) {
  report_net(session, verdict.net);
  json& report = session.report();
  report["kind"] = "parts";
  report["named_parts"] = verdict.parts;
  report["in_one_piece"] = verdict.in_one_piece;
  report["seam_edges"] = verdict.seam_edges;
  report["seam_length"] = verdict.seam_length;
  report["joints"] = verdict.joints;
  report["part_defects"] = defects_json(verdict.defects);
  session.print(fmt::format("parts      {}, {} with a net in one piece; seams of {}, {:.6g} long\n", verdict.parts,
                            verdict.in_one_piece, count(verdict.seam_edges, "edge"), verdict.seam_length));
  if (verdict.joints > 0)
    session.print(fmt::format("joints     {} of facets, glued face to face\n", count(verdict.joints, "pair")));
  session.print(lines_of(verdict.defects));
  session.print(fmt::format("together   {}\n", verdict.valid() ? "yes" : verdict.net.complete ? "no" : "not finished"));
}

// Parts claim more than their nets: that they are the mesh, what is glued where and in which order, and how each folds.
int verify_parts_file(const FoldFile& file, const PartsClaim& claim, const std::optional<Mesh>& given,
                      const VerifyArgs& args, Session& session) {
  if (!given && file.folded.empty()) return verify_net_file(file, given, args, session);
  const Run run = session.run();
  PartsVerdict verdict = verify_parts(claim, file.net, given ? *given : folded_mesh(file), run);
  if (given)
    if (std::optional<Defect> found = judge_folded_form(file, *given)) verdict.defects.push_back(std::move(*found));
  report_parts(session, verdict);
  bool complete = verdict.net.complete, valid = verdict.valid();
  if (!file.pieces.empty()) {
    const std::vector<PieceVerdict> pieces = judge_pieces(file, args.clearance, run);
    session.report()["kind"] = "kit";
    report_pieces(session, session.report(), pieces);
    for (const PieceVerdict& piece : pieces) complete = complete && piece.complete(), valid = valid && piece.valid();
  }
  session.report()["valid"] = valid;
  if (file.path && args.noise > 0 && !run.over())
    report_noise(file, make_linkage(file.net.sheet, file.net.mate), args, session);
  print_verified(session, complete, valid);
  if (!complete && run.over()) return Session::exit_code(run.ending());
  return valid ? kDone : kNo;
}

// A crease pattern claims to be a flat sheet: no two of its panels overlap.
// Orders of layers in the file are a claim as well, when its goal is flat. True when there is nothing wrong with them.
bool layers_hold(const FoldFile& file, Session& session) {
  const std::vector<FaceOrder> orders = face_orders(file);
  if (orders.empty()) return true;
  const FlatLayersVerdict verdict = check_flat_layers(file.net.sheet, orders);
  const bool holds = verdict.valid || !verdict.flat_goal;
  session.report()["layers"] = {{"pairs", orders.size()}, {"valid", verdict.valid}, {"why", verdict.why}};
  if (!verdict.flat_goal)
    session.print("unchecked  faceOrders: the goal is not flat\n");
  else if (verdict.valid)
    session.print(fmt::format("layers     {} in order, looked at in {} places\n",
                              count(static_cast<long>(orders.size()), "pair"), verdict.places));
  else
    session.print(fmt::format("layers     {}: panels {}\n", verdict.why, fmt::join(verdict.panels, ", ")));
  return holds;
}

// The same of the order of layers in the last frame of a motion.
bool end_layers_hold(const FoldFile& file, const Linkage& linkage, Session& session) {
  if (file.end_orders.empty()) return true;
  const CreasePattern end = end_of_motion(file.net.sheet, linkage, file.path->waypoints.back().config);
  const FlatLayersVerdict verdict = check_flat_layers(end, file.end_orders);
  session.report()["end_layers"] = {{"pairs", file.end_orders.size()}, {"valid", verdict.valid}, {"why", verdict.why}};
  session.print(verdict.valid
                    ? fmt::format("layers     {} in order at the end, looked at in {} places\n",
                                  count(static_cast<long>(file.end_orders.size()), "pair"), verdict.places)
                    : fmt::format("layers     {}: panels {}\n", verdict.why, fmt::join(verdict.panels, ", ")));
  return verdict.valid;
}

int verify_sheet_file(const FoldFile& file, Session& session) {
  const Run run = session.run();
  const CreasePattern& sheet = file.net.sheet;
  const Overlaps overlaps = find_overlaps(sheet, {}, run);
  json& report = session.report();
  report["kind"] = "crease-pattern";
  report["panels"] = sheet.num_faces();
  report["parts"] = file.net.num_parts();
  report["overlaps"] = to_json(overlaps);
  session.print(
      fmt::format("sheet      {}, {}\n", count(sheet.num_faces(), "panel"), count(file.net.num_parts(), "part")));
  session.print(fmt::format("overlap    {}\n", count(overlaps.count, "pair")));
  const bool valid = overlaps.complete && overlaps.count == 0 && layers_hold(file, session);
  report["valid"] = valid;
  session.print(fmt::format("verified   {}\n", !overlaps.complete ? "not finished" : valid ? "yes" : "no"));
  if (!overlaps.complete && run.over()) return Session::exit_code(run.ending());
  return valid ? kDone : kNo;
}

[[noreturn]] void refuse_mesh(const VerifyArgs& args) {
  throw InvalidInput("verify/no-net", fmt::format("{} does not say which mesh its panels come from", args.file), {},
                     fmt::format("plico verify {}", args.file));
}

// A motion claims that its panels never penetrate each other on the way.
int verify_motion_file(const FoldFile& file, const std::optional<Mesh>& mesh, const VerifyArgs& args,
                       Session& session) {
  const Run run = session.run();
  const Linkage linkage = make_linkage(file.net.sheet, file.net.mate);
  if (mesh && (file.net.mesh_face.empty() || file.net.mesh_vertex.empty())) refuse_mesh(args);
  const FileVerdict claims = judge_motion(file, linkage, mesh, run);
  PathProofOptions options{.clearance = args.clearance};
  if (claims.may_deform > 0) {
    const double exact = args.clearance > 0 ? args.clearance : default_clearance(linkage);
    options.clearance = deformed_clearance(exact, claims.may_deform);
    options.closing = kOpenOnPurpose;
  }
  const PathProof proof = prove_path(linkage, *file.path, options, run);
  json& report = session.report();
  report["kind"] = "motion";
  report["panels"] = linkage.num_panels();
  report["hinges"] = linkage.num_hinges();
  report["waypoints"] = file.path->waypoints.size();
  report["motion"] = motion_json(proof);
  report["short_of_goal_deg"] = degrees((file.path->waypoints.back().config - goal(linkage)).lpNorm<Eigen::Infinity>());
  report["progress"] = claims.share;
  report["defects"] = defects_json(claims.defects);
  report["unchecked"] = claims.unchecked;
  const bool finished = claims.complete && !proof.interrupted;
  session.print(fmt::format("motion     {}, {}, {}\n", count(linkage.num_panels(), "panel"),
                            count(linkage.num_hinges(), "fold"),
                            count(static_cast<long>(file.path->waypoints.size()), "waypoint")));
  session.print(fmt::format("proof      {}\n", motion_line(proof)));
  if (linkage.has_loops()) session.print(fmt::format("loops      {}\n", loops_line(proof.loops)));
  if (claims.may_deform > 0) {
    report["deformation"] = {{"allowed", claims.may_deform}, {"measured", claims.deformation}};
    session.print(
        fmt::format("deformed   edges change their length by up to {:.2g} %, {:.3g} % allowed by the file; "
                    "panels are shrunk by {:.3g}\n",
                    100 * claims.deformation, 100 * claims.may_deform, proof.clearance));
  }
  if (claims.is_partial)
    session.print(
        fmt::format("goal       not reached: it ends at {:.4g} % of the way, as the file says\n", 100 * claims.share));
  const bool valid = proof.verdict == PathVerdict::Free && claims.complete && claims.defects.empty() &&
                     end_layers_hold(file, linkage, session);
  report["valid"] = valid;
  session.print(lines_of(claims.defects));
  for (const std::string& what : claims.unchecked) session.print(fmt::format("unchecked  {}\n", what));
  if (args.noise > 0 && !run.over()) report_noise(file, linkage, args, session);
  std::string yes = claims.is_partial ? "yes, as far as it goes" : "yes";
  if (claims.may_deform > 0) yes += fmt::format(", deformed by up to {:.2g} %", 100 * claims.deformation);
  session.print(fmt::format("verified   {}\n", !finished ? std::string("not finished")
                                               : valid   ? yes
                                                         : std::string("no")));
  if (!finished && run.over()) return Session::exit_code(run.ending());
  return valid ? kDone : kNo;
}

// Kits of one piece, and those of version 0.1, have one motion of the whole sheet.
int verify_joined_kit_file(const FoldFile& file, const PartsClaim& claim, const VerifyArgs& args, Session& session) {
  const std::optional<Mesh> mesh = given_mesh(file, args, session);
  const int moves = verify_motion_file(file, mesh, args, session);
  const int fits = verify_parts_file(file, claim, mesh, args, session);
  session.report()["kind"] = "kit";
  session.report()["valid"] = moves == kDone && fits == kDone;
  return std::max(moves, fits);
}

// That the motion in the file begins in the stack and keeps all panels apart, and that its points are where its angles
// put them; said how far it goes.
bool is_chain_motion_free(const FoldFile& file, const ChainClaim& claim, Session& session) {
  ChainMotionVerdict verdict = judge_chain_motion(claim, *file.path, {}, session.run());
  if (points_are_elsewhere(file, claim))
    verdict.defects.push_back({"motion/points", "the points of a frame are not where its fold angles put them"});
  const int hinges = static_cast<int>(claim.stack.size());
  session.report()["motion"] = {
      {"verdict", name(verdict.verdict)}, {"from", verdict.from}, {"panels", {verdict.panel_a, verdict.panel_b}},
      {"opened", verdict.opened},         {"hinges", hinges},     {"defects", defects_json(verdict.defects)}};
  std::string text = fmt::format("{} of {} hinges reach the shape", verdict.opened, hinges);
  if (verdict.verdict == PathVerdict::Collides)
    text = fmt::format("panels {} and {} collide at t = {:.6g}", verdict.panel_a, verdict.panel_b, verdict.from);
  else if (verdict.verdict == PathVerdict::Free)
    text += ", proven free of collision at every moment";
  else
    text += fmt::format(", undecided from t = {:.6g} on", verdict.from);
  session.print(fmt::format("motion     {}\n", text));
  session.print(lines_of(verdict.defects));
  return verdict.free();
}

// A chain claims to fold into a closed shape of squares, and into a stack without two panels in one slot.
int verify_chain_file(const FoldFile& file, const ChainClaim& claim, Session& session) {
  const ChainVerdict verdict = verify_chain(claim);
  json& report = session.report();
  report["kind"] = "chain";
  report["panels"] = verdict.panels;
  report["stack"] = {verdict.width, verdict.depth, verdict.height};
  report["ideal_layers"] = verdict.ideal;
  report["shape_error"] = verdict.shape_error;
  report["stack_error"] = verdict.stack_error;
  report["defects"] = defects_json(verdict.defects);
  report["valid"] = verdict.valid();
  session.print(fmt::format("chain      {}\n", count(verdict.panels, "panel")));
  session.print(fmt::format("shape      off by {:.2g} sides\n", verdict.shape_error));
  session.print(fmt::format("stack      {} x {} x {} layers, off by {:.2g} sides\n", verdict.width, verdict.depth,
                            verdict.height, verdict.stack_error));
  session.print(lines_of(verdict.defects));
  const bool moves = !file.path || !verdict.valid() || is_chain_motion_free(file, claim, session);
  const bool holds = verdict.valid() && moves;
  report["valid"] = holds;
  session.print(fmt::format("verified   {}\n", holds ? "yes" : "no"));
  if (verdict.valid() && !holds && session.run().over()) return Session::exit_code(session.run().ending());
  return holds ? kDone : kNo;
}

int verify_file(const VerifyArgs& args, Session& session) {
  if (args.file == "-" && args.mesh == "-") throw InvalidOption("only one of the two files can be standard input");
  FoldFile file = read_sheet(args.file, session);
  if (const std::optional<ChainClaim> chain = chain_claim(file)) {
    take_told_motion(file, *chain);
    return verify_chain_file(file, *chain, session);
  }
  const std::optional<PartsClaim> parts = parts_claim(file);
  switch (kind(file)) {
    case FoldKind::Net:
      if (parts) return verify_parts_file(file, *parts, given_mesh(file, args, session), args, session);
      return verify_net_file(file, given_mesh(file, args, session), args, session);
    case FoldKind::CreasePattern:
      if (!args.mesh.empty()) refuse_mesh(args);
      return verify_sheet_file(file, session);
    case FoldKind::Motion:
      if (parts && !file.pieces.empty())
        return verify_parts_file(file, *parts, given_mesh(file, args, session), args, session);
      if (parts) return verify_joined_kit_file(file, *parts, args, session);
      return verify_motion_file(file, given_mesh(file, args, session), args, session);
  }
  return kInternal;
}

}  // namespace

Job verify_job() {
  const auto args = std::make_shared<VerifyArgs>();
  Job job("verify", "Check from scratch that a net is right: no overlap, true to the mesh, closes when folded");
  job.example("plico verify bird.fold bird.obj", "is this a net of this mesh?")
      .example("plico verify bird.fold", "the same, against the folded form in the file")
      .example("plico unfold bird.obj -o - | plico verify - --json", "every figure, for a program")
      .example("plico verify parts.fold bird.obj", "do these parts make this mesh, with seams numbered alike?")
      .example("plico verify motion.fold --angle-noise 6deg", "is this motion free of collision, and how robust is it?")
      .positional("file", "net, crease pattern or motion: FOLD, .cp, .opx, .ori or SVG", args->file)
      .positional("mesh", "the mesh it was made from; without it, the folded form in the file", args->mesh, false)
      .option("--clearance", "LENGTH", "motions: how far panels are shrunk, file's unit; 0: 1/1000 of the mean side",
              args->clearance, at_least(0))
      .angle("--angle-noise", "motions: also fold with every crease off by up to this much", args->noise, at_least(0))
      .option("--samples", "N", "motions folded with --angle-noise", args->samples, at_least(1))
      .action([args](Session& session) { return verify_file(*args, session); });
  add_repair_option(job, args->repair);
  return job;
}

}  // namespace plico::jobs
