// From a model to convex pieces with nets and proven motions, beside the dissertation.
//   bench_pipeline [--meshes DIR] [--json FILE] [--quick]     (DIR: meshes, and OBJ files of overlapping parts)
// Table 1: nearly convex parts ([Xi17] tables 4.1, 4.2; CoRiSe's parts as matched to these meshes). Seams in diagonals.
// Table 2: each shell of the horse: net and motion ([Xi17] table 4.1: 7 patches, 12.75 s, 3 of 7 motions straight).
// Table 3: whole models ([Xi17] table 5.3: Bulbasaur, 1138 triangles in 12 parts by hand, 112.4 s and 72.5 s).
// Processor seconds of one thread; the dissertation's are those of a laptop of 2012 to 2015.

#include "plico/base/error.h"
#include "plico/convex/shape_parts.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/mesh/measures.h"
#include "plico/verify/concavity.h"
#include "plico/workflow/craft.h"
#include "plico/workflow/shell_pieces.h"
#include "table.h"

namespace plico::bench {
namespace {

using nlohmann::json;

struct TheirParts {
  const char* mesh;
  double bound;
  json parts, seam, seconds;
};

void add_parts_row(Table& table, const std::string& folder, const TheirParts& theirs) {
  const std::string path = folder + "/" + theirs.mesh;
  if (folder.empty() || !std::filesystem::exists(path)) return;
  const Mesh mesh = load_mesh(path);
  std::vector<int> labels;
  const double time = processor_seconds([&] { labels = cut_by_convexity(mesh, {theirs.bound}); });
  const Segmentation parts = segmentation_by_labels(mesh, labels);
  double seam = 0;
  for (EdgeId e : seams(mesh, parts)) seam += length(mesh, e);
  table.row({theirs.mesh, theirs.bound, concavity_bound(mesh, parts) / diagonal(mesh), parts.num_parts(), theirs.parts,
             seam / diagonal(mesh), theirs.seam, time, theirs.seconds});
}

void nearly_convex(Table& table, const std::string& folder) {
  const TheirParts theirs[] = {{"bunny-128.off", 0.10, 3, 0.43, 0.02},
                               {"horse-312.off", 0.041, 7, 2.19, nullptr},
                               {"snail-574.off", 0.035, 5, 2.42, nullptr},
                               {"squirtle-1718.off", 0.05, 8, 2.84, nullptr},
                               {"fish-950.off", 0.05, 5, nullptr, nullptr}};
  for (const TheirParts& row : theirs) add_parts_row(table, folder, row);
}

void patches_of_horse(Table& table, const std::string& folder) {
  const std::string path = folder + "/horse-312.off";
  if (folder.empty() || !std::filesystem::exists(path)) return;
  const ShellPieces shells = shell_pieces(nearly_convex_parts(load_mesh(path), {0.041}));
  const auto faces = faces_of_parts(shells.pieces);
  for (int p = 0; p < shells.pieces.num_parts(); ++p) {
    ProvenPart part;
    const double time = processor_seconds([&] { part = prove_part(shells.mesh, faces[p]); });
    table.row({shells.pieces.names[p], faces[p].size(), part.verdict.is_net() ? "yes" : "NO",
               part.proven() ? "yes" : "NO", time});
  }
}

// The parts that `plico craft --shells` takes: groups and components are one in these files.
std::vector<ShapePart> parts_of(const std::filesystem::path& path) {
  const MeshSource source = read_mesh_source(read_file(path.string()), path.string());
  std::vector<ShapePart> parts = parts_by_components(source.soup);
  return parts.size() > 1 ? parts : nearly_convex_parts(load_mesh(path));
}

void add_model_row(Table& table, const std::filesystem::path& path) {
  ShellPieces shells;
  CraftResult made;
  const double time = processor_seconds([&] {
    shells = shell_pieces(parts_of(path));
    CraftOptions options;
    options.pieces = shells.pieces;
    options.joints = shells.joints;
    made = craft(shells.mesh, options);
  });
  table.row({path.stem().string(), shells.mesh.num_faces(), shells.pieces.num_parts(), shells.joints.size(),
             100 * shells.judged.shells.loss(), made.kit->num_proven(), made.proven() ? "yes" : "NO",
             made.sound() && shells.judged.verdict.valid() ? "yes" : "NO", made.layout.report.pages, time});
}

void whole_models(Table& table, const Arguments& args) {
  for (const auto& path : mesh_files(args.meshes)) {
    if (args.quick && std::filesystem::file_size(path) > 40'000) continue;
    try {
      add_model_row(table, path);
    } catch (const Error& error) {
      fmt::print("{}: {}\n", path.stem().string(), error.what());
    }
  }
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  using namespace plico::bench;
  const Arguments args = arguments(argc, argv);
  Table parts("Nearly convex parts",
              {"mesh", "bound", "depth", "parts", "[Xi17]", "seam", "[Xi17] seam", "sec", "[Xi17] sec"});
  nearly_convex(parts, args.meshes);
  Table patches("Shells of the horse", {"piece", "panels", "net", "linear", "sec"});
  patches_of_horse(patches, args.meshes);
  Table models("Whole models",
               {"model", "panels", "pieces", "joints", "loss %", "proven", "motion", "sound", "pages", "sec"});
  whole_models(models, args);
  write_json(args, {&parts, &patches, &models});
}
