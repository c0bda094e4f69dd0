#include "plico/workflow/jobs/print_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/mesh/upright.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {
namespace {

TabSide tab_side(const std::string& word) {
  constexpr std::pair<std::string_view, TabSide> kSides[] = {
      {"auto", TabSide::Auto},    {"alternate", TabSide::Alternate}, {"left", TabSide::First},
      {"right", TabSide::Second}, {"both", TabSide::Both},           {"none", TabSide::None}};
  return std::ranges::find(kSides, word, &std::pair<std::string_view, TabSide>::first)->second;
}

// What a machine asks for. Mats and beds are those most sold; cutters hold the mat by its border.
struct Machine {
  std::string_view name, page, margin, style, text, perforation;
  bool key;  // ruler and legend
};
constexpr Machine kMachines[] = {{"printer", "A4", "10mm", "paper", "text", "0", true},
                                 {"cricut", "mat-12x12", "7mm", "laser", "outlines", "2mm,1mm", false},
                                 {"silhouette", "mat-12x12", "10mm", "laser", "outlines", "2mm,1mm", false},
                                 {"laser", "600x400mm", "5mm", "laser", "outlines", "0", false},
                                 {"plotter", "A3", "15mm", "laser", "outlines", "0", false}};

const Machine& machine(const PrintArgs& args) { return *std::ranges::find(kMachines, args.machine, &Machine::name); }

Perforation perforation(const std::string& text) {
  if (text == "0") return {};
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw InvalidOption(fmt::format("--perforation: '{}' is not CUT,GAP, as 2mm,1mm", text));
  return {parse_length_mm(text.substr(0, comma)), parse_length_mm(text.substr(comma + 1))};
}

std::string or_else(const std::string& given, std::string_view otherwise) {
  return given.empty() || given == "auto" ? std::string(otherwise) : given;
}

DrawStyle draw_style(const std::string& word) {
  if (word == "origami") return DrawStyle::Origami;
  if (word == "laser") return DrawStyle::Laser;
  return word == "bw" ? DrawStyle::Bw : DrawStyle::Paper;
}

MarkOptions mark_options(const std::vector<std::string>& given) {
  MarkOptions marks;
  for (const std::string& list : given) {
    for (std::size_t from = 0; from <= list.size();) {
      const std::size_t comma = std::min(list.find(',', from), list.size());
      const std::string word = list.substr(from, comma - from);
      if (word != "start" && word != "seam")
        throw InvalidOption(fmt::format("--marks: '{}' is not one of start, seam", word));
      (word == "start" ? marks.start : marks.seam) = true;
      from = comma + 1;
    }
  }
  return marks;
}

WeakFolds weak_folds_wish(const std::string& name) {
  return name == "cut" ? WeakFolds::Cut : name == "keep" ? WeakFolds::Keep : WeakFolds::CutFew;
}

}  // namespace

void add_print_options(Job& job, PrintArgs& args) {
  job.length("--height", "height of the finished model, along --up", args.size.height, above(0))
      .length("--width", "width of the finished model, along x", args.size.width, above(0))
      .length("--longest", "longest side of the finished model; without any size, as large as fits one page a part",
              args.size.longest, above(0))
      .option("--scale", "K", "millimetres per unit of the model", args.scale, above(0))
      .choice("--unit", "what one unit of the model measures, printed in its true size; none: not known", args.unit,
              {"none", "mm", "cm", "m", "in"})
      .choice("--up", "axis of the height; auto: guessed from the shape and told", args.up, {"auto", "y", "z"})
      .choice("--for",
              "who works on the pages: sets page, margin, style, text, perforation, ruler and legend, each of "
              "which its own option overrules",
              args.machine, {"printer", "cricut", "silhouette", "laser", "plotter"})
      .option("--page", "SIZE",
              "A0 to A8, B0 to B8, Letter, Legal, Tabloid, ... or WIDTHxHEIGHT; default A4, or the "
              "mat of --for",
              args.page)
      .flag("--landscape", "turn the page", args.landscape)
      .option("--margin", "LENGTHS", "left free around each page; or top,right,bottom,left; default 10mm", args.margin)
      .length("--gap", "between parts", args.gap, {0, 100})
      .flag("--split", "cut parts that are too large for a page along folds", args.split)
      .choice("--weak-folds",
              "folds under 5 mm that carry a branch of more than three panels are kept, or cut so that it is glued; "
              "auto: cut where parts may be split and such folds are few",
              args.weak_folds, {"auto", "keep", "cut"})
      .choice("--tabs", "which side of a seam has the tab", args.tabs,
              {"auto", "alternate", "left", "right", "both", "none"})
      .length("--tab-width", "depth of the tabs", args.tab_width, {1, 50})
      .angle("--tab-angle", "slant of the tabs", args.tab_angle, {20, 80})
      .flag("--no-labels", "leave out edge ids and part names", args.no_labels)
      .option("--label-size", "POINTS",
              "size of edge ids, made smaller down to 5 where needed, and to 4 where there is no other way",
              args.label_size, {3, 24})
      .option("--marks", "LIST", "start: a square where to begin; seam: strokes that meet; or both", args.marks)
      .choice("--style", "colours and line weights", args.style, {"auto", "paper", "origami", "laser", "bw"})
      .choice("--text", "letters as text, as outlines to draw or engrave, or none", args.text,
              {"auto", "text", "outlines", "none"})
      .option("--perforation", "CUT,GAP", "folds as rows of cuts with paper between them, as 2mm,1mm; 0: lines",
              args.perforation)
      .choice("--side", "of the paper that is printed; both: cuts and folds outside, ids and marks inside, in register",
              args.side, {"outside", "inside", "both"})
      .choice("--joint",
              "where facets of two pieces meet: marks to glue them, marks with a hole for a paper rivet so that they "
              "turn, or nothing",
              args.joint, {"glue", "rivet", "none"})
      .flag("--no-color", "do not print the colours and pictures of the model", args.no_color)
      .flag("--shadow-tabs", "draw where each tab lands on the panel it is glued under", args.shadow_tabs)
      .flag("--one-svg", "all pages in one SVG, beside each other, which Inkscape takes for pages", args.one_svg)
      .flag("--no-ruler", "leave out the ruler", args.no_ruler)
      .flag("--no-legend", "leave out the legend", args.no_legend)
      .angle("--flat", "folds up to this angle count as flat and are hidden", args.flat, {0, 90})
      .flag("--show-flat-creases", "draw them all the same", args.show_flat_creases)
      .option("--title", "TEXT", "name beside the legend; default the file's", args.title);
}

LayoutOptions layout_options(const PrintArgs& args) {
  LayoutOptions options;
  options.size = args.size;
  options.size.up = args.up == "z" ? 'z' : 'y';
  options.size.scale = args.scale;
  if (args.unit != "none") {
    if (options.size.is_given())
      throw InvalidOption(fmt::format("--unit {} is the true size, and another size is given", args.unit),
                          "leave one of them out");
    options.size.scale = millimetres_per(args.unit);
  }
  const Machine& by = machine(args);
  options.page = {paper_size(or_else(args.page, by.page)), parse_margins(or_else(args.margin, by.margin))};
  if (args.landscape != (options.page.size.x() > options.page.size.y()) && args.landscape)
    std::swap(options.page.size.x(), options.page.size.y());
  options.place.gap = args.gap;
  const bool legend = by.key && !args.no_legend, ruler = by.key && !args.no_ruler;
  options.place.key = legend ? KeyWish::All : ruler ? KeyWish::Ruler : KeyWish::None;
  options.tabs.side = tab_side(args.tabs);
  options.tabs.depth = args.tab_width;
  options.tabs.angle = args.tab_angle;
  options.labels.edge_ids = options.labels.part_names = !args.no_labels;
  options.labels.size_pt = args.label_size;
  options.labels.smallest_pt = std::min(4.0, args.label_size);
  options.marks = mark_options(args.marks);
  options.joint = args.joint == "rivet" ? JointKind::Rivet : args.joint == "none" ? JointKind::None : JointKind::Glue;
  options.split = args.split;
  options.weak_folds = weak_folds_wish(args.weak_folds);
  options.flat = args.flat;
  return options;
}

DrawOptions draw_options(const PrintArgs& args, const std::string& default_title) {
  const Machine& by = machine(args);
  DrawOptions options{.style = draw_style(or_else(args.style, by.style)),
                      .flat_creases = args.show_flat_creases,
                      .title = args.title.empty() ? default_title : args.title,
                      .perforation = perforation(or_else(args.perforation, by.perforation)),
                      .ruler = !args.no_ruler,
                      .side = args.side == "inside" ? PaperSide::Inside
                              : args.side == "both" ? PaperSide::Both
                                                    : PaperSide::Outside,
                      .color = !args.no_color,
                      .shadow_tabs = args.shadow_tabs};
  const std::string text = or_else(args.text, by.text);
  options.text = text == "none" ? TextForm::None : text == "outlines" ? TextForm::Outlines : TextForm::Text;
  check(options);
  return options;
}

char up_axis(const std::string& wish, const Mesh& mesh, Session& session) {
  if (wish == "y" || wish == "z") return wish[0];
  const char up = guessed_up(mesh);
  session.report()["up"] = std::string(1, up);
  if (up != 'y') session.say(fmt::format("up is {}, by the look of the shape; --up y says otherwise", up));
  return up;
}

nlohmann::json json_of(const LayoutReport& r) {
  const Tabs& t = r.tabs;
  return {{"pages", r.pages},
          {"parts", r.parts},
          {"fill_ratio", r.fill_ratio},
          {"scale_mm_per_unit", r.scale},
          {"final_size_mm", {r.final_size.x(), r.final_size.y(), r.final_size.z()}},
          {"folds_cut", r.folds_cut},
          {"weak_folds_cut", r.weak_folds_cut},
          {"tabs",
           {{"made", t.tabs.size()},
            {"full", t.full},
            {"shrunk", t.shrunk},
            {"moved", t.moved},
            {"omitted", t.omitted},
            {"seams_too_short", t.short_seams}}},
          {"edge_ids", {{"placed", r.labels.placed}, {"leaders", r.labels.leaders}, {"omitted", r.labels.omitted}}},
          {"pages_without_ruler", r.pages_without_ruler}};
}

// "build A, C onto A, B onto C", the first dozen.
std::string build_text(const LayoutReport& r) {
  constexpr std::size_t kMost = 12;
  std::string text = "build";
  for (std::size_t i = 0; i < std::min(kMost, r.steps.size()); ++i) {
    const AssemblyStep& step = r.steps[i];
    text += fmt::format("{} {}", i == 0 ? "" : ",", r.part_names[step.part]);
    if (!step.onto.empty()) text += " onto " + r.part_names[step.onto.front()];
  }
  return text + (r.steps.size() > kMost ? ", ...\n" : "\n");
}

std::string layout_text(const LayoutReport& r) {
  const Vec3& s = r.final_size;
  std::string text =
      fmt::format("{} {} on {} {}, {:.0f} % of the paper used\n", r.parts, r.parts == 1 ? "part" : "parts", r.pages,
                  r.pages == 1 ? "page" : "pages", 100 * r.fill_ratio);
  text += fmt::format("model {:.1f} x {:.1f} x {:.1f} mm ({:.2f} x {:.2f} x {:.2f} in), {:.6g} mm per unit\n", s.x(),
                      s.y(), s.z(), s.x() / 25.4, s.y() / 25.4, s.z() / 25.4, r.scale);
  text += fmt::format("tabs: {} ({} smaller, {} on the other side); seams without: {} no room, {} too short\n",
                      r.tabs.tabs.size(), r.tabs.shrunk, r.tabs.moved, r.tabs.omitted, r.tabs.short_seams);
  text += fmt::format("edge ids: {} at their edge, {} beside it, {} left out\n", r.labels.placed, r.labels.leaders,
                      r.labels.omitted);
  if (!r.steps.empty()) text += build_text(r);
  if (r.folds_cut > 0)
    text += fmt::format("{} so that the parts fit\n",
                        r.folds_cut == 1 ? "1 fold became a seam" : fmt::format("{} folds became seams", r.folds_cut));
  if (r.weak_folds_cut > 0) text += fmt::format("{} short folds with much on them became seams\n", r.weak_folds_cut);
  if (r.joints_without_hole > 0)
    text +=
        fmt::format("{} facets are too small for the hole of a rivet, {:g} mm wide\n", r.joints_without_hole, kRivet);
  if (r.pages_without_ruler > 0) text += fmt::format("{} pages have no room for the ruler\n", r.pages_without_ruler);
  return text;
}

}  // namespace plico::jobs
