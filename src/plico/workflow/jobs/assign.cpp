// plico origami assign: mountains and valleys for the creases that were drawn without.
#include "plico/origami/assign.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/origami/layer_order.h"
#include "plico/verify/flat_layers.h"
#include "plico/workflow/jobs/face_orders.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {
namespace {

struct AssignArgs {
  std::string file;
  bool afresh = false;
  AssignOptions options;
  DrawingOptions drawing;
};

void forget_letters(CreasePattern& sheet) {
  for (Crease& crease : sheet.edges)
    if (crease.assignment == Assignment::Mountain || crease.assignment == Assignment::Valley) {
      crease.assignment = Assignment::Unassigned;
      crease.fold_angle = 0;
    }
}

int count(const CreasePattern& sheet, Assignment assignment) {
  return static_cast<int>(std::count_if(sheet.edges.begin(), sheet.edges.end(),
                                        [&](const Crease& crease) { return crease.assignment == assignment; }));
}

// A goal that is not flat has no layers to be in each other's way.
bool has_layers_or_needs_none(const CreasePattern& sheet, const Run& run) {
  const LayerOrder layers = order_layers(sheet, run);
  return layers.ending == Ending::Found || !layers.flat_goal;
}

// The order of the layers as FOLD has it, if there is one that stands the check.
void write_layers(FoldFile& file, Session& session) {
  const LayerOrder layers = order_layers(file.net.sheet, session.run());
  session.report()["layers"] = name(layers.ending);
  if (layers.ending != Ending::Found)
    return session.say("layers: " + (layers.why.empty() ? std::string("the search was cut short") : layers.why));
  const FlatLayersVerdict verdict = check_flat_layers(file.net.sheet, layers.orders);
  session.report()["layers_verified"] = verdict.valid;
  if (!verdict.valid) return session.say(fmt::format("layers: an order was found but not verified: {}", verdict.why));
  set_face_orders(file, layers.orders);
  session.say(fmt::format("layers: an order of {} pairs of panels that lie on each other, verified at {} places",
                          layers.orders.size(), verdict.places));
}

int assign_file(const AssignArgs& args, Session& session) {
  const std::vector<std::string> outputs = fold_outputs(session);
  FoldFile file = read_sheet(args.file, session, args.drawing);
  if (args.afresh) forget_letters(file.net.sheet);
  AssignOptions options = args.options;
  if (file.net.sheet.num_faces() <= kMostLayered)
    options.suits = [&](const CreasePattern& sheet) { return has_layers_or_needs_none(sheet, session.run()); };
  const AssignResult found = assign_creases(file.net.sheet, options, session.run());
  session.report()["ending"] = name(found.ending);
  session.report()["assigned"] = found.assigned;
  if (found.ending != Ending::Found) {
    session.report()["vertices"] = found.vertices;
    session.say(found.ending == Ending::Exhausted ? "no mountains and valleys fold this sheet flat: " + found.why
                                                  : "the search was cut short");
    return Session::exit_code(found.ending);
  }
  const int mountains = count(found.sheet, Assignment::Mountain), valleys = count(found.sheet, Assignment::Valley);
  session.report()["mountains"] = mountains;
  session.report()["valleys"] = valleys;
  session.say(fmt::format("{} crease{} assigned: {} mountain, {} valley in all; every vertex folds flat by itself",
                          found.assigned, found.assigned == 1 ? "" : "s", mountains, valleys));
  if (!found.suits)
    session.say(fmt::format("none of the choices tried, at most {}, has an order of its layers; this is the first",
                            options.max_refused + 1));
  set_sheet(file, found.sheet);
  write_layers(file, session);
  write_fold_files(file, outputs, session);
  return kDone;
}

}  // namespace

Job origami_assign_job() {
  const auto args = std::make_shared<AssignArgs>();
  Job job =
      Job("origami assign", "Find mountains and valleys for the creases of a pattern that have none")
          .example("plico origami assign lines.svg -o assigned.fold", "then plico fold assigned.fold -o motion.fold")
          .example("plico origami assign drawn.cp --tolerance 1deg -o assigned.fold",
                   "of a drawing whose sectors are off by up to a degree")
          .example("plico origami assign crane.fold --afresh -o other.fold",
                   "as if no crease had a mountain or a valley")
          .positional("PATTERN", "FOLD, .cp, .opx, .ori or SVG file; - is standard input", args->file)
          .flag("--afresh", "the mountains and valleys that are there count as unassigned", args->afresh)
          .angle("--tolerance", "what sectors and their sums may be off by", args->options.angle)
          .action([args](Session& session) { return assign_file(*args, session); });
  add_drawing_options(job, args->drawing);
  return job;
}

}  // namespace plico::jobs
