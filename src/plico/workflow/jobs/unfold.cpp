// plico unfold: a mesh becomes one verified net, or the fewest parts found.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/pattern/fold.h"
#include "plico/mesh/measures.h"
#include "plico/workflow/foldable_net.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/motion_report.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/unfold_mesh.h"

namespace plico::jobs {
namespace {

using nlohmann::json;

struct UnfoldArgs {
  std::string mesh, method = "search", foldable = "none", optimize = "none", repair = "safe";
  UnfoldOptions options;
  int max_steps = -1;
};

std::string faces_in_the_way(const UnfoldOutcome& outcome) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(outcome.in_the_way.size(), 5); ++i)
    text += fmt::format("{}{}-{}", i ? ", " : "", outcome.in_the_way[i].first, outcome.in_the_way[i].second);
  return text + (outcome.in_the_way.size() > 5 ? ", ..." : "");
}

json features_json(const NetFeatures& features) {
  return {{"cut_length", features.cut_length},
          {"hull_area", features.hull_area},
          {"box_area", features.box_area},
          {"longest_branch", features.longest_branch}};
}

std::string gain(double before, double after) {
  return fmt::format("{:.3g} to {:.3g} ({:+.0f} %)", before, after, before > 0 ? 100 * (after / before - 1) : 0.0);
}

void say_gain(const Session& session, const UnfoldOutcome& outcome) {
  const NetFeatures &first = outcome.first, &best = outcome.best;
  session.say(fmt::format("optimized in {:.3g} s: cut length {}, hull area {}, page area {}", outcome.optimize_seconds,
                          gain(first.cut_length, best.cut_length), gain(first.hull_area, best.hull_area),
                          gain(first.box_area, best.box_area)));
}

void report_outcome(Session& session, const Mesh& mesh, const UnfoldArgs& args, const UnfoldOutcome& outcome) {
  json& report = session.report();
  report["faces"] = mesh.num_faces();
  report["components"] = components(mesh).count;
  report["method"] = args.method;
  report["ending"] = name(outcome.ending);
  report["parts"] = outcome.verdict.parts;
  report["steps"] = outcome.steps;
  report["start_overlaps"] = outcome.start_overlaps;
  report["proven_impossible"] = outcome.proven_impossible;
  report["in_the_way"] = outcome.in_the_way;
  if (args.options.optimize) {
    report["optimize"] = args.optimize;
    report["first_net"] = features_json(outcome.first);
    report["net"] = features_json(outcome.best);
    report["optimize_seconds"] = outcome.optimize_seconds;
  }
  report["verified"] = outcome.verified();
  report["overlaps"] = outcome.verdict.overlaps.count;
  report["congruence_error"] = outcome.verdict.congruence_error;
  report["closing_error"] = outcome.verdict.closing_error;
  report["search_seconds"] = outcome.search_seconds;
  report["verify_seconds"] = outcome.verify_seconds;
}

void say_outcome(const Session& session, const Mesh& mesh, const UnfoldOutcome& outcome) {
  const int parts = outcome.verdict.parts;
  session.say(fmt::format("{} faces: {} {}, {}; search {:.3g} s, layout and verification {:.3g} s", mesh.num_faces(),
                          parts, parts == 1 ? "part" : "parts",
                          outcome.verified() ? "verified free of overlap" : "NOT verified", outcome.search_seconds,
                          outcome.verify_seconds));
  if (outcome.best.cut_length > 0) say_gain(session, outcome);
  for (const Defect& defect : outcome.verdict.defects) session.warn(defect.message);
  if (outcome.ending == Ending::Found) return;
  if (outcome.proven_impossible) {
    session.warn("no single net exists for a component: every spanning tree overlaps");
  } else if (!outcome.in_the_way.empty()) {
    session.warn(
        fmt::format("no single net found; cut apart were the overlapping faces {}", faces_in_the_way(outcome)));
  } else {
    session.warn(
        fmt::format("no single net found; the best tree had {} overlaps, try --method search", outcome.start_overlaps));
  }
}

std::string line_about(const UnfoldArgs& args, const Mesh& mesh, const NetAndMotion& found) {
  if (found.net.ending == Ending::Found)
    return fmt::format("{} faces: one net; {} motion {}", mesh.num_faces(), args.foldable,
                       motion_line(found.net.proof));
  if (!found.net.crossing.empty())
    return fmt::format(
        "one piece cannot fold into a shape that passes through itself (faces {} and {}, {} pairs in all)",
        found.net.crossing.front().first, found.net.crossing.front().second, found.net.crossing.size());
  std::string text =
      found.net.proven_impossible
          ? fmt::format("no net of this mesh folds by a {} motion: every spanning tree overlaps or collides",
                        args.foldable)
          : fmt::format("no net found whose {} motion is free; {}", args.foldable,
                        found.net.collisions > 0 ? fmt::format("the best has {} collisions", found.net.collisions)
                                                 : "no collision was counted yet");
  if (found.motion) text += fmt::format("; {} motion {}", name(found.motion->method), motion_line(found.motion->proof));
  return text;
}

// A net that folds by the law asked for, or the best net with a planned motion.
int unfold_foldable(const UnfoldArgs& args, const Mesh& mesh, const std::vector<std::string>& outputs,
                    Session& session) {
  const FoldingLaw law = args.foldable == "uniform" ? FoldingLaw::Uniform : FoldingLaw::Linear;
  const NetAndMotion found = fold_or_plan(mesh, {.seed = session.seed(), .law = law}, session.run());
  const Unfolding net = lay_flat(mesh, found.net.tree);
  const NetVerdict verdict = verify_net(net, mesh);
  json& report = session.report();
  report["faces"] = mesh.num_faces();
  report["foldable"] = args.foldable;
  report["ending"] = name(found.net.ending);
  report["steps"] = found.net.steps;
  report["parts"] = verdict.parts;
  report["overlaps"] = verdict.overlaps.count;
  report["collisions"] = found.net.collisions;
  report["proven_impossible"] = found.net.proven_impossible;
  report["crossing"] = found.net.crossing;
  FoldFile file = fold_file(mesh, net);
  json provenance = session.provenance();
  if (found.motion) {
    report["motion"] = motion_json(found.motion->proof);
    report["motion"]["planner"] = name(found.motion->method);
    if (found.motion->proof.verdict == PathVerdict::Free) {
      set_path(file, linkage_of(net), found.motion->path);
      provenance["motion"] = report["motion"];
    }
  }
  session.say(line_about(args, mesh, found));
  if (!verdict.valid()) return kInternal;
  file.report = provenance.dump();
  for (const std::string& path : outputs) session.write(path, write_fold(file));
  return Session::exit_code(found.net.ending);
}

int unfold_file(UnfoldArgs& args, Session& session) {
  set_method(args.options, args.method);
  args.options.search.seed = session.seed();
  args.options.search.max_steps = args.max_steps;
  if (args.optimize != "none") args.options.optimize = OptimizeOptions{.weights = weights_for(args.optimize)};
  if (args.optimize != "none" && args.foldable != "none")
    throw InvalidOption("optimize cannot be combined with foldable: a net that folds is not changed afterwards");
  check(args.options);
  const std::vector<std::string> outputs = fold_outputs(session);
  const Mesh mesh = read_mesh(args.mesh, args.repair, session);
  if (args.foldable != "none") return unfold_foldable(args, mesh, outputs, session);
  const UnfoldOutcome outcome = unfold_mesh(mesh, args.options, session.run());
  report_outcome(session, mesh, args, outcome);
  say_outcome(session, mesh, outcome);
  if (!outcome.verified()) return kInternal;
  if (outcome.ending == Ending::TimedOut)
    session.repeat_with(args.options.evolve ? "--max-generations" : "--max-steps", std::to_string(outcome.steps));
  FoldFile file = fold_file(mesh, outcome.unfolding);
  file.report = session.provenance().dump();
  const std::string bytes = write_fold(file);
  for (const std::string& path : outputs) session.write(path, bytes);
  return Session::exit_code(outcome.ending);
}

}  // namespace

Job unfold_job() {
  auto args = std::make_shared<UnfoldArgs>();
  SearchOptions& search = args->options.search;
  Job job("unfold", "Cut a mesh open and lay it flat: one verified net, or the fewest parts found");
  job.example("plico unfold bird.obj -o bird.fold", "one net in a FOLD file")
      .example("plico unfold bird.obj -o - | plico print - -o bird.pdf", "and straight on to printable pages")
      .example("plico unfold bird.obj --method steepest-edge -o bird.fold",
               "by a classic heuristic, in parts if need be")
      .example("plico unfold bird.obj --foldable linear -o motion.fold", "a net that folds, with its proven motion")
      .positional("mesh", "OBJ, OFF, STL or PLY file; - for standard input", args->mesh)
      .choice("--foldable", "search a net whose linear or uniform motion is proven free, and write that motion too",
              args->foldable, {"none", "linear", "uniform"})
      .choice("--method", "how the spanning tree is found", args->method, unfold_methods())
      .choice("--optimize", "make the net better: cut it less, or let it need a smaller hull or page", args->optimize,
              {"none", "cut-length", "hull-area", "page"})
      .option("--directions", "N", "random directions tried by a heuristic method", args->options.directions,
              at_least(1))
      .option("--max-generations", "N", "generations of the genetic search (--method eu)",
              args->options.evolution.max_generations, at_least(0))
      .option("--starts", "N", "grown trees of which the search takes the best", search.starts, at_least(1))
      .option("--effort", "N", "panels looked at in one step of the search", search.effort, at_least(1))
      .option("--max-steps", "N", "steps of the search; -1: 10,000 and 100 more a face", args->max_steps, at_least(-1))
      .action([args](Session& session) { return unfold_file(*args, session); });
  add_repair_option(job, args->repair);
  return job;
}

}  // namespace plico::jobs
