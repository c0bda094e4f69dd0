// plico edit: edits of a net, as the studio stores them, replayed.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/text/file.h"
#include "plico/verify/net.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/open_project.h"

namespace plico::jobs {
namespace {

struct EditArgs {
  std::string file, edits;
};

void replay(Project& project, const EditArgs& args, Session& session) {
  if (args.edits.empty()) return;
  const std::vector<Edit> edits = read_edits(session.read(args.edits), args.edits);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    try {
      apply_edit(project, edits[i]);
    } catch (const InvalidOption& error) {
      throw InvalidInput("project/edit", fmt::format("edit {} does not fit: {}", i, error.what()), args.edits);
    }
  }
  session.report()["edits"] = edits.size();
}

void write_edited(Session& session, const std::string& path, const Project& project, const Unfolding& net) {
  if (extension(path) == "plico") return session.write(path, write_project(project));
  write_fold_files(fold_file(project.mesh, net), {path}, session);
}

void require_edited_kind(const std::string& path) {
  const std::string kind = extension(path);
  if (path != "-" && kind != "fold" && kind != "plico")
    throw InvalidOption(fmt::format("'{}' is no kind of file that edit writes", path), "use .fold or .plico");
}

int edit_file(const EditArgs& args, Session& session) {
  const std::vector<std::string> outputs = session.outputs("-");
  for (const std::string& path : outputs) require_edited_kind(path);
  OpenedProject opened = open_project(session.read(args.file), args.file);
  for (const std::string& note : opened.notes) session.say(note);
  replay(opened.project, args, session);
  const Unfolding net = lay_flat(opened.project.mesh, opened.project.forest);
  const NetVerdict verdict = verify_net(net, opened.project.mesh, {}, session.run());
  session.report()["parts"] = verdict.parts;
  session.report()["overlaps"] = verdict.overlaps.count;
  session.report()["verified"] = verdict.valid();
  session.say(fmt::format("{} panels in {} {}, {}", verdict.panels, verdict.parts,
                          verdict.parts == 1 ? "part" : "parts",
                          verdict.valid() ? "verified free of overlap" : "NOT a net"));
  for (const Defect& defect : verdict.defects) session.warn(defect.message);
  for (const std::string& path : outputs) write_edited(session, path, opened.project, net);
  return verdict.valid() ? kDone : kNo;
}

}  // namespace

Job edit_job() {
  auto args = std::make_shared<EditArgs>();
  Job job("edit", "Cut, join and move parts of a net by a list of edits, as the studio writes it");
  job.example("plico edit bird.fold --edits edits.json -o edited.fold", "the same net as in the studio")
      .example("plico edit bird.fold -o bird.plico", "a project to open in the studio")
      .example("plico edit bird.plico -o bird.fold", "and the net of a project")
      .positional("file", "net with its folded form (FOLD), project (.plico) or mesh", args->file)
      .option("--edits", "FILE",
              "JSON list: {\"edit\": \"cut\" or \"join\", \"edge\": N}, {\"edit\": \"move\", \"join\": N, \"cut\": N}, "
              "{\"edit\": \"lock\", \"edge\": N, \"locked\": true}, {\"edit\": \"net\", \"folds\": [N, ...]}",
              args->edits)
      .action([args](Session& session) { return edit_file(*args, session); });
  return job;
}

}  // namespace plico::jobs
