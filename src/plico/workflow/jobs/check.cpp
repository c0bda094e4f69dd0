// plico check: every problem of a mesh; with --repair, a mesh without them.
#include <fmt/core.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/repair.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {
namespace {

constexpr int kShownOfAKind = 20;

struct Args {
  std::string mesh;
  CheckOptions check;
  bool repair = false, strict = false;
};

bool passes(const CheckReport& report, bool strict) {
  return report.usable() && !(strict && report.count(Severity::Warning) > 0);
}

nlohmann::json to_json(const CheckReport& report, const MeshSource* source) {
  nlohmann::json list = nlohmann::json::array();
  for (const Problem& problem : report.problems) {
    list.push_back({{"severity", name(problem.severity)},
                    {"code", problem.code},
                    {"message", problem.message},
                    {"where", problem.where},
                    {"faces", problem.faces},
                    {"vertices", problem.vertices}});
    if (source) list.back()["place"] = place_of(*source, problem);
  }
  return list;
}

std::string summary(const std::string& path, const CheckReport& report) {
  const int errors = report.count(Severity::Error), warnings = report.count(Severity::Warning);
  const char* verdict = errors > 0 ? "cannot be unfolded" : warnings > 0 ? "can be unfolded" : "fine";
  return fmt::format("{}: {} ({} error{}, {} warning{})\n", path, verdict, errors, errors == 1 ? "" : "s", warnings,
                     warnings == 1 ? "" : "s");
}

// One line a problem, at most kShownOfAKind of a kind.
std::string human(const MeshSource& source, const CheckReport& report) {
  std::string out;
  std::map<std::string, int> shown;
  for (const Problem& problem : report.problems) {
    if (++shown[problem.code] > kShownOfAKind) continue;
    out += fmt::format("{}: {}: {} [{}]{}\n", place_of(source, problem), name(problem.severity), problem.message,
                       problem.code, problem.where.empty() ? "" : " " + problem.where);
  }
  for (const auto& [code, count] : shown)
    if (count > kShownOfAKind) out += fmt::format("{} more of [{}]; --json lists all\n", count - kShownOfAKind, code);
  return out + summary(source.name, report);
}

std::string default_output(const std::string& path) {
  if (path == "-") return "-";
  const auto dot = path.rfind('.');
  return mesh_format_of(path) ? path.substr(0, dot) + ".repaired" + path.substr(dot) : path + ".repaired.obj";
}

int write_repaired(const Args& args, const MeshSource& source, const std::vector<std::string>& outputs,
                   Session& session) {
  const Repaired repaired =
      repair(source.soup, {.planarity = args.check.planarity, .max_coordinate = args.check.max_coordinate});
  for (const std::string& sentence : repaired.done) session.say(sentence);
  if (repaired.done.empty()) session.say("nothing had to be repaired");
  const CheckReport after = check_mesh(repaired.soup, args.check);
  session.report()["repairs"] = repaired.done;
  session.report()["problems_after_repair"] = to_json(after, nullptr);
  if (!passes(after, args.strict)) {
    session.warn("the repaired mesh still cannot be used, nothing is written");
    session.print(summary("repaired", after));
    return kBadInput;
  }
  for (const std::string& path : outputs) session.write(path, write_mesh(repaired.soup, output_format(path)));
  session.print(summary("repaired", after));
  return kDone;
}

int run(const Args& args, Session& session) {
  if (!args.repair && !session.shared().outputs.empty())
    throw InvalidOption("-o writes the repaired mesh and needs --repair", "add --repair");
  std::vector<std::string> outputs;
  if (args.repair) outputs = session.outputs(default_output(args.mesh));
  for (const std::string& path : outputs) output_format(path);
  const MeshSource source = read_mesh_source(session.read(args.mesh), args.mesh);
  const CheckReport report = check_mesh(source.soup, args.check);
  session.report()["usable"] = report.usable();
  session.report()["errors"] = report.count(Severity::Error);
  session.report()["warnings"] = report.count(Severity::Warning);
  session.report()["problems"] = to_json(report, &source);
  session.print(human(source, report));
  if (args.repair) return write_repaired(args, source, outputs, session);
  if (passes(report, args.strict)) return kDone;
  session.say(fmt::format("try: plico check --repair {}", args.mesh));
  return kBadInput;
}

}  // namespace

Job check_job() {
  auto args = std::make_shared<Args>();
  return Job("check", "List everything that is wrong with a mesh, and repair it")
      .example("plico check bunny.obj", "every problem with its place; exit code 3 when there is an error")
      .example("plico check bunny.obj --repair -o clean.obj", "write a repaired mesh and say what was done")
      .example("plico check bunny.obj --json", "the same for programs")
      .positional("MESH", "OBJ, OFF, STL or PLY file; - is standard input", args->mesh)
      .flag("--repair", "write a mesh without the errors", args->repair)
      .flag("--strict", "warnings count as errors", args->strict)
      .option("--planarity", "X", "how far a corner may be off its polygon's plane, as part of the polygon's size",
              args->check.planarity, above(0))
      .option("--max-faces", "N", "refuse meshes with more faces", args->check.max_faces, at_least(1))
      .action([args](Session& session) { return run(*args, session); });
}

}  // namespace plico::jobs
