// Rigid origami: the dissertation's tables 3.1 to 3.3 row by row beside ours, and large tessellations.
//   bench_origami [--json FILE] [--quick]
//   bench_origami --patterns DIR             instead: how far the crease patterns of a folder fold
#include <sys/resource.h>

#include "drawn_patterns.h"
#include "plico/motion/planner.h"
#include "plico/origami/bases.h"
#include "plico/origami/continuation.h"
#include "plico/origami/crease_groups.h"
#include "plico/origami/discrete_states.h"
#include "plico/origami/facets.h"
#include "plico/origami/md_frog.h"
#include "plico/origami/patterns.h"
#include "plico/origami/reuse.h"
#include "plico/verify/path.h"
#include "plico/workflow/plan_origami.h"
#include "table.h"

namespace plico::bench {
namespace {

constexpr double kLimit = 60;  // seconds a plan

std::string verdict(const PathProof& proof) { return std::string(plico::name(proof.verdict)); }

// As `plico fold` does it: waypoints are inserted until hinges stay together between them, then the proof.
PathProof proven(const CreasePattern& sheet, const FoldingPath& path) {
  const Linkage linkage = make_linkage(sheet);
  if (!linkage.has_loops()) return prove_path(linkage, path);
  return prove_path(linkage, refine_path(linkage, path, default_clearance(linkage) / 5));
}

// Time in [Xi17] with FROG or MD-FROG, and its number of creases.
struct Row31 {
  const char* name;
  CreasePattern sheet;
  int printed_creases;
  double printed_seconds;
};

std::vector<Row31> rows_31() {
  return {{"L", l(), 2, 0.004},
          {"L2", l2(), 4, 8.317},
          {"Box1", box1(), 6, 0.101},
          {"Diamond", diamond(), 6, 0.514},
          {"Waterbomb", waterbomb_base(), 8, 0.613},
          {"Fly1", fly1(), 8, 0.631},
          {"Box2", box2(), 9, 1.463},
          {"Fly2", fly2(), 11, 2.425},
          {"Miura", miura(), 12, 13.564},
          {"Sailboat", sailboat(), 34, 83.923}};
}

void frog_row(Table& table, const Row31& row, FindFoldable find) {
  FrogOptions options{.find = find};
  options.nlopt.tolerance = 1e-3;
  FrogResult found;
  const double time = seconds([&] { found = frog(row.sheet, options, limited({}, kLimit)); });
  const bool arrived = found.ending == Ending::Found;
  const std::string planner = find == FindFoldable::Nlopt ? "FROG, NLopt" : "FROG";
  table.row({row.name, row.printed_creases, make_linkage(row.sheet).num_hinges(), planner, time,
             std::string(name(found.ending)), found.counts.sampled, found.counts.valid, found.counts.tested,
             found.worst_residual,
             arrived && find == FindFoldable::GaussNewton ? nlohmann::json(verdict(proven(row.sheet, found.path)))
                                                          : nlohmann::json(),
             row.printed_seconds});
}

void md_frog_row(Table& table, const Row31& row) {
  MdFrogResult found;
  const double time = seconds([&] { found = md_frog(row.sheet, {}, limited({}, kLimit)); });
  const bool arrived = found.ending == Ending::Found;
  table.row({row.name, row.printed_creases, make_linkage(row.sheet).num_hinges(), "MD-FROG", time,
             std::string(name(found.ending)), found.samples, found.states, found.tested, found.worst_residual,
             arrived ? nlohmann::json(verdict(proven(row.sheet, found.paths.front().path))) : nlohmann::json(),
             row.printed_seconds});
}

// With the proof, as `plico fold` does it.
void default_row(Table& table, const Row31& row) {
  MotionOutcome found;
  const Linkage linkage = make_linkage(row.sheet);
  const double time = seconds([&] { found = plan_origami(row.sheet, {}, limited({}, kLimit)); });
  const bool any = !found.motions.empty();
  table.row({row.name,
             row.printed_creases,
             linkage.num_hinges(),
             any ? "default: " + std::string(name(found.motions.front().method)) : "default",
             time,
             std::string(name(found.ending)),
             {},
             {},
             {},
             any ? found.motions.front().proof.loops.residual : 0.0,
             any ? nlohmann::json(verdict(found.motions.front().proof)) : nlohmann::json(),
             row.printed_seconds});
}

void states_row(Table& table, const char* name, const CreasePattern& sheet, std::vector<int> groups, int three,
                int four) {
  const int n = groups.empty() ? make_linkage(sheet).num_hinges() : 1 + *std::max_element(groups.begin(), groups.end());
  DiscreteStates states[2];
  double time[2];
  for (const AngleSet angles : {AngleSet::Discrete3, AngleSet::Discrete4}) {
    const int i = static_cast<int>(angles);
    time[i] = seconds([&] { states[i] = discrete_states(sheet, {.angles = angles, .groups = groups}); });
  }
  table.row({name, n, states[0].states.size(), three, time[0], states[1].states.size(), four, time[1]});
}

void states_table(Table& table) {
  std::vector<int> boat = groups_of(discrete_states(sailboat()).states);
  constexpr int kMerged[] = {0, 1, 0, 0, 0, 2, 3, 4, 5, 5, 5, 5};  // mirror images, fins and border flaps fold alike
  for (int& group : boat) group = kMerged[group];
  states_row(table, "Waterbomb, grouped", waterbomb_base(), crease_groups(waterbomb_base()).group, 5, 6);
  states_row(table, "Miura, grouped", miura(), crease_groups(miura()).group, 3, 3);
  states_row(table, "L2", l2(), {}, 5, 6);
  states_row(table, "Sailboat, grouped", sailboat(), boat, 48, 118);
  states_row(table, "Waterbomb", waterbomb_base(), {}, 71, 114);
  states_row(table, "Miura", miura(), {}, 7, 7);
}

struct Row33 {
  std::string name;
  CreasePattern sheet;
  double printed[3];  // seconds in [Xi17]: every crease by itself, symmetry, and essential vertices; 0 for none
  int frames = 20;
};

CreasePattern miura_of(int size, bool diagonals) {
  return miura({.columns = size, .rows = size, .zigzag_angle = radians(120), .facet_diagonals = diagonals});
}

CreasePattern waterbomb_of(int columns, int rows, bool horizontals) {
  return waterbomb({columns, rows, radians(columns > 11 ? 49 : 60), horizontals});
}

void tessellation_rows(Table& table, const Row33& row) {
  const CreaseGroups groups = crease_groups(row.sheet);
  const std::string vertices = fmt::format("{}/{}", groups.type.size(), groups.essential.size());
  for (int k = 0; k < 3; ++k) {
    ContinuationOptions options{.frames = row.frames};
    if (k > 0) options.groups = groups.group;
    if (k > 1) options.essential = groups.essential;
    ContinuationResult found;
    const double time = seconds([&] { found = continue_to_goal(with_flat_creases_held(row.sheet), options); });
    options.check_collisions = false;
    const double without = seconds([&] { continue_to_goal(with_flat_creases_held(row.sheet), options); });
    const WaypointCheck check = check_waypoints(row.sheet, found.path);
    const char* names[] = {"every crease", "groups", "groups, essential"};
    table.row({row.name, vertices, k == 0 ? make_linkage(row.sheet).num_hinges() : groups.num_moving, names[k], time,
               100 * std::max(0.0, 1 - without / time), std::string(name(found.ending)), found.path.waypoints.size(),
               check.worst_residual, check.waypoint < 0 ? "free" : "collides",
               row.printed[k] > 0 ? nlohmann::json(row.printed[k]) : nlohmann::json()});
  }
}

void reuse_row(Table& table, const std::string& name, const CreasePattern& small, const CreasePattern& large) {
  const CreaseGroups groups = crease_groups(small);
  ContinuationResult full, few;
  const double planning_all = seconds([&] { full = continue_to_goal(with_flat_creases_held(large), {.frames = 20}); });
  const double planning = seconds(
      [&] { few = continue_to_goal(small, {.frames = 20, .groups = groups.group, .essential = groups.essential}); });
  FoldingPath path;
  const double carrying = seconds([&] { path = reuse_path(small, few.path, large); });
  WaypointCheck check;
  const double checking = seconds([&] { check = check_waypoints(large, path); });
  table.row({name, planning_all, planning, carrying, checking, planning_all / (planning + carrying),
             check.worst_residual, check.valid() ? "valid" : "not valid"});
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// Planned with collisions checked at every waypoint, then proven in between.
void large_row(Table& table, const std::string& name, const CreasePattern& sheet, int frames) {
  const Linkage linkage = make_linkage(sheet);
  ContinuationResult found;
  const double time = seconds([&] { found = continue_to_goal(with_flat_creases_held(sheet), {.frames = frames}); });
  const Tear torn = tear(sheet, linkage, found.path.waypoints.back().config);
  PathProof proof;
  const double proving = seconds([&] { proof = proven(sheet, found.path); });
  table.row({name, linkage.num_hinges(), found.path.waypoints.size(), time, std::string(plico::name(found.ending)),
             found.worst_residual, torn.gap, proving, verdict(proof), proof.loops.gap, peak_mib()});
}

int bench(const Arguments& args) {
  Table planners("Planning a motion ([Xi17] table 3.1)",
                 {"pattern", "[Xi17] creases", "creases", "planner", "s", "ending", "sampled", "valid", "tested",
                  "worst rad", "proof", "[Xi17] s"});
  for (const Row31& row : rows_31()) {
    frog_row(planners, row, FindFoldable::GaussNewton);
    if (!args.quick) frog_row(planners, row, FindFoldable::Nlopt);
    md_frog_row(planners, row);
    default_row(planners, row);
  }
  Table states("Foldable configurations of the discrete domain ([Xi17] table 3.2)",
               {"pattern", "n", "Discrete3", "[Xi17]", "s", "Discrete4", "[Xi17] 4", "s 4"});
  states_table(states);
  Table tessellations("Tessellations with and without symmetry ([Xi17] table 3.3)",
                      {"pattern", "real/essential", "unknowns", "planned", "s", "collision %", "ending", "waypoints",
                       "worst rad", "all pairs", "[Xi17] s"});
  tessellation_rows(tessellations, {"Miura 3x3", miura_of(3, false), {0.037, 0.016, 0.014}});
  tessellation_rows(tessellations, {"Miura 5x5", miura_of(5, false), {1.681, 0.098, 0.082}});
  tessellation_rows(tessellations, {"Miura 24x24", miura_of(24, true), {0, 35.278, 32.402}});
  tessellation_rows(tessellations, {"Waterbomb 4x6", waterbomb_of(4, 6, false), {0.040, 0.037, 0.034}});
  tessellation_rows(tessellations, {"Waterbomb 8x10", waterbomb_of(8, 10, false), {0.406, 0.332, 0.310}});
  tessellation_rows(tessellations, {"Waterbomb 12x22", waterbomb_of(12, 22, true), {499.048, 3.893, 3.160}});
  Table reuse(
      "Motions of small patterns carried to large ones ([Xi17] 3.3.2)",
      {"small -> large", "full plan s", "small plan s", "carry s", "check s", "full / small", "worst rad", "check"});
  reuse_row(reuse, "Miura 3x3 -> 24x24", miura_of(3, false), miura_of(24, true));
  reuse_row(reuse, "Waterbomb 4x6 -> 12x22", waterbomb({4, 6, radians(49)}), waterbomb_of(12, 22, true));
  Table large(
      "Large tessellations, every crease by itself, 20 frames",
      {"pattern", "creases", "waypoints", "s", "ending", "worst rad", "tear", "proof s", "proof", "gap", "peak MiB"});
  large_row(large, "Miura 24x24", miura_of(24, false), 20);
  large_row(large, "Miura 24x24, diagonals", miura_of(24, true), 20);
  large_row(large, "Waterbomb 12x22", waterbomb_of(12, 22, false), 20);
  if (!args.quick) large_row(large, "Miura 122x122", miura_of(122, false), 20);
  write_json(args, {&planners, &states, &tessellations, &reuse, &large});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  plico::silence_planners();
  if (argc == 3 && std::string_view(argv[1]) == "--patterns") return plico::bench::drawn_patterns(argv[2]);
  return plico::bench::bench(plico::bench::arguments(argc, argv));
}
