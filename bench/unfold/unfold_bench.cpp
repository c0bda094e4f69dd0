// One net for every mesh: our search against EU, the dissertation's genetic algorithm, in one run.
//   bench_unfold [--meshes DIR] [--json FILE] [--quick]
// Table 1: time of the search (median of seeds 1-10) against one layout + exact verification, and against EU.
// Table 2: growth with the face count on the project's own creatures and on meshes that are hard in the ways of scans
// and
//   of designed parts (hard_meshes.h), against the goal, with peak memory.
//   bench_unfold --row NAME FACES [SEEDS [SECONDS]]: one row of table 2, so that a long one can have the machine to
//   itself.
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>

#include "../hard_meshes.h"
#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/measures.h"
#include "plico/shapes/named_shapes.h"
#include "plico/unfold/classic.h"
#include "plico/unfold/evolve.h"
#include "plico/unfold/search.h"
#include "plico/verify/net.h"
#include "table.h"

namespace plico::bench {
namespace {

using nlohmann::json;

// EU is stopped once it has taken this many times our time, but not before the first nor after the second limit.
constexpr double kEuRatio = 1500, kEuSecondsAtLeast = 5, kEuSecondsAtMost = 90;
constexpr double kSearchSeconds = 120;

struct Ours {
  int nets = 0;  // of the seeds tried, verified
  double median = 0, slowest = 0, verify = 0;
  int start_overlaps = 0;
};

Ours run_ours(const Mesh& mesh, int seeds, double limit = kSearchSeconds) {
  Ours ours;
  std::vector<double> searches, judgements;
  for (int seed = 1; seed <= seeds; ++seed) {
    SearchResult result;
    const auto search = [&] { result = find_net(mesh, {.seed = std::uint64_t(seed)}, limited(Run{}, limit)); };
    searches.push_back(seconds(search));
    NetVerdict verdict;
    judgements.push_back(seconds([&] { verdict = verify_net(lay_flat(mesh, result.forest), mesh); }));
    ours.nets += result.ending == Ending::Found && verdict.is_net();
    ours.start_overlaps = std::max(ours.start_overlaps, result.start_overlaps);
  }
  ours.median = median(searches);
  ours.slowest = *std::max_element(searches.begin(), searches.end());
  ours.verify = median(judgements);
  return ours;
}

// Seconds EU took, and whether it found a net within its limit.
std::pair<double, bool> run_eu(const Mesh& mesh, double limit) {
  EvolveResult result;
  const double time = seconds([&] { result = evolve_net(mesh, {.seed = 1}, limited(Run{}, limit)); });
  return {time, result.ending == Ending::Found};
}

// Overlaps of the best of 20 steepest-edge trees: where the classic heuristics leave off.
int classic_overlaps(const Mesh& mesh) { return classic_net(mesh).overlaps; }

// What the dissertation says of a mesh, where it does.
json dissertation(const std::string& name) {
  if (name == "bunny-128" || name == "moneybox-128") return "net in about 200 generations (fig 4.2)";
  return nullptr;
}

void compare(Table& table, const std::string& name, const Mesh& mesh, const Arguments& arguments) {
  const Ours ours = run_ours(mesh, arguments.quick ? 2 : 10);
  const auto [eu_time, eu_found] =
      run_eu(mesh, arguments.quick ? 2 : std::clamp(kEuRatio * ours.median, kEuSecondsAtLeast, kEuSecondsAtMost));
  const std::string bound = eu_found ? "" : ">";  // EU had not finished
  table.row({name, mesh.num_faces(), classic_overlaps(mesh), ours.start_overlaps,
             fmt::format("{}/{}", ours.nets, arguments.quick ? 2 : 10), ours.median * 1e3, ours.slowest * 1e3,
             ours.verify * 1e3, ours.median / ours.verify, fmt::format("{}{:.3g}", bound, eu_time),
             fmt::format("{}{:.0f}", bound, eu_time / ours.median), dissertation(name)});
}

void compare_all(Table& table, const Arguments& arguments) {
  for (const char* creature : {"bird", "dog", "fish", "dinosaur"})
    for (int faces : {100, 300, 1000, 2000}) {
      const Mesh mesh(make_shape(creature, {.faces = faces}));
      compare(table, fmt::format("{} {}", creature, faces), mesh, arguments);
    }
  for (const std::filesystem::path& path : mesh_files(arguments.meshes)) {
    try {
      const Mesh mesh = load_mesh(path);
      if (is_closed(mesh)) compare(table, path.stem(), mesh, arguments);
    } catch (const Error& error) {
      fmt::print("{:<24}  not a closed manifold: {}\n", path.stem().string(), error.what());
    }
  }
}

double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

PolygonSoup shape_of(const std::string& name, int faces) {
  if (name == "car body") return car_body(faces);
  if (name == "bust") return bust(faces);
  if (name == "egg crate") return egg_crate(faces);
  return make_shape(name, {.faces = faces});
}

// Search time over one layout + verification that is asked of the creatures (null: nothing was asked).
json goal_for(const std::string& name, int faces) {
  if (name != "bird" && name != "dinosaur") return nullptr;
  if (faces <= 10'000) return 15;
  if (faces <= 20'000) return 30;
  return faces <= 100'000 ? json(100) : json(nullptr);
}

Table growth_table() {
  return Table(
      "Growth of the search with the face count (seconds; peak memory of the process in MiB so far)",
      {"shape", "faces", "nets", "search s", "slowest s", "layout+verify s", "ratio", "goal", "reached", "peak MiB"});
}

void growth_row(Table& table, const std::string& name, int faces, int seeds, double limit = kSearchSeconds) {
  const Mesh mesh(shape_of(name, faces));
  const Ours ours = run_ours(mesh, seeds, limit);
  const json goal = goal_for(name, faces);
  const double ratio = ours.median / ours.verify;
  table.row({name, mesh.num_faces(), fmt::format("{}/{}", ours.nets, seeds), ours.median, ours.slowest, ours.verify,
             ratio, goal, goal.is_null() ? json(nullptr) : json(ratio <= goal.get<double>() ? "yes" : "no"),
             peak_memory_mib()});
}

void grow(Table& table, const Arguments& arguments) {
  for (int faces : {1000, 2000, 5000, 10'000, 20'000, 50'000, 100'000}) {
    if (arguments.quick && faces > 5000) break;
    for (const char* shape : {"bird", "dinosaur", "car body", "bust", "egg crate"})
      growth_row(table, shape, faces, faces > 20'000 || arguments.quick ? 1 : 3);
  }
}

// The row that --row names.
int run_row(int argc, char** argv) {
  Table table = growth_table();
  growth_row(table, argv[2], std::atoi(argv[3]), argc > 4 ? std::atoi(argv[4]) : 3,
             argc > 5 ? std::atof(argv[5]) : kSearchSeconds);
  return 0;
}

int run(int argc, char** argv) {
  if (argc >= 4 && std::string(argv[1]) == "--row") return run_row(argc, argv);
  const Arguments args = arguments(argc, argv);
  // Growth first: peak memory only rises.
  Table growth = growth_table();
  grow(growth, args);
  Table comparison(
      "One net: our search, seeds 1-10, against EU with the dissertation's parameters (> where EU was stopped)",
      {"mesh", "faces", "classic overlaps", "start overlaps", "nets", "search ms", "slowest ms", "layout+verify ms",
       "ratio", "EU s", "EU / ours", "dissertation"});
  compare_all(comparison, args);
  write_json(args, {&growth, &comparison});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) { return plico::bench::run(argc, argv); }
