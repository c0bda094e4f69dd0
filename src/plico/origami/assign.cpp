#include "plico/origami/assign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/sat.h"
#include "plico/origami/pattern_check.h"

namespace plico {
namespace {

constexpr int kMostVerticesNamed = 5;

bool has_letter(const Crease& crease) {
  return crease.assignment == Assignment::Mountain || crease.assignment == Assignment::Valley;
}

// A vertex inside the sheet as its folds see it: flat creases are passed over.
struct FlatVertex {
  int vertex = -1;
  std::vector<int> edges;
  std::vector<double> sectors;  // the i-th from edge i to the next
};

FlatVertex flat_vertex(const CreasePattern& sheet, const VertexFacts& facts) {
  FlatVertex result{facts.vertex, {}, {}};
  double before_first = 0;
  for (std::size_t i = 0; i < facts.edges.size(); ++i) {
    const Crease& crease = sheet.edges[facts.edges[i]];
    if (has_letter(crease) || crease.assignment == Assignment::Unassigned) {
      result.edges.push_back(facts.edges[i]);
      result.sectors.push_back(0);
    }
    (result.sectors.empty() ? before_first : result.sectors.back()) += facts.sectors[i];
  }
  if (!result.sectors.empty()) result.sectors.back() += before_first;
  return result;
}

// A run of equal sectors, less than those on either side of it: where it begins and how many they are.
struct LeastRun {
  int first = 0, size = 0;
};

LeastRun least_run(const std::vector<double>& sectors, double angle) {
  const int n = static_cast<int>(sectors.size());
  const double least = *std::min_element(sectors.begin(), sectors.end());
  const auto is_least = [&](int i) { return sectors[((i % n) + n) % n] <= least + angle; };
  LeastRun run;
  while (run.first < n && (!is_least(run.first) || is_least(run.first - 1))) ++run.first;
  while (run.size < n && is_least(run.first + run.size)) ++run.size;
  return run;
}

template <class T>
void begin_at(std::vector<T>& around, int first) {
  std::rotate(around.begin(), around.begin() + first, around.end());
}

// Variable e + 1: edge e is a valley. Of every vertex a variable that switches its clauses on.
class AssignmentFormula {
 public:
  AssignmentFormula(const CreasePattern& sheet, const AssignOptions& options) : sheet_(sheet), options_(options) {
    for (int e = 0; e < sheet.num_edges(); ++e)
      if (has_letter(sheet.edges[e])) solver_.add({sheet.edges[e].assignment == Assignment::Valley ? e + 1 : -(e + 1)});
  }

  // False when the vertex by itself cannot fold flat with the letters that are there.
  bool ask_for(const FlatVertex& vertex) {
    const int on = sheet_.num_edges() + 1 + static_cast<int>(vertices_.size());
    const int degree = static_cast<int>(vertex.edges.size());
    bool possible = false;
    for (unsigned folds = 0; folds < 1U << degree; ++folds) {
      std::vector<int> signs;
      for (int i = 0; i < degree; ++i) signs.push_back(folds >> i & 1U ? 1 : -1);
      if (folds_flat(vertex.sectors, signs, options_.angle)) {
        possible = possible || agrees(vertex, signs);
        continue;
      }
      std::vector<int> clause{-on};
      for (int i = 0; i < degree; ++i) clause.push_back(-signs[i] * (vertex.edges[i] + 1));
      solver_.add(clause);
    }
    vertices_.push_back(vertex.vertex);
    return possible;
  }

  SatAnswer solve(const Run& run) {
    for (std::size_t i = 0; i < vertices_.size(); ++i) solver_.assume(sheet_.num_edges() + 1 + static_cast<int>(i));
    return solver_.solve(run);
  }

  // Not this answer again, as far as the creases say that are `free`.
  void forbid(const std::vector<int>& free) {
    std::vector<int> clause;
    for (int e : free) clause.push_back(is_valley(e) ? -(e + 1) : e + 1);
    solver_.add(clause);
  }

  bool is_valley(int edge) { return solver_.holds(edge + 1); }

  // The vertices without whose conditions there may be an assignment.
  std::vector<int> clashing() {
    std::vector<int> result;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      if (solver_.is_at_fault(sheet_.num_edges() + 1 + static_cast<int>(i))) result.push_back(vertices_[i]);
    return result;
  }

 private:
  bool agrees(const FlatVertex& vertex, const std::vector<int>& signs) const {
    for (std::size_t i = 0; i < signs.size(); ++i) {
      const Crease& crease = sheet_.edges[vertex.edges[i]];
      if (has_letter(crease) && (crease.assignment == Assignment::Valley) != (signs[i] > 0)) return false;
    }
    return true;
  }

  const CreasePattern& sheet_;
  const AssignOptions& options_;
  SatSolver solver_;
  std::vector<int> vertices_;
};

std::string place_of(const CreasePattern& sheet, int vertex) {
  return fmt::format("vertex {} (near {:.6g} {:.6g})", vertex, sheet.vertices[vertex].x(), sheet.vertices[vertex].y());
}

std::string why_not_flat(const CreasePattern& sheet, const FlatVertex& vertex, double angle) {
  const std::string place = place_of(sheet, vertex.vertex);
  const std::size_t degree = vertex.edges.size();
  if (degree % 2 == 1) return fmt::format("{} has {} creases, and an odd number never folds flat", place, degree);
  double every_other = 0;
  for (std::size_t i = 0; i < degree; i += 2) every_other += vertex.sectors[i];
  if (const double off = std::abs(every_other - kPi); off > angle)
    return fmt::format("every other sector at {} adds up to {:.6g} degrees instead of 180 (Kawasaki)", place,
                       degrees(every_other));
  return fmt::format(
      "no choice at {} folds flat with the mountains and valleys that are there (Maekawa, big-little-big)", place);
}

std::string why_not_together(const CreasePattern& sheet, const std::vector<int>& vertices) {
  std::string named;
  for (std::size_t i = 0; i < vertices.size() && i < kMostVerticesNamed; ++i)
    named += (i > 0 ? ", " : "") + place_of(sheet, vertices[i]);
  return fmt::format("each vertex folds flat by itself, but these {} do not together: {}{}", vertices.size(), named,
                     vertices.size() > kMostVerticesNamed ? ", ..." : "");
}

AssignResult none(const CreasePattern& sheet, std::vector<int> vertices, std::string why, Ending ending) {
  AssignResult result;
  result.ending = ending;
  result.sheet = sheet;
  result.vertices = std::move(vertices);
  result.why = std::move(why);
  return result;
}

AssignResult written(const CreasePattern& sheet, const std::vector<int>& free, AssignmentFormula& formula) {
  AssignResult result;
  result.ending = Ending::Found;
  result.sheet = sheet;
  result.assigned = static_cast<int>(free.size());
  for (int e : free) {
    Crease& crease = result.sheet.edges[e];
    crease.assignment = formula.is_valley(e) ? Assignment::Valley : Assignment::Mountain;
    crease.fold_angle = flat_fold_angle(crease.assignment);
  }
  return result;
}

std::vector<int> creases_without_letter(const CreasePattern& sheet) {
  std::vector<int> free;
  const std::vector<int> hinge = hinge_of_edge(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e)
    if (sheet.edges[e].assignment == Assignment::Unassigned && hinge[e] >= 0) free.push_back(e);
  return free;
}

// The first assignment that suits, or else the first of all.
AssignResult first_that_suits(const CreasePattern& sheet, const AssignOptions& options, AssignmentFormula& formula,
                              const Run& run) {
  const std::vector<int> free = creases_without_letter(sheet);
  std::optional<AssignResult> first;
  for (int refused = 0; refused <= options.max_refused; ++refused) {
    const SatAnswer answer = formula.solve(run);
    if (answer != SatAnswer::Satisfiable) {
      if (first) break;
      if (answer == SatAnswer::RunOver) return none(sheet, {}, {}, run.ending());
      const std::vector<int> vertices = formula.clashing();
      return none(sheet, vertices, why_not_together(sheet, vertices), Ending::Exhausted);
    }
    AssignResult found = written(sheet, free, formula);
    if (!options.suits || options.suits(found.sheet)) return found;
    found.suits = false;
    if (!first) first = std::move(found);
    if (free.empty()) break;
    formula.forbid(free);
  }
  return *std::move(first);
}

}  // namespace

bool folds_flat(std::vector<double> sectors, std::vector<int> folds, double angle) {
  while (!sectors.empty()) {
    const int n = static_cast<int>(sectors.size());
    const LeastRun run = least_run(sectors, angle);
    if (n % 2 == 1) return false;
    if (run.size == n) {  // all are equal
      int sum = 0;
      for (int fold : folds) sum += fold;
      return std::abs(sum) == 2;
    }
    if (run.size > n - 2) return false;  // one sector on both sides: no sum of others can be half of the whole
    // The run with the sector before it first: sectors 1 ... size, between creases 1 ... size + 1.
    const int before = (run.first + n - 1) % n;
    begin_at(sectors, before);
    begin_at(folds, before);
    int sum = 0;
    for (int i = 1; i <= run.size + 1; ++i) sum += folds[i];
    if (std::abs(sum) != (run.size % 2 == 1 ? 0 : 1)) return false;
    if (run.size % 2 == 1) {  // the neighbours become one sector, of which the run takes back its size
      sectors[0] += sectors[run.size + 1] - sectors[1];
      sectors.erase(sectors.begin() + 1, sectors.begin() + run.size + 2);
      folds.erase(folds.begin() + 1, folds.begin() + run.size + 2);
    } else {  // what is left of the run is one crease
      folds[1] = sum;
      sectors.erase(sectors.begin() + 1, sectors.begin() + run.size + 1);
      folds.erase(folds.begin() + 2, folds.begin() + run.size + 2);
    }
  }
  return true;
}

AssignResult assign_creases(const CreasePattern& sheet, const AssignOptions& options, const Run& run) {
  require(options.angle > 0, "angle", options.angle, "above 0");
  require(options.max_refused >= 0, "max refused", options.max_refused, "at least 0");
  AssignmentFormula formula(sheet, options);
  for (const VertexFacts& facts : vertex_facts(sheet)) {
    const FlatVertex vertex = flat_vertex(sheet, facts);
    if (static_cast<int>(vertex.edges.size()) > kMostAssigned)
      throw InvalidInput(
          "origami/degree",
          fmt::format("{} creases at a vertex, at most {} can be assigned", vertex.edges.size(), kMostAssigned),
          place_of(sheet, vertex.vertex));
    if (run.over()) return none(sheet, {}, {}, run.ending());
    if (!formula.ask_for(vertex))
      return none(sheet, {vertex.vertex}, why_not_flat(sheet, vertex, options.angle), Ending::Exhausted);
  }
  return first_that_suits(sheet, options, formula, run);
}

}  // namespace plico
