#include "acceptance.h"

#include <sys/resource.h>

#include <map>
#include <optional>

#include "cuts.h"
#include "limbs.h"
#include "plico/segment/coarse.h"
#include "plico/segment/mirror.h"
#include "plico/workflow/foldable_net.h"
#include "plico/workflow/jobs/jobs.h"

namespace plico::bench {
namespace {

// A goal is an upper or a lower bound.
struct Goal {
  bool at_most = true;
  double bound = 0;

  bool reached(double value) const { return at_most ? value <= bound : value >= bound; }
};

Goal at_most(double bound) { return {true, bound}; }
Goal at_least(double bound) { return {false, bound}; }

class Acceptance {
 public:
  explicit Acceptance(const Arguments& args)
      : args_(args), meshes_(all_meshes(args)), table_("Goals", {"figure", "seed", "goal", "value", "reached"}) {}

  bool run(int first, int last) {
    if (first == 1) {
      growth();
      limbs();
      impossible_is_said();
      mirrored();
    }
    for (seed_ = first; seed_ <= last; ++seed_) {
      named_parts();
      fewest_parts();
      fewest_in_one_piece();
      pages();
      against_clusters();
      all_proven();
    }
    write_json(args_, {&table_});
    fmt::print("{} of {} goals reached\n", reached_, rows_);
    return reached_ == rows_;
  }

 private:
  void row(const std::string& figure, const Goal& goal, double value) {
    const bool yes = goal.reached(value);
    table_.row(
        {figure, seed_, fmt::format("{} {:.4g}", goal.at_most ? "<=" : ">=", goal.bound), value, yes ? "yes" : "NO"});
    ++rows_;
    reached_ += yes;
  }

  const Mesh& mesh(const std::string& name) const {
    for (const Named& named : meshes_)
      if (named.name == name) return named.mesh;
    throw InvalidOption(fmt::format("--meshes has no {}", name));
  }

  Cut seeded(const Mesh& mesh, SegmentOptions options) const {
    options.prove.seed = seed_;
    return cut(mesh, options);
  }

  static double unproven(const Cut& made) { return made.result.parts.num_parts() - made.result.num_proven(); }

  struct PartsGoal {
    std::string mesh;
    int asked;  // 0: auto
    double parts, seam, seconds;
  };

  void named_parts() {
    constexpr double kAny = 1e9;
    const std::vector<PartsGoal> goals{{"horse-312", 7, 7, 2.0, 0.3},         {"squirtle-1718", 0, 7, 2.0, 0.8},
                                       {"fish-950", 4, 4, 0.75, 0.6},         {"snail-574", 5, 5, 2.0, kAny},
                                       {"star-9split", 0, 6, kAny, kAny},     {"dragon-344", 0, 8, kAny, 0.4},
                                       {"triceratops-1000", 0, 12, kAny, 1.5}};
    for (const PartsGoal& goal : goals) {
      const Cut made = seeded(mesh(goal.mesh), goal.asked ? exactly(goal.asked) : SegmentOptions{});
      row(goal.mesh + ": parts", at_most(goal.parts), made.result.parts.num_parts());
      row(goal.mesh + ": not proven", at_most(0), unproven(made));
      if (goal.seam < kAny)
        row(goal.mesh + ": seam", at_most(goal.seam), seam_of(mesh(goal.mesh), made.result.parts).diagonals);
      if (goal.seconds < kAny) row(goal.mesh + ": seconds", at_most(goal.seconds), made.seconds);
    }
  }

  void fewest_parts() {
    const std::map<std::string, double> most{{"star-024", 2},       {"star-4split", 2},   {"star-9split", 2},
                                             {"star-Butterfly", 2}, {"ArcherElf-500", 2}, {"mannequin-1376", 3},
                                             {"seagull-462", 3}};
    for (const auto& [name, parts] : most) {
      const Cut made = seeded(mesh(name), fewest());
      row(name + " fewest: parts", at_most(parts), made.result.parts.num_parts() + unproven(made));
      row(name + " fewest: seconds", at_most(3), made.seconds);
    }
  }

  // Both commands as they are called, in turn; the faster of two runs each.
  void fewest_in_one_piece() {
    for (const char* name : {"horse-312.off", "dragon-344.off", "snail-574.off", "gear-508.off", "fish-950.off"}) {
      const std::string file = args_.meshes + "/" + name, seed = std::to_string(seed_);
      jobs::DiskFiles disk;
      jobs::MemoryFiles files;
      files.files["mesh.off"] = disk.read(file);
      double whole = kSecondsAtMost, parts = kSecondsAtMost;
      for (int i = 0; i < 2; ++i) {
        files.files.erase("u.fold");
        files.files.erase("s.fold");
        whole =
            std::min(whole, processor_seconds([&] {
                       jobs::run_job(
                           "unfold",
                           {{"mesh", "mesh.off"}, {"foldable", "linear"}, {"seed", seed}, {"output", "u.fold"}}, files);
                     }));
        parts = std::min(
            parts, processor_seconds([&] {
              jobs::run_job("segment",
                            {{"mesh", "mesh.off"}, {"parts", "fewest"}, {"seed", seed}, {"output", "s.fold"}}, files);
            }));
      }
      row(fmt::format("{} fewest / unfold", name), at_most(1.2), parts / whole);
    }
  }

  // 200 mm on A4, less margins of 10 mm and tabs of 5 mm; a net that does not fit is noted.
  void pages() {
    for (const char* name : {"horse-312", "fish-950", "squirtle-1718", "triceratops-1000"}) {
      SegmentOptions options;
      const Vec3 size = bounding_box(mesh(name)).sizes();
      options.page = PageFit{{180, 267}, 200 / size.maxCoeff()};
      const Cut made = seeded(mesh(name), options);
      int outside = 0;
      for (const std::string& note : made.result.notes) outside += note.find("does not fit") != std::string::npos;
      row(fmt::format("{} on A4: do not fit", name), at_most(0), outside);
    }
  }

  void against_clusters() {
    for (const char* name : {"horse-312", "dragon-344", "snail-574", "ArcherElf-500", "star-9split", "fish-950",
                             "triceratops-1000", "mannequin-1376", "squirtle-1718"}) {
      const Cut necks = seeded(mesh(name), exactly(10)),
                clusters = seeded(mesh(name), exactly(10, SegmentMethod::Clusters));
      const Seam ours = seam_of(mesh(name), necks.result.parts), theirs = seam_of(mesh(name), clusters.result.parts);
      row(fmt::format("{} seam / clusters", name), at_most(0.65), ours.diagonals / theirs.diagonals);
      row(fmt::format("{} on valleys", name), at_least(0.85), ours.concave);
      row(fmt::format("{} more on valleys", name), at_least(0), ours.concave - theirs.concave);
      row(fmt::format("{} more proven", name), at_least(0), unproven(clusters) - unproven(necks));
      row(fmt::format("{} time / clusters", name), at_most(1), necks.seconds / clusters.seconds);
    }
  }

  void all_proven() {
    double parts = 0, failed = 0;
    for (const Named& named : meshes_) {
      if (args_.quick && named.mesh.num_faces() > 600) continue;
      const Cut made = seeded(named.mesh, {});
      if (unproven(made) > 0) fmt::print("  {}: {} not proven\n", named.name, unproven(made));
      parts += made.result.parts.num_parts();
      failed += unproven(made);
    }
    row(fmt::format("all meshes, {:.0f} parts: not proven", parts), at_most(0), failed);
  }

  void limbs() {
    double given = 0, free = 0, worst = 1;
    int count = 0;
    for (Animal animal : kAnimals)
      for (std::uint64_t seed = 11; seed <= 15; ++seed, ++count) {
        const CreatureOptions shape{.animal = animal, .faces = 500, .variety = 0.6, .seed = seed};
        const Mesh body{creature(shape)};
        const DualGraph graph(body);
        const std::vector<int> truth = true_parts(body, shape);
        NeckCutOptions exact;
        exact.max_parts = 1 + *std::max_element(truth.begin(), truth.end());
        exact.worst_score = std::numeric_limits<double>::infinity();
        given += rand_index(body, truth, cut_limbs_of(body, graph, exact));
        const double index = rand_index(body, truth, cut_limbs_of(body, graph));
        free += index;
        worst = std::min(worst, index);
      }
    row("limbs: Rand index, number given", at_least(0.91), given / count);
    row("limbs: Rand index, auto", at_least(0.89), free / count);
    row("limbs: Rand index, worst of auto", at_least(0.78), worst);
  }

  // Before anything else: the peak is that of the whole process.
  void growth() {
    const Mesh dog{creature({.animal = Animal::Dog, .faces = 20'000})};
    row("20,000 faces: seconds", at_most(3), processor_seconds([&] { cut_limbs_of(dog, DualGraph(dog)); }));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    row("20,000 faces: peak MiB", at_most(100), static_cast<double>(usage.ru_maxrss) / 1024);
  }

  void impossible_is_said() {
    for (const char* name : {"ArcherElf-500", "mannequin-1376", "seagull-462"}) {
      std::size_t pairs = 0;
      const double seconds = processor_seconds([&] { pairs = crossing_faces(mesh(name)).size(); });
      row(fmt::format("{}: pairs that cross", name), at_least(1), static_cast<double>(pairs));
      row(fmt::format("{}: seconds until said", name), at_most(0.2), seconds);
    }
  }

  void mirrored() {
    for (const char* name : {"star-024", "star-4split", "table", "squirtle-1718", "gear-508"}) {
      const std::optional<std::vector<int>> images = mirror_images(mesh(name));
      if (!images) continue;
      SegmentOptions options;
      options.symmetric = Symmetry::On;
      const std::vector<int> partner = mirror_partners(cut(mesh(name), options).result.parts.part, *images);
      row(fmt::format("{}: parts without an image", name), at_most(0),
          static_cast<double>(std::count(partner.begin(), partner.end(), -1)));
    }
  }

  const Arguments& args_;
  std::vector<Named> meshes_;
  Table table_;
  int seed_ = 1, rows_ = 0, reached_ = 0;
};

}  // namespace

bool acceptance(const Arguments& arguments, int first, int last) { return Acceptance(arguments).run(first, last); }

}  // namespace plico::bench
