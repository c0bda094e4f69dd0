// plico fold: a net or a crease pattern gets a motion that is proven free of collision.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/pattern/fold.h"
#include "plico/verify/deformation.h"
#include "plico/workflow/end_layers.h"
#include "plico/workflow/jobs/first_try.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/motion_report.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/plan_origami.h"
#include "plico/workflow/plan_pieces.h"
#include "plico/workflow/plan_sheets.h"

namespace plico::jobs {
namespace {

struct FoldArgs {
  std::string net, planner = "auto", reuse, facets = "auto", deformation;
  std::vector<std::string> through;
  bool grouped = false;
  int alternatives = 1, waypoints = 50;
  double clearance = 0, max_fold_angle = std::numeric_limits<double>::quiet_NaN();
  DrawingOptions drawing;
};

// What the command line allows; the file may allow less of single creases.
void narrow_limits(CreasePattern& sheet, double most) {
  if (std::isnan(most)) return;
  if (!(most >= 0 && most <= kPi))
    throw InvalidOption(fmt::format("max-fold-angle = {:.6g} degrees must be in [0, 180]", degrees(most)));
  for (Crease& crease : sheet.edges)
    if (crease.assignment != Assignment::Boundary && crease.assignment != Assignment::Cut)
      crease.limit = std::min(crease.limit, most);
}

// The goal of another file of the same pattern.
Configuration state_of(const std::string& path, const Linkage& linkage, Session& session) {
  const Linkage other = make_linkage(read_sheet(path, session).net.sheet);
  if (other.num_hinges() != linkage.num_hinges())
    throw InvalidInput(
        "fold/through",
        fmt::format("{} has {} creases, the pattern has {}", path, other.num_hinges(), linkage.num_hinges()), path,
        "write the states from the pattern, with other fold angles");
  return goal(other);
}

MotionOutcome reuse(const Linkage& linkage, const MotionOptions& options, const std::string& path, Session& session) {
  const FoldFile small = read_sheet(path, session);
  if (!small.path)
    throw InvalidInput("fold/no-motion", path + " has no motion", path,
                       "plico fold " + path + " --grouped -o motion.fold");
  return reuse_motion(make_linkage(small.net.sheet), *small.path, linkage, options, session.run());
}

// A crease pattern that somebody drew, no net of a mesh.
bool is_drawing(const FoldFile& file, const Linkage& linkage) {
  return file.net.mesh_face.empty() && file.pieces.empty() && linkage.thickness == 0;
}

// "0.1%" or "0.001"; 0 when nothing was given.
double read_deformation(const std::string& text) {
  if (text.empty()) return 0;
  const char* const end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const bool per_cent = error == std::errc() && rest != end && *rest == '%';
  if (per_cent) value /= 100;
  if (error != std::errc() || rest + (per_cent ? 1 : 0) != end || !(value > 0 && value <= kMostDeformation))
    throw InvalidOption(
        fmt::format("--deformation {} must be above 0 and at most {:g} %", text, 100 * kMostDeformation),
        "--deformation 0.1%");
  return value;
}

MotionOutcome plan(const FoldFile& file, const Linkage& linkage, const FoldArgs& args, Session& session) {
  MotionOptions options{session.seed(),
                        motion_method(args.planner),
                        args.alternatives,
                        args.clearance,
                        args.waypoints,
                        args.grouped,
                        {},
                        facet_policy(args.facets),
                        read_deformation(args.deformation)};
  if (linkage.has_loops()) {
    for (const std::string& state : args.through) options.through.push_back(state_of(state, linkage, session));
    if (!args.reuse.empty()) return reuse(linkage, options, args.reuse, session);
    if (options.deformation > 0 && (args.grouped || !args.through.empty() || !args.reuse.empty()))
      throw InvalidOption("--deformation is for every crease by itself, on no given way");
    const bool as_drawn = args.grouped || !args.through.empty();  // both speak of the creases of this very sheet
    return as_drawn ? plan_origami(file.net.sheet, options, session.run())
                    : plan_sheets(file.net.sheet, options, session.run());
  }
  if (args.grouped || !args.reuse.empty() || !args.through.empty() || options.deformation > 0)
    throw InvalidOption(
        "--grouped, --reuse, --through and --deformation are for crease patterns with loops; this sheet has none");
  if (is_drawing(file, linkage) && file.net.num_parts() == 1 && options.alternatives == 1)
    return plan_origami(file.net.sheet, options, session.run());  // goes as far as it can
  return file.pieces.empty() ? plico::plan(linkage, options, session.run())
                             : plan_pieces(file.net, options, session.run());
}

// "motion.fold", "motion-2.fold", ...: alternatives stand beside the first.
std::string path_of_alternative(const std::string& path, std::size_t i) {
  const std::size_t dot = path.rfind('.');
  if (i == 0 || path == "-") return path;
  return path.substr(0, dot) + fmt::format("-{}", i + 1) + (dot == std::string::npos ? "" : path.substr(dot));
}

// Of the way to the goal as the file has it, which the planner may have moved a little.
double share_of_motion(const Linkage& linkage, const MotionOutcome& outcome, std::size_t i) {
  if (outcome.progress >= 1 || i >= outcome.motions.size()) return outcome.progress;
  return share_of_way(linkage, outcome.motions[i].path.waypoints.back().config);
}

// Where a proven motion ends flat, the order of its layers.
void write_end_layers(FoldFile& file, const Linkage& linkage, const Motion& motion, std::size_t i, Session& session) {
  if (motion.proof.verdict != PathVerdict::Free) return;
  EndLayers layers = end_layers(file.net.sheet, linkage, motion.path);
  if (!layers.flat) return;
  session.report()["motions"][i]["end_layers"] = {{"pairs", layers.orders.size()}, {"why", layers.why}};
  session.say(layers.why.empty() ? fmt::format("ends flat: an order of {} pairs of panels that lie on each other, "
                                               "verified at {} places",
                                               layers.orders.size(), layers.places)
                                 : "ends flat without an order of its layers: " + layers.why);
  file.end_orders = std::move(layers.orders);
}

// `allowed`: deformation, of a motion whose loops need not close.
void write_motions(Session& session, FoldFile& file, const Linkage& linkage, const MotionOutcome& outcome,
                   const std::vector<std::string>& outputs, double allowed) {
  for (std::size_t i = 0; i < outcome.motions.size(); ++i) {
    nlohmann::json provenance = session.provenance();
    provenance["motion"] = motion_json(outcome.motions[i].proof);
    if (linkage.has_loops() || outcome.progress < 1)
      provenance["motion"]["progress"] = share_of_motion(linkage, outcome, i);
    provenance["motion"]["planner"] = name(outcome.motions[i].method);
    if (outcome.deformation > 0)
      provenance["motion"]["deformation"] = {{"allowed", allowed}, {"measured", outcome.deformation}};
    file.report = provenance.dump();
    set_path(file, linkage, outcome.motions[i].path);
    if (is_drawing(file, linkage)) write_end_layers(file, linkage, outcome.motions[i], i, session);
    const std::string bytes = write_fold(file);
    for (const std::string& path : outputs)
      if (i == 0 || path != "-") session.write(path_of_alternative(path, i), bytes);
  }
}

std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle = degrees(angle);
  return angles;
}

int fold_file(const FoldArgs& args, Session& session) {
  motion_method(args.planner);
  const std::vector<std::string> outputs = fold_outputs(session);
  FoldFile file = read_sheet(args.net, session, args.drawing);
  narrow_limits(file.net.sheet, args.max_fold_angle);
  Linkage linkage = make_linkage(file.net.sheet, file.net.mate);
  const CreasePattern drawn = file.net.sheet;
  if (const int free = num_unassigned(drawn); free > 0)
    session.say(fmt::format("{} crease{} no mountain or valley: plico origami assign {} -o assigned.fold finds some",
                            free, free == 1 ? " has" : "s have", args.net));
  const MotionOutcome outcome = plan(file, linkage, args, session);
  if (outcome.sheet) {
    set_sheet(file, *outcome.sheet);
    linkage = make_linkage(file.net.sheet);
    if (!outcome.bends.empty()) session.report()["panel_bends_deg"] = in_degrees(outcome.bends);
  }
  nlohmann::json motions = nlohmann::json::array();
  for (const Motion& motion : outcome.motions) {
    motions.push_back(motion_json(motion.proof));
    motions.back()["waypoints"] = motion.path.waypoints.size();
    motions.back()["planner"] = name(motion.method);
    session.say(fmt::format("{} motion: {}", motions.back()["planner"].get<std::string>(), motion_line(motion.proof)));
    if (linkage.has_loops())
      session.say(fmt::format("{} waypoints, {}", motion.path.waypoints.size(), loops_line(motion.proof.loops)));
  }
  if (const auto found = static_cast<int>(outcome.motions.size()); found < args.alternatives && outcome.proven())
    session.say(fmt::format("{} of {} motions found; no other one was that does not blend into {}", found,
                            args.alternatives, found == 1 ? "it" : "these"));
  for (const std::string& note : outcome.notes) session.say(note);
  if (linkage.has_loops()) {
    const double share = share_of_motion(linkage, outcome, 0);
    if (share < 1) session.say(fmt::format("reached {:.4g} % of the way to the goal", 100 * share));
    session.report()["progress"] = share;
    for (const std::string& note : outcome.notes) session.report()["notes"].push_back(note);
    session.report()["deformation"] = outcome.deformation;
    if (!args.deformation.empty() && outcome.deformation == 0 && !outcome.motions.empty())
      session.say("exact: the loops close without any deformation");
    if (!outcome.proven() || share < kStaysFlat) session.say(tell_what_stops(drawn, outcome, args.net));
  } else if (outcome.progress < 1) {
    session.report()["progress"] = share_of_motion(linkage, outcome, 0);
    session.say(fmt::format("reached {:.4g} % of the way to the goal", 100 * share_of_motion(linkage, outcome, 0)));
  }
  session.report()["panels"] = linkage.num_panels();
  session.report()["hinges"] = linkage.num_hinges();
  session.report()["ending"] = name(outcome.ending);
  session.report()["motions"] = motions;
  write_motions(session, file, linkage, outcome, outputs, read_deformation(args.deformation));
  return Session::exit_code(outcome.ending);
}

}  // namespace

Job fold_job() {
  auto args = std::make_shared<FoldArgs>();
  Job job =
      Job("fold", "Find a motion that folds a net or a crease pattern, and prove that nothing collides on the way")
          .example("plico fold bird.fold -o motion.fold", "the straight motion if it is free, else a planned one")
          .example("plico fold bird.fold --planner uniform -o motion.fold", "as a uniformly heated sheet would fold")
          .example("plico fold bird.fold --planner lazy-prm --alternatives 3 --time-limit 60s -o motion.fold",
                   "three motions that do not blend into each other")
          .example("plico fold miura.fold --max-fold-angle 150deg -o motion.fold",
                   "a crease pattern with loops, as far as the material folds")
          .example("plico fold small.fold --grouped -o few.fold && plico fold large.fold --reuse few.fold -o many.fold",
                   "plan a small piece of a tessellation, fold a large one")
          .positional("net", "net or crease pattern: FOLD, .cp, .opx, .ori or SVG; - for standard input", args->net)
          .choice("--planner", "auto tries linear, then uniform, then lazy-prm; with loops continuation, then md-frog",
                  args->planner, motion_methods())
          .option("--alternatives", "N", "motions wanted; written beside the first as NAME-2.fold, ...",
                  args->alternatives, at_least(1))
          .flag("--grouped", "with loops: creases that are alike by symmetry turn together", args->grouped)
          .option("--reuse", "FILE", "with loops: the motion of a smaller piece of the same tessellation, carried over",
                  args->reuse)
          .option("--through", "FILE", "with loops: a state to pass, the goal of FILE; may be repeated", args->through)
          .option("--clearance", "LENGTH", "how far panels are shrunk, in the file's unit; 0: 1/1000 of the mean side",
                  args->clearance, at_least(0))
          .option("--waypoints", "N",
                  "with loops: waypoints aimed at; more are inserted where hinges would open between them",
                  args->waypoints, at_least(1))
          .choice(
              "--facets",
              "with loops: cut panels by flat creases along which they bend: when whole ones stop early, never, all",
              args->facets, facet_policies())
          .option("--deformation", "SHARE",
                  "with loops: how much edges may stretch or shrink where an exact motion stops early, such as 0.1%",
                  args->deformation)
          .angle("--max-fold-angle", "largest fold angle that the material allows; the file may limit each crease",
                 args->max_fold_angle, {0, 180})
          .action([args](Session& session) { return fold_file(*args, session); });
  add_drawing_options(job, args->drawing);
  return job;
}

}  // namespace plico::jobs
