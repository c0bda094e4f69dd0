// plico origami settle: the least move of the vertices that lets a drawn crease pattern fold.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/origami/settle.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {
namespace {

struct SettleArgs {
  std::string file;
  double most_percent = 20;
  SettleOptions options;
  DrawingOptions drawing;
};

void report_on(const Settled& settled, nlohmann::json& report) {
  report["settled"] = settled.closed;
  report["goal_open_before_rad"] = settled.open_before;
  report["goal_open_rad"] = settled.open;
  report["largest_move"] = settled.move;
  report["largest_move_vertex"] = settled.vertex;
  report["largest_move_of_shortest_edge"] = settled.move_share;
  report["symmetries"] = settled.symmetries;
  report["straight_lines"] = settled.lines;
  report["states"] = settled.states.size();
  report["steps"] = settled.steps;
}

std::string told(const Settled& settled, const FoldFile& file) {
  const Vec2 at = settled.vertex < 0 ? Vec2(Vec2::Zero()) : file.net.sheet.vertices[settled.vertex];
  const std::string farthest =
      settled.vertex < 0 ? "no vertex moved"
                         : fmt::format(
                               "vertices moved by at most {:.3g} {} (vertex {} at {:.6g} {:.6g}), {:.2g} of the "
                               "shortest edge",
                               settled.move, file.unit, settled.vertex, at.x(), at.y(), settled.move_share);
  return fmt::format("the goal was open by {:.2g} rad and closes to {:.2g}, with {} state{} on the way; {}",
                     settled.open_before, settled.open, settled.states.size(), settled.states.size() == 1 ? "" : "s",
                     farthest);
}

int settle_file(const SettleArgs& args, Session& session) {
  if (!(args.most_percent > 0)) throw InvalidOption(fmt::format("--most {:g} must be above 0", args.most_percent));
  SettleOptions options = args.options;
  options.most_move = args.most_percent / 100;
  const std::vector<std::string> outputs = fold_outputs(session);
  FoldFile file = read_sheet(args.file, session, args.drawing);
  const Settled settled = settle(file.net.sheet, options, session.run());
  report_on(settled, session.report());
  if (!settled.closed) {
    session.say(fmt::format(
        "not settled: no move of vertices by up to {:g} % of the shortest edge was found that closes a goal open by "
        "{:.2g} rad{}",
        args.most_percent, settled.open_before, settled.states.empty() ? "" : " and a state on the way"));
    return Session::exit_code(session.run().over() ? session.run().ending() : Ending::Exhausted);
  }
  session.say(told(settled, file));
  session.say(fmt::format("{} straight line{} and {} kept", settled.lines, settled.lines == 1 ? "" : "s",
                          settled.symmetries > 1 ? fmt::format("{} symmetries", settled.symmetries) : "no symmetry"));
  if (options.states > 0 && settled.states.empty())
    session.say("it does not leave flat with whole panels, so only the goal was closed");
  set_sheet(file, settled.sheet);
  write_fold_files(file, outputs, session);
  return kDone;
}

}  // namespace

Job origami_settle_job() {
  const auto args = std::make_shared<SettleArgs>();
  Job job =
      Job("origami settle", "Move the vertices of a drawn crease pattern by as little as lets it fold")
          .example("plico origami settle drawn.svg -o settled.fold", "then plico fold settled.fold -o motion.fold")
          .example("plico origami settle drawn.cp --states 3 -o settled.fold", "three states on the way close as well")
          .example("plico origami settle drawn.svg --states 0 -o flat.fold",
                   "only the goal: for patterns folded by hand")
          .positional("PATTERN", "FOLD, .cp, .opx, .ori or SVG file; - is standard input", args->file)
          .option("--states", "N", "states between flat and the goal that are to close; 0: the goal alone",
                  args->options.states, at_least(0))
          .option("--most", "PERCENT", "how far a vertex may move, in per cent of the shortest edge",
                  args->most_percent, above(0))
          .action([args](Session& session) { return settle_file(*args, session); });
  add_drawing_options(job, args->drawing);
  return job;
}

}  // namespace plico::jobs
