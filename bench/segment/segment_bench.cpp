// Few parts that mean something, each with a proven net and motion, against the dissertation's clusters.
//   bench_segment [--meshes DIR] [--json FILE] [--quick]
//   bench_segment --acceptance --meshes DIR [--quick] [--seed N]    goals, seeds 1-3 (--quick: 1; or N alone), reached
//                                                                   or not
// Table 1: what `plico segment` makes of every mesh. [Xi17] Table 4.1: horse-312 in 7 parts, 3 of them linear, 12.75 s.
// Table 2: as few parts as are proven to fold.
// Table 3: growth with the face count, cuts alone, with peak memory.
// Table 4: limbs of animals: the area-weighted Rand index against the nearest limb, given their number and not.
// Table 5: necks against clusters ([Xi17] 4.2) in 10 parts each.
// Seams are told in diagonals of the bounding box. Times are processor seconds of one thread.
#include <sys/resource.h>

#include <cstring>
#include <map>

#include "acceptance.h"
#include "cuts.h"
#include "limbs.h"
#include "plico/segment/coarse.h"

namespace plico::bench {
namespace {

void add_parts_row(Table& table, const Named& named, const char* wish, const Cut& made) {
  const Seam seam = seam_of(named.mesh, made.result.parts);
  std::size_t smallest = named.mesh.num_faces();
  for (const auto& faces : faces_of_parts(made.result.parts)) smallest = std::min(smallest, faces.size());
  table.row({named.name, named.mesh.num_faces(), wish, made.result.parts.num_parts(), made.result.num_proven(),
             made.result.verdict.valid() ? "yes" : "NO", seam.diagonals, seam.concave, smallest, made.seconds});
}

void parts_of_all(Table& table, const std::vector<Named>& meshes, bool quick) {
  const std::map<std::string, int> asked{{"horse-312", 7}, {"fish-950", 4}, {"snail-574", 5}, {"dragon-344", 8}};
  int parts = 0, proven = 0;
  for (const Named& named : meshes) {
    if (quick && named.mesh.num_faces() > 600) continue;
    const Cut made = cut(named.mesh, {});
    add_parts_row(table, named, "auto", made);
    parts += made.result.parts.num_parts();
    proven += made.result.num_proven();
    if (const auto at = asked.find(named.name); at != asked.end())
      add_parts_row(table, named, std::to_string(at->second).c_str(), cut(named.mesh, exactly(at->second)));
  }
  fmt::print("auto: {} of {} parts proven\n\n", proven, parts);
}

void fewest_of_some(Table& table, const std::vector<Named>& meshes, bool quick) {
  for (const Named& named : meshes) {
    const bool told = named.name.starts_with("star") || named.name == "mannequin-1376" || named.name == "seagull-462" ||
                      named.name == "ArcherElf-500" || named.name == "horse-312" || named.name == "part-without-net";
    if (told && !(quick && named.mesh.num_faces() > 600))
      add_parts_row(table, named, "fewest", cut(named.mesh, fewest()));
  }
}

void against_clusters(Table& table, const std::vector<Named>& meshes, bool quick) {
  for (const Named& named : meshes) {
    if (named.mesh.num_faces() < 200 || named.mesh.num_faces() > (quick ? 350 : 2000)) continue;
    const Cut necks = cut(named.mesh, exactly(10));
    const Cut clusters = cut(named.mesh, exactly(10, SegmentMethod::Clusters));
    const Seam ours = seam_of(named.mesh, necks.result.parts), theirs = seam_of(named.mesh, clusters.result.parts);
    table.row({named.name, named.mesh.num_faces(), ours.diagonals, theirs.diagonals, ours.diagonals / theirs.diagonals,
               ours.concave, theirs.concave,
               fmt::format("{}/{}", necks.result.num_proven(), necks.result.parts.num_parts()),
               fmt::format("{}/{}", clusters.result.num_proven(), clusters.result.parts.num_parts()), necks.seconds,
               clusters.seconds});
  }
}

// ---- Limbs --------------------------------------------------------------------------------------------------------

void limbs_of_animals(Table& table, bool quick) {
  double sums[3] = {0, 0, 0}, worst = 1;
  int count = 0;
  for (Animal animal : kAnimals)
    for (int seed = 11; seed <= (quick ? 11 : 15); ++seed) {
      const CreatureOptions shape{.animal = animal, .faces = 500, .variety = 0.6, .seed = std::uint64_t(seed)};
      const Mesh mesh{creature(shape)};
      const std::vector<int> truth = true_parts(mesh, shape);
      const int k = 1 + *std::max_element(truth.begin(), truth.end());
      SegmentOptions given = exactly(k), free, clusters = exactly(k, SegmentMethod::Clusters);
      for (SegmentOptions* options : {&given, &free, &clusters}) options->prove.motion = PartMotion::None;
      const Cut all[3] = {cut(mesh, given), cut(mesh, free), cut(mesh, clusters)};
      double index[3];
      for (int i = 0; i < 3; ++i) sums[i] += index[i] = rand_index(mesh, truth, all[i].result.parts.part);
      worst = std::min(worst, index[1]);
      ++count;
      table.row(
          {fmt::format("{} {}", name(animal), seed), k, index[0], all[1].result.parts.num_parts(), index[1], index[2]});
    }
  fmt::print("mean: {:.3f} with their number, {:.3f} without (worst {:.3f}), clusters {:.3f}\n\n", sums[0] / count,
             sums[1] / count, worst, sums[2] / count);
}

// ---- Growth -------------------------------------------------------------------------------------------------------

void growth(Table& table, bool quick) {
  for (int faces : {1000, 2000, 5000, 10'000, 20'000}) {
    if (quick && faces > 5000) continue;
    for (Animal animal : {Animal::Dog, Animal::Dinosaur}) {
      const Mesh mesh{creature({.animal = animal, .faces = faces})};
      std::vector<int> part;
      const double seconds = processor_seconds([&] { part = cut_limbs_of(mesh, DualGraph(mesh)); });
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      table.row({std::string(name(animal)), faces, 1 + *std::max_element(part.begin(), part.end()), seconds,
                 static_cast<double>(usage.ru_maxrss) / 1024});
    }
  }
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  using namespace plico::bench;
  if (argc > 1 && std::strcmp(argv[1], "--acceptance") == 0) {
    std::vector<char*> words(argv + 1, argv + argc);
    words[0] = argv[0];
    const std::string only = taken(words, "--seed");
    const Arguments args = arguments(static_cast<int>(words.size()), words.data());
    const int first = only.empty() ? 1 : std::stoi(only), last = only.empty() && !args.quick ? 3 : first;
    return acceptance(args, first, last) ? 0 : 1;
  }
  const Arguments args = arguments(argc, argv);
  const std::vector<Named> meshes = all_meshes(args);
  const std::vector<std::string> columns{"mesh",     "faces",          "wish",    "parts",    "proven",
                                         "verified", "seam diagonals", "concave", "smallest", "processor sec"};
  Table parts("Parts, each with a net and a linear motion", columns);
  parts_of_all(parts, meshes, args.quick);
  Table few("As few parts as fold", columns);
  fewest_of_some(few, meshes, args.quick);
  Table growing("Growth", {"animal", "faces", "parts", "cut s", "peak MiB"});
  growth(growing, args.quick);
  Table limbs("Limbs: Rand index", {"animal", "limbs", "given k", "auto parts", "auto", "clusters"});
  limbs_of_animals(limbs, args.quick);
  Table against("Necks against clusters, 10 parts",
                {"mesh", "faces", "necks", "clusters", "ratio", "concave", "clusters'", "proven", "clusters' proven",
                 "necks s", "clusters s"});
  against_clusters(against, meshes, args.quick);
  write_json(args, {&parts, &few, &growing, &limbs, &against});
}
