#include "plico/workflow/jobs/voxel_options.h"

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/workflow/shell_file.h"

namespace plico::jobs {

Job& add_voxel_options(Job& job, VoxelArgs& args) {
  return job
      .positional(
          "mesh",
          "OBJ, OFF, STL or PLY file, closed or not, or squares that voxelize wrote (FOLD); - for standard input",
          args.mesh)
      .option("--cells", "N", "voxels along the longest side, not necessarily whole", args.resolution.cells, {1, 1e6})
      .option("--size", "X", "side of a voxel, in the mesh's unit", args.resolution.size, above(0))
      .option("--squares", "N", "search for the resolution with this many squares", args.resolution.squares,
              at_least(6))
      .option("--refine", "N", "then cut every voxel into N x N x N; with an even N a walk is certain",
              args.resolution.refine, at_least(1))
      .choice("--pair", "which squares are joined where four meet: those of one solid or of one empty voxel", args.pair,
              {"solid", "empty"});
}

VoxelPieces read_voxels(const VoxelArgs& args, Session& session) {
  const std::string bytes = session.read(args.mesh);
  const Pairing pairing = args.pair == "solid" ? Pairing::Solid : Pairing::Empty;
  if (!is_shell_file(bytes, args.mesh))
    return voxel_pieces(read_mesh_source(bytes, args.mesh).soup, args.resolution, pairing);
  if (args.resolution.cells != 0 || args.resolution.size != 0 || args.resolution.squares != 0)
    throw InvalidOption("a FOLD file of squares is as fine as it is, and cells, size and squares are for meshes");
  return read_shell_file(bytes, args.mesh, args.resolution.refine, pairing);
}

}  // namespace plico::jobs
