// plico origami: crease patterns made by the program itself, and the facts about any crease pattern.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/origami/closure.h"
#include "plico/origami/named_patterns.h"
#include "plico/origami/pattern_check.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/suggest.h"

namespace plico::jobs {
namespace {

constexpr int kShownOfAKind = 20;
constexpr int kMaxHingesForMotions = 3000;  // counting first-order motions takes up to a second there
constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

// --- make

struct MakeArgs {
  std::string name, size;
  bool list = false;
  double cell_mm = kNotGiven;
  PatternOptions pattern;
};

int list_patterns(Session& session) {
  nlohmann::json patterns = nlohmann::json::array();
  for (const NamedPattern& pattern : named_patterns()) {
    const std::string size =
        pattern.has_size ? fmt::format("; --size {}x{} unless told", pattern.usual_columns, pattern.usual_rows) : "";
    patterns.push_back({{"name", pattern.name},
                        {"description", pattern.description},
                        {"has_size", pattern.has_size},
                        {"has_sector", pattern.has_sector},
                        {"angle_of", pattern.angle},
                        {"diagonals", pattern.diagonals}});
    session.print(fmt::format("{:<18}{}{}\n", pattern.name, pattern.description, size));
  }
  session.report()["patterns"] = std::move(patterns);
  return kDone;
}

// "24x12": columns and rows.
void read_size(const std::string& text, PatternOptions& pattern) {
  const char* const end = text.data() + text.size();
  const auto columns = std::from_chars(text.data(), end, pattern.columns);
  const bool crossed = columns.ec == std::errc() && columns.ptr != end && (*columns.ptr == 'x' || *columns.ptr == 'X');
  const auto rows = std::from_chars(crossed ? columns.ptr + 1 : end, end, pattern.rows);
  if (!crossed || rows.ec != std::errc() || rows.ptr != end || pattern.columns < 1 || pattern.rows < 1)
    throw InvalidOption(fmt::format("--size {} must be columns and rows, both at least 1", text), "--size 24x12");
}

void check_name(const std::string& name) {
  if (name.empty()) throw InvalidOption("which pattern?", "plico origami make --list");
  std::vector<std::string> names;
  for (const NamedPattern& pattern : named_patterns()) names.push_back(pattern.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InvalidOption(
      fmt::format("there is no crease pattern called {}{}", name, did_you_mean(nearest_word(name, names))),
      "plico origami make --list");
}

void check_output(const std::string& path) {
  if (path != "-" && !path.ends_with(".fold"))
    throw InvalidOption(fmt::format("{} does not end in .fold", path), "plico print draws a crease pattern on pages");
}

int write_pattern(const MakeArgs& args, Session& session) {
  check_name(args.name);
  PatternOptions options = args.pattern;
  if (!args.size.empty()) read_size(args.size, options);
  const bool sized = !std::isnan(args.cell_mm);
  if (sized && !(args.cell_mm > 0)) throw InvalidOption(fmt::format("--cell {:g} must be above 0", args.cell_mm));
  const std::vector<std::string> outputs = session.outputs(args.name + ".fold");
  for (const std::string& path : outputs) check_output(path);

  FoldFile file = fold_file(make_pattern(args.name, options));
  CreasePattern& sheet = file.net.sheet;
  if (sized) {
    for (Vec2& vertex : sheet.vertices) vertex *= args.cell_mm;
    file.unit = "mm";
  }
  write_fold_files(file, outputs, session);

  const int creases = make_linkage(sheet).num_hinges();
  const int real_vertices = static_cast<int>(vertex_facts(sheet).size());
  session.report()["pattern"] = args.name;
  session.report()["vertices"] = sheet.num_vertices();
  session.report()["creases"] = creases;
  session.report()["panels"] = sheet.num_faces();
  session.report()["real_vertices"] = real_vertices;
  session.say(
      fmt::format("{}: {} real vertices, {} creases, {} panels", args.name, real_vertices, creases, sheet.num_faces()));
  return kDone;
}

// --- info

struct InfoArgs {
  std::string file;
  bool strict = false;
  PatternCheckOptions check;
  DrawingOptions drawing;
};

struct PatternFacts {
  explicit PatternFacts(const CreasePattern& sheet)
      : vertices(vertex_facts(sheet)), creases(make_linkage(sheet).num_hinges()) {
    for (const Vec2& p : sheet.vertices) box.extend(p);
    for (const Crease& edge : sheet.edges) {
      ++assigned[edge.assignment];
      largest_goal = std::max(largest_goal, std::abs(edge.fold_angle));
    }
    for (const VertexFacts& vertex : vertices) ++degrees_of[static_cast<int>(vertex.edges.size())];
    const std::vector<RealVertex> loops = real_vertices(sheet);
    const Closure closed = closure(loops, goal(make_linkage(sheet)));
    worst_residual = closed.worst;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (worst_loop < 0 || closed.residual[i] > closed.residual[worst_loop]) worst_loop = static_cast<int>(i);
      if (loops[i].is_hole()) holes.push_back({loops[i], closed.residual[i]});
    }
    if (worst_loop >= 0) worst_place = tell_loop(loops[worst_loop]);
    if (creases <= kMaxHingesForMotions) first_order_motions = num_first_order_motions(sheet);
  }

  int count(Assignment assignment) const {
    const auto found = assigned.find(assignment);
    return found == assigned.end() ? 0 : found->second;
  }

  static std::string tell_loop(const RealVertex& loop) {
    return fmt::format("{} {}", loop.is_hole() ? "around the hole at vertex" : "at vertex", loop.vertex);
  }

  struct Hole {
    RealVertex loop;
    double residual;
  };

  std::vector<VertexFacts> vertices;
  std::vector<Hole> holes;  // and slits, that creases lead to
  int creases;
  Eigen::AlignedBox2d box;
  std::map<Assignment, int> assigned;
  std::map<int, int> degrees_of;  // how many real vertices have this many creases
  double largest_goal = 0, worst_residual = 0;
  int worst_loop = -1;
  std::string worst_place;
  int first_order_motions = -1;  // -1: not counted
};

std::vector<double> in_degrees(std::vector<double> angles) {
  for (double& angle : angles) angle = degrees(angle);
  return angles;
}

nlohmann::json to_json(const CreasePattern& sheet, const VertexFacts& facts) {
  const Vec2& p = sheet.vertices[facts.vertex];
  return {{"vertex", facts.vertex},
          {"at", {p.x(), p.y()}},
          {"edges", facts.edges},
          {"sectors_deg", in_degrees(facts.sectors)},
          {"mountains", facts.mountains},
          {"valleys", facts.valleys},
          {"flat_folded", facts.flat_folded},
          {"kawasaki_deg", degrees(facts.kawasaki)},
          {"residual", facts.residual}};
}

nlohmann::json to_json(const PatternReport& report) {
  nlohmann::json list = nlohmann::json::array();
  for (const PatternProblem& problem : report.problems)
    list.push_back({{"severity", name(problem.severity)},
                    {"code", problem.code},
                    {"message", problem.message},
                    {"where", problem.where},
                    {"suggestion", problem.suggestion},
                    {"edges", problem.edges},
                    {"vertices", problem.vertices}});
  return list;
}

void fill_report(nlohmann::json& report, const FoldFile& file, const PatternFacts& facts) {
  const CreasePattern& sheet = file.net.sheet;
  const Vec2 size = facts.box.sizes();
  report["creases"] = facts.creases;
  report["assignments"] = {{"mountain", facts.count(Assignment::Mountain)},
                           {"valley", facts.count(Assignment::Valley)},
                           {"flat", facts.count(Assignment::Flat)},
                           {"unassigned", facts.count(Assignment::Unassigned)},
                           {"boundary", facts.count(Assignment::Boundary)}};
  report["size"] = {size.x(), size.y()};
  report["unit"] = file.unit;
  report["largest_goal_deg"] = degrees(facts.largest_goal);
  report["goal_residual"] = facts.worst_residual;
  report["first_order_motions"] =
      facts.first_order_motions < 0 ? nlohmann::json(nullptr) : nlohmann::json(facts.first_order_motions);
  nlohmann::json& vertices = report["real_vertices"] = nlohmann::json::array();
  for (const VertexFacts& vertex : facts.vertices) vertices.push_back(to_json(sheet, vertex));
  nlohmann::json& holes = report["holes"] = nlohmann::json::array();
  for (const auto& [loop, residual] : facts.holes)
    holes.push_back({{"vertex", loop.vertex},
                     {"at", {loop.place.x(), loop.place.y()}},
                     {"creases", loop.hinges.size()},
                     {"residual", residual}});
}

std::string degrees_text(const PatternFacts& facts) {
  std::string text;
  for (const auto& [degree, count] : facts.degrees_of)
    text += fmt::format("{}{} of degree {}", text.empty() ? "" : ", ", count, degree);
  return facts.vertices.empty() ? "0" : fmt::format("{}: {}", facts.vertices.size(), text);
}

std::string holes_text(const PatternFacts& facts) {
  std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const auto& [loop, residual] : facts.holes) {
    least = std::min(least, loop.hinges.size());
    most = std::max(most, loop.hinges.size());
  }
  const std::string creases = least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
  return fmt::format("{}, holes and slits, with {} crease{} around each", facts.holes.size(), creases,
                     most == 1 ? "" : "s");
}

std::string closing_text(const PatternFacts& facts) {
  if (facts.worst_loop < 0) return "nothing to close";
  return fmt::format("closes to {:.2g} rad, worst {}", facts.worst_residual, facts.worst_place);
}

std::string human(const FoldFile& file, const PatternFacts& facts) {
  std::string out;
  const auto line = [&](const char* what, const std::string& value) { out += fmt::format("{:<16}{}\n", what, value); };
  const Vec2 size = facts.box.sizes();
  line("real vertices", degrees_text(facts));
  if (!facts.holes.empty()) line("loops", holes_text(facts));
  line("creases", fmt::format("{} mountain, {} valley, {} flat, {} unassigned", facts.count(Assignment::Mountain),
                              facts.count(Assignment::Valley), facts.count(Assignment::Flat),
                              facts.count(Assignment::Unassigned)));
  line("sheet", fmt::format("{:.6g} x {:.6g} {}", size.x(), size.y(), file.unit));
  line("goal", fmt::format("folds up to {:.6g} degrees, {}", degrees(facts.largest_goal), closing_text(facts)));
  if (facts.first_order_motions >= 0)
    line("first motions",
         fmt::format("{} of {} creases, to first order from flat", facts.first_order_motions, facts.creases));
  return out;
}

std::string vertex_line(const CreasePattern& sheet, const VertexFacts& facts) {
  const Vec2& p = sheet.vertices[facts.vertex];
  return fmt::format("vertex {} at {:.6g} {:.6g}: {} mountain, {} valley, sectors {:.6g} degrees, closes to {:.2g} rad",
                     facts.vertex, p.x(), p.y(), facts.mountains, facts.valleys,
                     fmt::join(in_degrees(facts.sectors), " "), facts.residual);
}

// One line a problem, at most kShownOfAKind of a kind.
std::string human(const std::string& path, const PatternReport& report) {
  std::string out;
  std::map<std::string, int> shown;
  for (const PatternProblem& problem : report.problems) {
    if (++shown[problem.code] > kShownOfAKind) continue;
    out += fmt::format("{}: {}: {} [{}] {}{}{}\n", path, name(problem.severity), problem.message, problem.code,
                       problem.where, problem.suggestion.empty() ? "" : "; ", problem.suggestion);
  }
  for (const auto& [code, count] : shown)
    if (count > kShownOfAKind) out += fmt::format("{} more of [{}]; --json lists all\n", count - kShownOfAKind, code);
  return out;
}

std::string verdict(const PatternReport& report) {
  const int errors = report.count(Severity::Error), warnings = report.count(Severity::Warning);
  const char* word = errors > 0 ? "cannot be used" : warnings > 0 ? "cannot fold as it says" : "fine";
  return fmt::format("{} ({} error{}, {} warning{})", word, errors, errors == 1 ? "" : "s", warnings,
                     warnings == 1 ? "" : "s");
}

int tell_facts(const InfoArgs& args, Session& session) {
  const FoldFile file = read_sheet(args.file, session, args.drawing);
  const CreasePattern& sheet = file.net.sheet;
  const PatternReport checks = check_pattern(sheet, args.check);
  session.report()["vertices"] = sheet.num_vertices();
  session.report()["edges"] = sheet.num_edges();
  session.report()["panels"] = sheet.num_faces();
  session.report()["usable"] = checks.usable();
  session.report()["problems"] = to_json(checks);
  session.print(fmt::format("{}: {} vertices, {} edges, {} panels\n", args.file, sheet.num_vertices(),
                            sheet.num_edges(), sheet.num_faces()));
  if (checks.usable()) {  // the facts are about a plane drawing
    const PatternFacts facts(sheet);
    fill_report(session.report(), file, facts);
    session.print(human(file, facts));
    for (const VertexFacts& vertex : facts.vertices) session.detail(vertex_line(sheet, vertex));
    for (const auto& [loop, residual] : facts.holes)
      session.detail(fmt::format("hole at vertex {} at {:.6g} {:.6g}: {} creases around it, closes to {:.2g}",
                                 loop.vertex, loop.place.x(), loop.place.y(), loop.hinges.size(), residual));
  }
  session.print(human(args.file, checks));
  session.print(fmt::format("{}: {}\n", args.file, verdict(checks)));
  if (checks.usable() && checks.count(Severity::Warning) == 0) return kDone;
  return checks.usable() && !args.strict ? kNo : kBadInput;
}

}  // namespace

Job origami_make_job() {
  const auto args = std::make_shared<MakeArgs>();
  return Job("origami make", "Make a crease pattern to fold: tessellations of any size, bases, a letter")
      .example("plico origami make miura --size 24x24 -o miura.fold", "24 columns and 24 rows of parallelograms")
      .example("plico origami make waterbomb --size 12x6 --angle 40deg -o tube.fold",
               "its diagonals fold by 40 degrees")
      .example("plico origami make miura --sector 70deg --cell 2cm -o map.fold", "panels 2 cm wide, to print and fold")
      .example("plico origami make --list", "all names")
      .positional("name", "of the pattern; --list shows all", args->name, false)
      .flag("--list", "show the name of every pattern", args->list)
      .option("--size", "CxR", "columns and rows of a tessellation", args->size)
      .angle("--angle", "goal of the zigzag creases (miura) or of the diagonals (waterbomb, yoshimura)",
             args->pattern.angle, {0, 180})
      .angle("--sector", "acute angle of the panels (miura, yoshimura)", args->pattern.sector, {0, 90, false, false})
      .length("--cell", "what one unit of the pattern measures: a column of a tessellation; the file is in mm then",
              args->cell_mm, above(0))
      .flag("--diagonals", "add the flat creases that cut panels in two (miura, waterbomb)", args->pattern.diagonals)
      .action([args](Session& session) { return args->list ? list_patterns(session) : write_pattern(*args, session); });
}

Job origami_info_job() {
  const auto args = std::make_shared<InfoArgs>();
  Job job = Job("origami info", "Tell the facts about a crease pattern, and all that is wrong with it")
                .example("plico origami info miura.fold",
                         "counts, size, whether the goal closes, every problem with its place")
                .example("plico origami info miura.fold -v", "also the sector angles around every real vertex")
                .example("plico origami info miura.fold --json", "the same for programs")
                .positional("PATTERN", "FOLD, .cp, .opx, .ori or SVG file; - is standard input", args->file)
                .flag("--strict", "warnings count as errors", args->strict)
                .angle("--tolerance", "how far sectors and the goal's loops may be off", args->check.angle, above(0))
                .action([args](Session& session) { return tell_facts(*args, session); });
  add_drawing_options(job, args->drawing);
  return job;
}

}  // namespace plico::jobs
