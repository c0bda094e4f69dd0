// plico shell: one convex piece for every part of a shape, no two of which overlap.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_shape.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/share.h"
#include "plico/workflow/shell_shape.h"

namespace plico::jobs {
namespace {

using nlohmann::json;

struct ShellArgs {
  std::string shape, by = "auto", labels, method = "full", nested = "drop", growth;
  ShellOptions options;
  RemeshOptions remesh;
};

CutMethod cut_method(const std::string& word) {
  static const std::map<std::string, CutMethod> methods{{"lsf", CutMethod::Lsf},
                                                        {"svm", CutMethod::Svm},
                                                        {"svm-offset", CutMethod::SvmOffset},
                                                        {"full", CutMethod::Full}};
  return methods.at(word);
}

NestedPolicy nested_policy(const std::string& word) {
  static const std::map<std::string, NestedPolicy> policies{
      {"drop", NestedPolicy::Drop}, {"merge", NestedPolicy::Merge}, {"keep", NestedPolicy::Keep}};
  return policies.at(word);
}

void check_shell_usage(const ShellArgs& args) {
  if (args.by == "labels" && args.labels.empty()) throw InvalidOption("--by labels needs --labels FILE");
  if (args.by != "labels" && !args.labels.empty()) throw InvalidOption("--labels needs --by labels");
  if (args.shape == "-" && args.labels == "-")
    throw InvalidOption("only one of two files, read once, can be standard input");
}

json to_json(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

json shell_list(const std::vector<ShapePart>& parts, const Shells& shells) {
  json list = json::array();
  for (const Shell& shell : shells.shells)
    list.push_back({{"part", parts[shell.part].name},
                    {"triangles", shell.body.facets.size()},
                    {"hull_volume", shell.hull_volume},
                    {"volume", shell.kept_volume}});
  return list;
}

json contact_list(const std::vector<ShapePart>& parts, const Shells& shells) {
  json list = json::array();
  for (const ShellContact& contact : shells.contacts) {
    json polygon = json::array();
    for (const Vec3& p : contact.polygon) polygon.push_back(to_json(p));
    list.push_back(
        {{"parts", {parts[shells.shells[contact.first].part].name, parts[shells.shells[contact.second].part].name}},
         {"cut", contact.cut},
         {"normal", to_json(contact.plane.normal)},
         {"offset", contact.plane.offset},
         {"polygon", std::move(polygon)}});
  }
  return list;
}

int touching(const Shells& shells) {
  int count = 0;
  for (const ShellContact& contact : shells.contacts) count += contact.polygon.empty() ? 0 : 1;
  return count;
}

json report_of(const std::vector<ShapePart>& parts, const ShellArgs& args, const JudgedShells& judged) {
  const Shells& shells = judged.shells;
  const ShellsVerdict& verdict = judged.verdict;
  json nested = json::array(), lost = json::array(), defects = json::array();
  for (std::size_t i = 0; i < shells.nested.size(); ++i)
    nested.push_back({{"part", parts[shells.nested[i]].name}, {"in", parts[shells.hosts[i]].name}});
  for (int part : shells.lost) lost.push_back(parts[part].name);
  for (const Defect& defect : verdict.defects) defects.push_back({{"code", defect.code}, {"message", defect.message}});
  return {{"method", args.method},
          {"ending", name(shells.ending)},
          {"num_parts", parts.size()},
          {"loss", shells.loss()},
          {"least_kept", shells.least_kept()},
          {"union_volume", shells.union_volume},
          {"shell_volume", shells.shell_volume},
          {"sweeps", shells.sweeps},
          {"nested", std::move(nested)},
          {"lost", std::move(lost)},
          {"shells", shell_list(parts, shells)},
          {"contacts", contact_list(parts, shells)},
          {"touching", touching(shells)},
          {"sampled_loss", verdict.loss},
          {"sampled_loss_error", verdict.loss_error},
          {"plane_tests", verdict.plane_tests},
          {"defects", std::move(defects)},
          {"valid", verdict.valid()}};
}

std::string counted(std::size_t n, const std::string& one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

void print_shells(const std::vector<ShapePart>& parts, const ShellArgs& args, const JudgedShells& judged,
                  Session& session) {
  const Shells& shells = judged.shells;
  const ShellsVerdict& verdict = judged.verdict;
  for (std::size_t i = 0; i < shells.nested.size(); ++i)
    session.say(fmt::format("{} lies in {}: {}", parts[shells.nested[i]].name, parts[shells.hosts[i]].name,
                            args.nested == "merge" ? "merged" : "dropped"));
  for (int part : shells.lost) session.warn(fmt::format("nothing is left of {}", parts[part].name));
  session.print(
      fmt::format("parts      {}, {} nested, {} lost\n", parts.size(), shells.nested.size(), shells.lost.size()));
  session.print(fmt::format("shells     {}, {}\n", shells.shells.size(), counted(verdict.triangles, "triangle")));
  session.print(fmt::format("loss       {:.4g} % of the hulls' union; each shell keeps at least {:.3g} % of its hull\n",
                            100 * shells.loss(), 100 * shells.least_kept()));
  session.print(fmt::format("contacts   {} where shells touch\n", counted(touching(shells), "facet")));
  for (const Defect& defect : verdict.defects) session.print(fmt::format("  {}: {}\n", defect.code, defect.message));
  session.print(fmt::format("verified   {}\n", verdict.valid() ? "convex and disjoint, exactly" : "no"));
}

json remesh_report(const std::vector<ShapePart>& parts, const JudgedRemeshing& judged) {
  json list = json::array(), defects = json::array();
  const Remeshing& remeshing = judged.remeshing;
  for (std::size_t s = 0; s < remeshing.changes.size(); ++s) {
    const RemeshedShell& change = remeshing.changes[s];
    list.push_back({{"part", parts[remeshing.shells.shells[s].part].name},
                    {"triangles_before", change.triangles_before},
                    {"triangles", change.triangles},
                    {"volume_before", change.volume_before},
                    {"volume", change.volume},
                    {"fatness_before", change.fatness_before},
                    {"fatness", change.fatness}});
  }
  for (const Defect& defect : judged.verdict.defects)
    defects.push_back({{"code", defect.code}, {"message", defect.message}});
  return {{"ending", name(remeshing.ending)}, {"fatness_before", remeshing.fatness_before},
          {"fatness", remeshing.fatness},     {"shells", std::move(list)},
          {"defects", std::move(defects)},    {"valid", judged.verdict.valid()}};
}

void print_remeshing(const JudgedRemeshing& judged, Session& session) {
  RemeshedShell sum;
  double growth = 0;
  for (const RemeshedShell& change : judged.remeshing.changes) {
    sum.triangles_before += change.triangles_before;
    sum.triangles += change.triangles;
    growth = std::max(growth, change.volume / change.volume_before - 1);
  }
  session.print(fmt::format("remeshed   {} of {}, fatness {:.3f} of {:.3f}, a shell grew by at most {:.3g} %\n",
                            counted(sum.triangles, "triangle"), sum.triangles_before, judged.remeshing.fatness,
                            judged.remeshing.fatness_before, 100 * growth));
  for (const Defect& defect : judged.verdict.defects)
    session.print(fmt::format("  {}: {}\n", defect.code, defect.message));
  session.print(
      fmt::format("verified   {}\n", judged.verdict.valid() ? "convex, disjoint and around the shells" : "no"));
}

void check_output(const std::string& path) {
  if (path == "-" || mesh_format_of(path) == MeshFormat::Obj) return;
  throw InvalidOption(fmt::format("{} is no OBJ file, and other formats keep no names of parts", path), "name it .obj");
}

std::string default_shells_path(const std::string& shape) {
  if (shape == "-") return "-";
  return (mesh_format_of(shape) ? shape.substr(0, shape.rfind('.')) : shape) + ".shells.obj";
}

bool wants_remeshing(const ShellArgs& args) {
  return args.remesh.faces != 0 || args.remesh.regularize != 0 || !args.growth.empty();
}

// A growth alone asks for as few triangles as it allows.
RemeshOptions remesh_options(const ShellArgs& args) {
  RemeshOptions options = args.remesh;
  if (!args.growth.empty()) options.max_growth = share_or_number("max-growth", args.growth, 1);
  if (!args.growth.empty() && options.faces == 0 && options.regularize == 0) options.faces = 4;
  check(options);
  return options;
}

int run_shell(const ShellArgs& args, Session& session) {
  check_shell_usage(args);
  ShellOptions options = args.options;
  options.method = cut_method(args.method);
  options.nested = nested_policy(args.nested);
  options.seed = session.seed();
  check(options);
  const RemeshOptions remeshing = remesh_options(args);
  const std::vector<std::string> outputs = session.outputs(default_shells_path(args.shape));
  for (const std::string& path : outputs) check_output(path);
  const std::vector<ShapePart> parts = read_shape_parts(args.shape, args.by, args.labels, session);
  const JudgedShells judged = shell_shape(parts, options, session.run());
  session.report().update(report_of(parts, args, judged));
  if (parts.size() == 1)
    session.say("the shape has one part, so its shell is its hull; groups of an OBJ file and --labels make more");
  print_shells(parts, args, judged, session);
  if (!judged.verdict.valid()) return kNo;
  if (!wants_remeshing(args)) {
    for (const std::string& path : outputs) session.write(path, write_obj(shell_objects(parts, judged.shells)));
    return Session::exit_code(judged.shells.ending);
  }
  const JudgedRemeshing remeshed = remesh_shells(judged.shells, remeshing, session.run());
  session.report()["remeshing"] = remesh_report(parts, remeshed);
  print_remeshing(remeshed, session);
  if (!remeshed.verdict.valid()) return kNo;
  for (const std::string& path : outputs)
    session.write(path, write_obj(shell_objects(parts, remeshed.remeshing.shells)));
  const bool enough = remeshed.remeshing.ending == Ending::Exhausted && args.remesh.faces == 0;
  if (remeshed.remeshing.ending == Ending::Exhausted && !enough)
    session.warn("a shell kept more triangles than --faces asks for; a larger --max-growth allows fewer");
  return enough ? kDone : Session::exit_code(remeshed.remeshing.ending);
}

}  // namespace

Job shell_job() {
  auto args = std::make_shared<ShellArgs>();
  ShellOptions& options = args->options;
  return Job("shell", "One convex piece for every part of a shape, no two of which overlap")
      .example("plico shell robot.obj -o shells.obj", "a shell for every o or g group of the file, or connected piece")
      .example("plico shell robot.obj --protect hand --nested keep", "the hand keeps more, parts inside others stay")
      .example("plico shell robot.obj --method svm-offset --json", "the dissertation's way, its loss as JSON")
      .positional("SHAPE", "OBJ, OFF, STL or PLY file, which need be no surface; - is standard input", args->shape)
      .choice("--by",
              "what is a part: groups of an OBJ file, connected pieces, or labels; auto: groups if there are several",
              args->by, {"auto", "groups", "components", "labels"})
      .option("--labels", "FILE", "a label for every face, one a line", args->labels)
      .choice("--method", "how the planes between parts are found", args->method, {"full", "lsf", "svm", "svm-offset"})
      .choice("--nested", "what happens to a part that lies inside the hull of another", args->nested,
              {"drop", "merge", "keep"})
      .option("--nested-share", "X", "how much of a part's volume makes it nested", options.nested_share,
              {0, 1, false, true})
      .option("--least-kept", "X", "how much of each hull must be left; for full", options.least_kept,
              {0, 1, true, false})
      .option("--protect", "PART", "volume that this part loses counts four times; may be repeated; for full",
              options.protect)
      .option("--max-sweeps", "N", "how often all planes are moved again; for full", options.max_sweeps, at_least(0))
      .option("--svm-samples", "N", "points in each two parts; for svm", options.svm.samples, at_least(10))
      .option("--svm-penalty", "X", "of a point on the wrong side, with a union of volume 100; for svm",
              options.svm.penalty, above(0))
      .option("--faces", "N", "merge triangles until a shell has no more; 0: do not", args->remesh.faces, at_least(0))
      .option("--regularize", "K", "rounds in which vertices move, so that triangles become fatter",
              args->remesh.regularize, at_least(0))
      .option("--max-growth", "SHARE",
              "of a shell's volume by these two: 5% or 0.05; alone: as few triangles as it allows", args->growth)
      .action([args](Session& session) { return run_shell(*args, session); });
}

}  // namespace plico::jobs
