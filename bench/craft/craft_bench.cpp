// craft beside unfold --foldable linear: the same net and motion from both, and what the rest of craft costs.
//   bench_craft --meshes DIR [--json FILE] [--quick]
#include <thread>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/mesh/measures.h"
#include "plico/motion/planner.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/craft.h"
#include "table.h"

namespace plico::bench {
namespace {

constexpr int kMostFaces = 2000;

std::string kind(const std::optional<Motion>& motion) {
  if (!motion) return "none";
  return fmt::format("{}, {}", name(motion->method), name(motion->proof.verdict));
}

void row(Table& table, const std::string& name, const Mesh& mesh, const Run& run) {
  NetAndMotion unfolded;
  CraftResult crafted;
  CraftOptions as_unfolded;
  as_unfolded.wish = HandWish::None;
  const double unfolding = seconds([&] { unfolded = fold_or_plan(mesh, {}, run); });
  const double crafting = seconds([&] { crafted = craft(mesh, as_unfolded, run); });
  const bool same_motion = kind(unfolded.motion) == kind(crafted.motion);
  const bool same_net = lay_flat(mesh, unfolded.net.tree).mate == crafted.net.mate;
  table.row({name, mesh.num_faces(), kind(unfolded.motion), unfolding, kind(crafted.motion), crafting,
             same_motion && same_net ? "yes" : "NO", unfolded.net.crossing.size()});
}

// Animals of the project's own, and what the folder holds of meshes in one piece.
std::vector<std::pair<std::string, Mesh>> crafted_meshes(const Arguments& args) {
  std::vector<std::pair<std::string, Mesh>> meshes;
  for (int faces : {300, 800, 2000}) {
    if (args.quick && faces > 300) break;
    for (const char* animal : {"bird", "dog", "fish", "dinosaur"})
      meshes.emplace_back(fmt::format("{} {}", animal, faces), Mesh(make_shape(animal, {.faces = faces})));
  }
  for (const auto& file : mesh_files(args.meshes)) {
    const std::string name = file.stem();
    try {
      Mesh mesh = to_mesh(read_mesh_source(read_file(file), file));
      if (mesh.num_faces() > 1 && mesh.num_faces() <= kMostFaces && components(mesh).count == 1)
        meshes.emplace_back(name, std::move(mesh));
    } catch (const Error& error) {
      fmt::print("left out: {}: {}\n", name, error.what());
    }
  }
  return meshes;
}

int bench(const Arguments& args) {
  silence_planners();
  const Run run{.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))};
  Table table("craft beside unfold --foldable linear, seed 1, no time limit",
              {"mesh", "faces", "unfold", "s", "craft", "craft s", "same", "crossing faces"});
  for (const auto& [name, mesh] : crafted_meshes(args)) row(table, name, mesh, run);
  write_json(args, {&table});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) { return plico::bench::bench(plico::bench::arguments(argc, argv)); }
