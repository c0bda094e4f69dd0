// The motion of stacked chains: how many shapes unpack, by thickness, proven; a long one; what the proof costs.
#include <algorithm>

#include "plico/io/mesh/mesh_file.h"
#include "plico/shapes/named_shapes.h"
#include "plico/stack/peel_by_samples.h"
#include "plico/workflow/stack_motion.h"
#include "tables.h"

namespace plico::bench {
namespace {

const std::vector<std::string> kMotionColumns{"model", "panels", "t",      "layers", "ideal",
                                              "share", "chains", "proven", "s",      "judge s"};

// Stack and motion as `plico stack --motion shape` finds them, the judge's time in it.
struct Unpacked {
  StackMotion motion;
  double all = 0, judge = 0;  // seconds
  bool is_found() const { return motion.ending == Ending::Found; }
};

Unpacked unpacked(const PolygonSoup& soup, int squares, double thickness, const Run& run) {
  Unpacked result;
  const VoxelMesh voxels = voxel_mesh(soup, {.squares = squares});
  const StackMeshOptions stacking{.thickness = thickness};
  result.all = seconds([&] {
    const JudgedCycle cycle = judged_cycle(voxels, {}, run);
    const StackedChain first = stack_voxels(voxels, cycle.walk(), stacking, run);
    result.motion = unpack_stack(voxels, first, stacking, {}, run);
  });
  result.judge = seconds([&] { judge_chain_motion(result.motion.chain.claim, result.motion.path); });
  return result;
}

void add_row(Table& table, const std::string& model, double thickness, const Unpacked& unpacked) {
  const StackMotion& motion = unpacked.motion;
  const ChainVerdict& verdict = motion.chain.verdict;
  table.row({model, verdict.panels, thickness, verdict.height, verdict.ideal, motion.share(), motion.chains,
             unpacked.is_found()     ? "yes"
             : motion.verdict.free() ? "prefix"
                                     : "no",
             unpacked.all, unpacked.judge});
}

struct NamedSoup {
  std::string name;
  PolygonSoup soup;
};

std::vector<NamedSoup> models(const StackBench& bench) {
  std::vector<NamedSoup> all;
  for (const char* shape : {"bird", "fish", "dinosaur"}) all.push_back({shape, make_shape(shape)});
  int seen = 0;
  for (const auto& path : mesh_files(bench.meshes))
    if (!bench.quick || seen++ % 8 == 0) all.push_back({path.stem().string(), read_mesh_file(path.string()).soup});
  return all;
}

std::vector<NamedSoup> bunny_or_dinosaur(const StackBench& bench) {
  for (const auto& path : mesh_files(bench.meshes))
    if (path.stem() == "bunny-348") return {{"bunny-348", read_mesh_file(path.string()).soup}};
  return {{"dinosaur", make_shape("dinosaur")}};
}

void long_motions(const StackBench& bench, Table& table, Goals& goals) {
  for (const NamedSoup& model : bunny_or_dinosaur(bench))
    for (const auto& [thickness, goal] : {std::pair{0.001, 3.0}, {0.1, 0.0}}) {
      const Unpacked one = unpacked(model.soup, 2206, thickness, limited({}, 90));
      add_row(table, model.name, thickness, one);
      goals.add(fmt::format("motion of {}, 2206 squares, t = {}", model.name, thickness),
                goal > 0 ? fmt::format("planned and proven in {:g} s", goal) : "proven",
                fmt::format("{}, {:.3g} s", one.is_found() ? "proven" : "not found", one.all),
                one.is_found() && (goal == 0 || one.all <= goal));
    }
}

// One search over the same chain with the proof of every step, and with samples 7.5 degrees apart instead.
void price_of_proof(const StackBench& bench, Table& table, Goals& goals) {
  const PolygonSoup soup = bunny_or_dinosaur(bench)[0].soup;
  const VoxelMesh voxels = voxel_mesh(soup, {.squares = 300});
  for (const auto& [thickness, most] : {std::pair{0.001, 10.0}, {0.01, 3.0}, {0.1, 3.0}}) {
    double proven = 0, sampled = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const JudgedCycle cycle = judged_cycle(voxels, {.seed = seed});
      const StackedChain chain = stack_voxels(voxels, cycle.walk(), {.seed = seed, .thickness = thickness});
      const Linkage linkage = chain_linkage_of(chain.claim);
      const int sign = pile_sign(chain.found.best.folds);
      proven += seconds([&] { peel(linkage, sign); });
      sampled += seconds([&] { peel_by_samples(linkage, sign, 7.5); });
    }
    table.row({"10 chains of 300", thickness, proven, sampled, proven / sampled});
    goals.add(fmt::format("proof in the planner against samples, t = {}", thickness), fmt::format("{:g} times", most),
              fmt::format("{:.2g} times", proven / sampled), proven <= most * sampled);
  }
}

void threads(const StackBench& bench, Goals& goals) {
  const NamedSoup model = bunny_or_dinosaur(bench)[0];
  const auto bytes = [&](int threads) {
    Run run;
    run.threads = threads;
    return write_fold(chain_motion_file(unpacked(model.soup, 300, 0.05, run).motion));
  };
  const bool same = bytes(1) == bytes(4);
  goals.add("same seed, 1 and 4 threads", "identical bytes", same ? "identical" : "different", same);
}

}  // namespace

std::vector<Table> motion_tables(const StackBench& bench, Goals& goals) {
  Table table("From the stack to the shape, about 250 squares, 60 s each", kMotionColumns);
  for (const auto& [thickness, share] : {std::pair{0.001, 1.0}, {0.01, 1.0}, {0.05, 0.9}, {0.1, 0.7}, {0.2, 0.7}}) {
    int found = 0, all = 0;
    for (const NamedSoup& model : models(bench)) {
      const Unpacked one = unpacked(model.soup, 250, thickness, limited({}, 60));
      add_row(table, model.name, thickness, one);
      found += one.is_found();
      ++all;
    }
    goals.add(fmt::format("motions at t = {}", thickness), fmt::format("{:g} % in 60 s", 100 * share),
              fmt::format("{} of {}", found, all), found >= share * all);
  }
  std::vector<Table> tables;
  tables.push_back(std::move(table));
  return tables;
}

std::vector<Table> proof_tables(const StackBench& bench, Goals& goals) {
  std::vector<Table> tables;
  tables.emplace_back("Long motions", kMotionColumns);
  long_motions(bench, tables.back(), goals);
  tables.emplace_back("What the proof costs",
                      std::vector<std::string>{"chains", "t", "proven s", "sampled s", "ratio"});
  price_of_proof(bench, tables.back(), goals);
  threads(bench, goals);
  return tables;
}

}  // namespace plico::bench
