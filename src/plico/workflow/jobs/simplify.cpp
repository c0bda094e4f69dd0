// plico simplify: fewer faces, and how far the shape strays.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/measures.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/simplify_mesh.h"

namespace plico::jobs {
namespace {

struct SimplifyArgs {
  std::string mesh, repair = "safe", symmetric = "auto";
  SimplifyOptions options = kept_sharp(300);
};

Halves halves_of(const std::string& wish) {
  return wish == "on" ? Halves::Alike : wish == "off" ? Halves::Free : Halves::Auto;
}

int simplify_file(const SimplifyArgs& args, Session& session) {
  check(args.options);
  const std::vector<std::string> outputs = session.outputs("simple.obj");
  for (const std::string& path : outputs) output_format(path);
  const Mesh mesh = read_mesh(args.mesh, args.repair, session);
  const SimplifiedMesh simple = simplify_mesh(mesh, args.options, halves_of(args.symmetric));
  for (const std::string& path : outputs) session.write(path, write_mesh(simple.mesh.soup(), output_format(path)));
  const double size = diagonal(mesh), share = size > 0 ? simple.distance / size : 0;
  session.report()["faces_before"] = simple.faces_before;
  session.report()["faces"] = simple.mesh.num_faces();
  session.report()["distance"] = simple.distance;
  session.report()["distance_in_diagonals"] = share;
  session.report()["symmetric"] = simple.symmetric;
  session.report()["crossings"] = simple.crossings;
  session.print(
      fmt::format("faces      {} of {}{}\ndistance   at most {:.3g} at the vertices, {:.2f} % of the diagonal\n",
                  simple.mesh.num_faces(), simple.faces_before, simple.symmetric ? ", left and right equal" : "",
                  simple.distance, 100 * share));
  for (const std::string& note : simple.notes) session.warn(note);
  return simple.mesh.num_faces() <= args.options.faces && simple.crossings == 0 ? kDone : kNo;
}

}  // namespace

Job simplify_job() {
  auto args = std::make_shared<SimplifyArgs>();
  Job job("simplify", "Make a mesh with fewer faces, as paper and scissors want it");
  job.example("plico simplify scan.stl --faces 300 -o small.obj", "300 triangles, and how far they stray")
      .example("plico simplify scan.stl --faces 300 --evenness 0.03 -o small.obj", "triangles of more even size")
      .example("plico craft scan.stl --faces 300 -o paper", "the same as a part of the main job")
      .positional("mesh", "OBJ, OFF, STL or PLY file, closed or open; - for standard input", args->mesh)
      .option("--faces", "N", "triangles wanted; a closed mesh has an even number", args->options.faces, at_least(4))
      .option("--evenness", "X", "pull towards triangles of even size against the pull towards the shape",
              args->options.evenness, at_least(0))
      .choice("--symmetric",
              "left and right equal, triangle by triangle: where the shape is, or not, or told if it is not",
              args->symmetric, {"auto", "off", "on"})
      .action([args](Session& session) { return simplify_file(*args, session); });
  add_repair_option(job, args->repair);
  return job;
}

}  // namespace plico::jobs
