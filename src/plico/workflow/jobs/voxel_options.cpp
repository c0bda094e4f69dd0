#include "plico/workflow/jobs/voxel_options.h"

#include "plico/io/mesh/mesh_file.h"

namespace plico::jobs {

Job& add_voxel_options(Job& job, VoxelArgs& args) {
  return job.positional("mesh", "OBJ, OFF, STL or PLY file, closed or not; - for standard input", args.mesh)
      .option("--cells", "N", "voxels along the longest side, not necessarily whole", args.resolution.cells, {1, 1e6})
      .option("--size", "X", "side of a voxel, in the mesh's unit", args.resolution.size, above(0))
      .option("--squares", "N", "search for the resolution with this many squares", args.resolution.squares,
              at_least(6))
      .option("--refine", "N", "then cut every voxel into N x N x N; with an even N a walk is certain",
              args.resolution.refine, at_least(1))
      .choice("--pair", "which squares are joined where four meet: those of one solid or of one empty voxel", args.pair,
              {"solid", "empty"});
}

VoxelMesh read_voxels(const VoxelArgs& args, Session& session) {
  const PolygonSoup soup = read_mesh_source(session.read(args.mesh), args.mesh).soup;
  return voxel_mesh(soup, args.resolution, args.pair == "solid" ? Pairing::Solid : Pairing::Empty);
}

}  // namespace plico::jobs
