#include "plico/origami/named_patterns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "plico/base/error.h"
#include "plico/origami/bases.h"
#include "plico/origami/kirigami.h"
#include "plico/origami/patterns.h"

namespace plico {
namespace {

constexpr int kMaxSide = 1000;  // columns or rows

struct Entry {
  NamedPattern pattern;
  std::function<CreasePattern(const PatternOptions&)> make;
};

double or_else(double value, double fallback) { return std::isnan(value) ? fallback : value; }

Entry base(const char* name, const char* description, CreasePattern (*make)()) {
  return {{name, description}, [make](const PatternOptions&) { return make(); }};
}

CreasePattern make_miura(const PatternOptions& o) {
  const MiuraOptions usual;
  return miura({.columns = o.columns,
                .rows = o.rows,
                .sector = or_else(o.sector, usual.sector),
                .zigzag_angle = or_else(o.angle, usual.zigzag_angle),
                .facet_diagonals = o.diagonals});
}

// A sheet of n columns becomes a tube at 66.8 degrees for n = 10, 49.3 for 12, 24.0 for 22; n times the angle falls
// towards 505. A tenth less is free.
double usual_waterbomb_angle(int columns) { return radians(std::min(45.0, 450.0 / columns)); }

CreasePattern make_waterbomb(const PatternOptions& o) {
  return waterbomb({.columns = o.columns,
                    .rows = o.rows,
                    .diagonal_angle = or_else(o.angle, usual_waterbomb_angle(o.columns)),
                    .facet_horizontals = o.diagonals});
}

CreasePattern make_yoshimura(const PatternOptions& o) {
  const double sector = or_else(o.sector, YoshimuraOptions().sector);
  return yoshimura({.columns = o.columns,
                    .rows = o.rows,
                    .sector = sector,
                    .diagonal_angle = or_else(o.angle, 0.9 * yoshimura_tube_angle(o.columns, sector))});
}

CreasePattern make_honeycomb(const PatternOptions& o) {
  return honeycomb(
      {.columns = o.columns, .rows = o.rows, .wall_angle = or_else(o.angle, HoneycombOptions().wall_angle)});
}

CreasePattern make_rotating_squares(const PatternOptions& o) {
  return rotating_squares(
      {.columns = o.columns, .rows = o.rows, .middle_angle = or_else(o.angle, RotatingSquaresOptions().middle_angle)});
}

CreasePattern make_pop_up(const PatternOptions& o) { return pop_up(or_else(o.angle, kPi / 2)); }

std::vector<Entry> make_entries() {
  return {
      {{"miura", "parallelograms that fold flat all at once, in one way", true, true, "zigzag creases",
        "across every parallelogram", 5, 5},
       make_miura},
      {{"waterbomb", "squares with diagonals that roll up into a tube; columns and rows are even", true, false,
        "diagonals", "along the lines of the centres", 4, 6},
       make_waterbomb},
      {{"yoshimura", "lines of triangles that roll up into a tube", true, true, "diagonals", "", 6, 4}, make_yoshimura},
      base("l", "a strip of three squares: two creases, nothing inside", l),
      base("l2", "two crossing lines, folded one after the other", l2),
      base("waterbomb-base", "eight creases around one vertex", waterbomb_base),
      base("diamond", "six creases around one vertex, all folded flat", diamond),
      base("plane", "five creases around one vertex: the nose of a paper plane", plane),
      base("box1", "a box corner with its fourth quarter tucked in", box1),
      base("box2", "two box corners side by side", box2),
      base("fly1", "the waterbomb base seen from behind", fly1),
      base("fly2", "the same with one corner tucked", fly2),
      base("sailboat", "the dissertation's largest base: 32 creases, 13 vertices, folded flat", sailboat),
      base("letter", "folded in three, then bent: only one fold after the other gets there", letter),
      {{"honeycomb", "kirigami: strips between slits that close to hexagons", true, false, "walls of the hexagons", "",
        3, 4},
       make_honeycomb},
      {{"rotating-squares", "kirigami: squares that turn in their plane as the gussets between them fold", true, false,
        "creases in the middle of the gussets", "", 5, 5},
       make_rotating_squares},
      {{"pop-up", "kirigami: a card with three boxes between slits", false, false, "creases", "", 0, 0}, make_pop_up},
      base("square-twist", "folds flat, but no rigid motion leads there", square_twist),
  };
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = make_entries();
  return all;
}

void refuse(bool given, const NamedPattern& pattern, const char* what) {
  if (given) throw InvalidOption(fmt::format("{} has no {}", pattern.name, what), "plico origami make --list");
}

void check_size(const PatternOptions& o, const NamedPattern& pattern) {
  if (o.columns >= 1 && o.rows >= 1 && o.columns <= kMaxSide && o.rows <= kMaxSide) return;
  throw InvalidOption(
      fmt::format("{} columns and {} rows must be in [1, {}]", o.columns, o.rows, kMaxSide),
      fmt::format("plico origami make {} --size {}x{}", pattern.name, pattern.usual_columns, pattern.usual_rows));
}

}  // namespace

const std::vector<NamedPattern>& named_patterns() {
  static const std::vector<NamedPattern> all = [] {
    std::vector<NamedPattern> patterns;
    for (const Entry& entry : entries()) patterns.push_back(entry.pattern);
    return patterns;
  }();
  return all;
}

CreasePattern make_pattern(std::string_view name, const PatternOptions& options) {
  const auto& all = entries();
  const auto entry = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.pattern.name == name; });
  if (entry == all.end())
    throw InvalidOption(fmt::format("there is no crease pattern called {}", name), "plico origami make --list");
  const NamedPattern& pattern = entry->pattern;
  const bool sized = options.columns != 0 || options.rows != 0;
  refuse(sized && !pattern.has_size, pattern, "size to choose");
  refuse(!std::isnan(options.sector) && !pattern.has_sector, pattern, "sector angle to choose");
  refuse(!std::isnan(options.angle) && pattern.angle.empty(), pattern, "fold angle to choose");
  refuse(options.diagonals && pattern.diagonals.empty(), pattern, "flat creases to add");
  PatternOptions filled = options;
  if (!sized) {
    filled.columns = pattern.usual_columns;
    filled.rows = pattern.usual_rows;
  }
  if (pattern.has_size) check_size(filled, pattern);
  return entry->make(filled);
}

}  // namespace plico
