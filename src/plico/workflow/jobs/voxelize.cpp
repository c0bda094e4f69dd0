// plico voxelize: the outside of a mesh as equal squares, with a walk that visits each once.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/voxel_options.h"
#include "plico/workflow/shell_file.h"
#include "plico/workflow/voxel_mesh.h"

namespace plico::jobs {
namespace {

nlohmann::json voxel_report(const VoxelMesh& voxels, const JudgedCycle& cycle) {
  const VoxelGrid& grid = voxels.solid.grid;
  return {{"grid", {grid.nx(), grid.ny(), grid.nz()}},
          {"voxel_side", voxels.solid.side},
          {"voxels_touched", voxels.solid.touched},
          {"voxels_solid", grid.count()},
          {"squares", voxels.shell.size()},
          {"edges_with_four_squares", voxels.shell.edges_with_four},
          {"other_pieces", voxels.other_pieces},
          {"rings", cycle.found.rings},
          {"cycles_left", cycle.found.left},
          {"cycle_proven_none", cycle.proven_none},
          {"path_verified", !cycle.path.empty() && cycle.verdict.valid()},
          {"cycle_verified", cycle.found.ending == Ending::Found && cycle.verdict.valid()},
          {"ending", name(cycle.found.ending)},
          {"notes", voxels.notes}};
}

void say_voxels(const Session& session, const VoxelMesh& voxels, const JudgedCycle& cycle) {
  const VoxelGrid& grid = voxels.solid.grid;
  session.print(fmt::format("voxels     {} solid of {} x {} x {}, sides {:.4g}\n", grid.count(), grid.nx(), grid.ny(),
                            grid.nz(), voxels.solid.side));
  session.print(
      fmt::format("squares    {}, {} edges with four of them\n", voxels.shell.size(), voxels.shell.edges_with_four));
  if (cycle.found.ending == Ending::Found)
    session.print(
        fmt::format("cycle      through every square once, {}\n", cycle.verdict.valid() ? "verified" : "NOT verified"));
  else
    session.print(fmt::format("cycle      {}\n", no_cycle_text(voxels, cycle)));
  for (const std::string& note : voxels.notes) session.warn(note);
  for (const std::string& problem : cycle.verdict.problems) session.warn(problem);
}

bool is_fold(const std::string& path) { return path.ends_with(".fold"); }

void check_voxel_output(const std::string& path) {
  const std::optional<MeshFormat> format = mesh_format_of(path);
  if (path != "-" && !is_fold(path) && (!format || *format == MeshFormat::Gltf))
    throw InvalidOption(fmt::format("{} does not end in .fold, .obj, .off, .stl or .ply", path));
}

int voxelize_file(const VoxelArgs& args, Session& session) {
  const std::vector<std::string> outputs = session.outputs("");
  for (const std::string& path : outputs) check_voxel_output(path);
  const VoxelMesh voxels = largest_piece(read_voxels(args, session));
  const JudgedCycle cycle = judged_cycle(voxels, {.seed = session.seed()}, session.run());
  session.report().update(voxel_report(voxels, cycle));
  say_voxels(session, voxels, cycle);
  if (!cycle.verdict.valid()) return kInternal;
  const PolygonSoup surface = surface_of(voxels.shell, voxels.solid.origin, voxels.solid.side);
  for (const std::string& path : outputs)
    session.write(path, is_fold(path) ? write_shell_file(voxels, session.provenance().dump())
                                      : write_mesh(surface, output_format(path)));
  return cycle.walk().empty() ? Session::exit_code(cycle.found.ending) : kDone;
}

}  // namespace

Job voxelize_job() {
  auto args = std::make_shared<VoxelArgs>();
  Job job("voxelize", "The outside of a mesh as equal squares, and a walk that visits each of them once");
  job.example("plico voxelize bird.obj --cells 25 -o squares.obj", "25 voxels along the longest side")
      .example("plico voxelize bird.obj --squares 2200 -o shell.fold && plico stack shell.fold -o bird.fold",
               "as fine as 2200 squares ask for, once for several stacks")
      .example("plico voxelize bird.obj --size 0.1 --pair empty --json",
               "voxels of that size; all figures for programs")
      .action([args](Session& session) { return voxelize_file(*args, session); });
  add_voxel_options(job, *args);
  return job;
}

}  // namespace plico::jobs
