// plico fold: a net gets a motion that is proven free of collision.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "motion_report.h"
#include "plico/base/error.h"
#include "plico/io/fold.h"
#include "plico/workflow/plan_motion.h"
#include "session.h"

namespace plico::cli {
namespace {

struct FoldArgs {
  std::string net, planner = "auto";
  int alternatives = 1;
  double clearance = 0;
};

// "motion.fold", "motion-2.fold", ...: alternatives stand beside the first.
std::string path_of_alternative(const std::string& path, std::size_t i) {
  const std::size_t dot = path.rfind('.');
  if (i == 0 || path == "-") return path;
  return path.substr(0, dot) + fmt::format("-{}", i + 1) + (dot == std::string::npos ? "" : path.substr(dot));
}

void write_motions(Session& session, FoldFile& file, const Linkage& linkage, const MotionOutcome& outcome,
                   const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outcome.motions.size(); ++i) {
    nlohmann::json provenance = session.provenance();
    provenance["motion"] = motion_json(outcome.motions[i].proof);
    provenance["motion"]["planner"] = motion_methods()[static_cast<int>(outcome.motions[i].method)];
    file.report = provenance.dump();
    set_path(file, linkage, outcome.motions[i].path);
    const std::string bytes = write_fold(file);
    for (const std::string& path : outputs)
      if (i == 0 || path != "-") session.write(path_of_alternative(path, i), bytes);
  }
}

int fold_file(const FoldArgs& args, Session& session) {
  MotionOptions options{session.seed(), motion_method(args.planner), args.alternatives, args.clearance};
  const std::vector<std::string> outputs = session.outputs("-");
  FoldFile file = read_fold(session.read(args.net), args.net);
  const Linkage linkage = make_linkage(file.net.sheet, file.net.mate);
  const MotionOutcome outcome = plan_motion(linkage, options, session.run());
  nlohmann::json motions = nlohmann::json::array();
  for (const Motion& motion : outcome.motions) {
    motions.push_back(motion_json(motion.proof));
    motions.back()["planner"] = motion_methods()[static_cast<int>(motion.method)];
    session.say(fmt::format("{} motion: {}", motions.back()["planner"].get<std::string>(), motion_line(motion.proof)));
  }
  session.report()["panels"] = linkage.num_panels();
  session.report()["hinges"] = linkage.num_hinges();
  session.report()["ending"] = name(outcome.ending);
  session.report()["motions"] = motions;
  write_motions(session, file, linkage, outcome, outputs);
  return Session::exit_code(outcome.ending);
}

}  // namespace

Command fold_command() {
  auto args = std::make_shared<FoldArgs>();
  return Command("fold", "Find a motion that folds a net, and prove that nothing collides on the way")
      .example("plico fold bird.fold -o motion.fold", "the straight motion if it is free, else a planned one")
      .example("plico fold bird.fold --planner uniform -o motion.fold", "as a uniformly heated sheet would fold")
      .example("plico fold bird.fold --planner lazy-prm --alternatives 3 --time-limit 60s -o motion.fold",
               "three motions that do not blend into each other")
      .positional("net", "FOLD file with a net; - for standard input", args->net)
      .choice("--planner", "auto tries linear, then uniform, then lazy-prm", args->planner, motion_methods())
      .option("--alternatives", "N", "motions wanted; written beside the first as NAME-2.fold, ...", args->alternatives)
      .option("--clearance", "LENGTH", "how far panels are shrunk, in the file's unit; 0: 1/1000 of the mean side",
              args->clearance)
      .action([args](Session& session) { return fold_file(*args, session); });
}

}  // namespace plico::cli
