// plico origami assign: mountains and valleys for the creases that were drawn without.
#include "plico/origami/assign.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

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

int assign_file(const AssignArgs& args, Session& session) {
  const std::vector<std::string> outputs = fold_outputs(session);
  FoldFile file = read_sheet(args.file, session, args.drawing);
  if (args.afresh) forget_letters(file.net.sheet);
  const AssignResult found = assign_creases(file.net.sheet, args.options, session.run());
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
  set_sheet(file, found.sheet);
  file.report = session.provenance().dump();
  for (const std::string& path : outputs) session.write(path, write_fold(file));
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
