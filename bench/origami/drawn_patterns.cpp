#include "drawn_patterns.h"

#include <fmt/format.h>

#include <iterator>

#include "plico/base/error.h"
#include "plico/io/pattern/pattern_file.h"
#include "plico/origami/settle.h"
#include "plico/workflow/plan_sheets.h"
#include "table.h"

namespace plico::bench {
namespace {

constexpr double kPatternLimit = 20;  // seconds a pattern

struct DrawnCounts {
  int files = 0, read = 0, goal = 0, half = 0, third = 0;
};

std::vector<std::filesystem::path> pattern_files(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && pattern_format_of(entry.path().filename().string())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

void count(DrawnCounts& counts, const MotionOutcome& outcome) {
  if (!outcome.proven()) return;
  counts.goal += outcome.progress >= 0.98;
  counts.half += outcome.progress >= 0.5;
  counts.third += outcome.progress >= 0.3;
}

// The largest move of a vertex, of the shortest edge; null for a sheet that folds as it was drawn.
nlohmann::json settled_by(const CreasePattern& drawn, const MotionOutcome& outcome) {
  if (!outcome.sheet) return {};
  double move = 0;
  for (int v = 0; v < drawn.num_vertices(); ++v)
    move = std::max(move, (outcome.sheet->vertices[v] - drawn.vertices[v]).norm());
  return move > 0 ? nlohmann::json(move / shortest_edge(drawn)) : nlohmann::json();
}

void pattern_row(Table& table, const std::string& name, const CreasePattern& drawn, DrawnCounts& counts) {
  MotionOutcome outcome;
  const double time = seconds([&] { outcome = plan_sheets(drawn, {}, limited({}, kPatternLimit)); });
  count(counts, outcome);
  const std::vector<double>& bends = outcome.bends;
  const auto bent = std::count_if(bends.begin(), bends.end(), [](double bend) { return bend > 0; });
  const bool cut = !bends.empty();
  table.row({name, drawn.num_vertices(), make_linkage(drawn).num_hinges(), drawn.num_faces(),
             settled_by(drawn, outcome), cut ? nlohmann::json(bent) : nlohmann::json(),
             cut ? nlohmann::json(degrees(*std::max_element(bends.begin(), bends.end()))) : nlohmann::json(),
             outcome.motions.empty() ? 0.0 : 100 * outcome.progress, outcome.proven() ? "proven" : "-", time,
             fmt::format("{}", fmt::join(outcome.notes, "; "))});
}

void refused_row(Table& table, const std::string& name, const InvalidInput& error) {
  table.row({name, {}, {}, {}, {}, {}, {}, 0.0, "-", {}, fmt::format("{}: {}", error.code(), error.what())});
}

}  // namespace

int drawn_patterns(const std::string& folder) {
  Table table("Crease patterns as people drew them, as far as each folds",
              {"pattern", "vertices", "creases", "panels", "settled", "bent", "bend deg", "% of way", "proof", "s",
               "what was done, or why not"});
  DrawnCounts counts;
  for (const std::filesystem::path& file : pattern_files(folder)) {
    const std::string name = file.filename().string();
    ++counts.files;
    try {
      const PatternFile pattern = read_pattern(bytes_of(file), name);
      ++counts.read;
      pattern_row(table, name, pattern.file.net.sheet, counts);
    } catch (const InvalidInput& error) {
      refused_row(table, name, error);
    }
  }
  Table sums("Patterns that get so far, proven", {"patterns", "read", "to the goal", "half", "30 %"});
  sums.row({std::to_string(counts.files), counts.read, counts.goal, counts.half, counts.third});
  return 0;
}

}  // namespace plico::bench
