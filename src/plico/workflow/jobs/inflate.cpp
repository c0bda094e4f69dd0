// plico inflate: dents of a mesh popped up, so that it unfolds and folds more easily.
#include "plico/inflate/inflate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/verify/inflation.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/share.h"

namespace plico::jobs {
namespace {

struct InflateArgs {
  std::string mesh, repair = "safe", method = "minimize", until = "0", growth = "5%", flattening = "auto";
  std::vector<std::string> keep, keep_vertices;
  bool uniform = false;
  InflateOptions options;
};

template <class Id>
std::vector<Id> numbered(const char* option, const char* what, const std::vector<std::string>& words) {
  std::vector<Id> ids;
  for (const std::string& word : words) {
    const double number = share_or_number(option, word, 1);
    if (word.ends_with('%') || number != std::floor(number))
      throw InvalidOption(fmt::format("{} = {} must be the number of a {}, from 0", option, word, what));
    ids.emplace_back(static_cast<int>(number));
  }
  return ids;
}

MeshFormat format_of_output(const std::string& path) {
  if (path == "-") return MeshFormat::Obj;
  if (const auto format = mesh_format_of(path); format && *format != MeshFormat::Stl) return *format;
  throw InvalidOption(fmt::format("{} does not end in .obj, .off or .ply", path));
}

nlohmann::json report_of(const Inflation& result, const InflationVerdict& verdict) {
  return {{"ending", name(result.ending)},
          {"stopped_by", name(result.limit)},
          {"hyperbolic_before", verdict.hyperbolic_before},
          {"hyperbolic", verdict.hyperbolic},
          {"volume_before", result.volume_before},
          {"volume", result.volume},
          {"growth", verdict.growth},
          {"excess_before_deg", degrees(result.excess_before)},
          {"excess_deg", degrees(result.excess)},
          {"flattening", result.flattening},
          {"pressure", result.pressure},
          {"steps", result.steps},
          {"held_vertices", result.held.size()},
          {"mean_move", result.mean_move()},
          {"largest_move", result.largest_move()},
          {"move", result.move},
          {"defects", verdict.defects}};
}

// More than half of the hyperbolic vertices are left.
std::string what_is_in_the_way(const Inflation& result) {
  return fmt::format(
      "those left exceed 360 degrees by {:.0f} on average; {}", degrees(result.excess) / std::max(1, result.hyperbolic),
      result.held.empty() ? "a larger --max-growth may fill deeper dents"
                          : fmt::format("{} vertices stayed, as faces there would meet", result.held.size()));
}

int inflate_file(InflateArgs& args, Session& session) {
  InflateOptions& options = args.options;
  const std::vector<std::string> outputs = session.outputs("inflated.obj");
  for (const std::string& path : outputs) format_of_output(path);
  options.max_growth = share_or_number("max-growth", args.growth, 1);
  options.method = args.method == "explicit" ? InflateMethod::Explicit : InflateMethod::Minimize;
  options.skin.constrained = !args.uniform;
  options.keep = numbered<FaceId>("keep", "face", args.keep);
  options.keep_vertices = numbered<VertexId>("keep-vertex", "vertex", args.keep_vertices);
  if (args.flattening != "auto") {
    options.skin.flattening = share_or_number("flattening", args.flattening, 1);
    options.stronger.clear();
  }
  const Mesh mesh = read_mesh(args.mesh, args.repair, session);
  options.until_hyperbolic = static_cast<int>(share_or_number("until-hyperbolic", args.until, mesh.num_vertices()));
  const Inflation result = inflate(mesh, options, session.run());
  PolygonSoup soup = mesh.soup();
  soup.points = result.points;
  const InflationVerdict verdict =
      verify_inflation(mesh, soup, options.keep, options.max_growth, options.keep_vertices);
  session.report().update(report_of(result, verdict));
  for (const std::string& defect : verdict.defects) session.warn(defect);
  if (!verdict.valid()) return kInternal;
  session.say(
      fmt::format("{} of {} vertices hyperbolic, {} before; volume {:+.2f} %; moved {:.3g} on average, {:.3g} "
                  "at most; stopped by {}",
                  verdict.hyperbolic, mesh.num_vertices(), verdict.hyperbolic_before, 100 * verdict.growth,
                  result.mean_move(), result.largest_move(), name(result.limit)));
  if (2 * verdict.hyperbolic > verdict.hyperbolic_before) session.say(what_is_in_the_way(result));
  for (const std::string& path : outputs) session.write(path, write_mesh(soup, format_of_output(path)));
  const bool cut_short = result.ending == Ending::TimedOut || result.ending == Ending::Stopped;
  return cut_short ? Session::exit_code(result.ending) : kDone;
}

}  // namespace

Job inflate_job() {
  auto args = std::make_shared<InflateArgs>();
  Job job("inflate", "Pop up the dents of a closed mesh, so that fewer of its vertices are hyperbolic");
  job.example("plico inflate bird.obj -o round.obj", "as few hyperbolic vertices as 5 % more volume allow")
      .example("plico inflate bird.obj --until-hyperbolic 10% -o round.obj",
               "stop when a tenth of the vertices is left")
      .example("plico inflate bird.obj --uniform --max-growth 20% -o balloon.obj", "nothing is kept stiff")
      .positional("mesh", "OBJ, OFF, STL or PLY file; - for standard input", args->mesh)
      .option("--until-hyperbolic", "N", "stop when no more vertices are hyperbolic: a number, or a share as 10%",
              args->until)
      .option("--max-growth", "SHARE", "of the volume: 5% or 0.05", args->growth)
      .option("--pressure", "P", "stop at this pressure; 0: where the other limits stop it", args->options.pressure,
              at_least(0))
      .option("--keep", "FACE", "number of a face that must not move, from 0; repeatable", args->keep)
      .option("--keep-vertex", "VERTEX", "number of a vertex that must not move, from 0; repeatable",
              args->keep_vertices)
      .flag("--uniform", "no edge is stiff and no vertex is drawn back to its place", args->uniform)
      .option("--flattening", "W",
              "how strongly angles above 360 degrees are pressed out; 0: only by air; auto: the best of 1, 8 and 64",
              args->flattening)
      .choice("--method", "minimize the energy, or add up forces step by step as the dissertation does", args->method,
              {"minimize", "explicit"})
      .option("--stiffness", "E", "of the edges: how hard they pull back", args->options.skin.edge_stiffness, above(0))
      .option("--stiff-edges", "K", "how much stiffer convex and deep concave edges are, so that features stay",
              args->options.skin.stiff_edges, at_least(1))
      .angle("--deep-angle", "a valley that folds by more is deep, and kept", args->options.skin.deep_angle, {0, 180})
      .option("--anchors", "E", "how hard vertices are drawn back to where they were",
              args->options.skin.anchor_stiffness, at_least(0))
      .option("--time-step", "T", "of the explicit method", args->options.time_step, above(0))
      .option("--max-steps", "N", "of the explicit method", args->options.max_steps, at_least(1))
      .action([args](Session& session) { return inflate_file(*args, session); });
  add_repair_option(job, args->repair);
  return job;
}

}  // namespace plico::jobs
