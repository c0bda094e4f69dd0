// plico print: a net as pages to print and files to cut.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "plico/base/error.h"
#include "plico/base/version.h"
#include "plico/fabricate/fabricate.h"
#include "plico/io/drawing.h"
#include "plico/io/dxf.h"
#include "plico/io/file.h"
#include "plico/io/fold.h"
#include "plico/io/pdf.h"
#include "plico/io/svg.h"
#include "plico/verify/sheet.h"
#include "session.h"

namespace plico::cli {
namespace {

struct PrintArgs {
  std::string net, page = "A4", up = "y", tabs = "auto", style = "paper", title;
  double scale = std::numeric_limits<double>::quiet_NaN();
  double tab_width = 5, tab_angle = radians(45), gap = 3, margin = 10, flat = radians(0.5), label_size = 7;
  SizeOptions size;
  std::vector<std::string> marks;
  bool landscape = false, split = false, no_labels = false, show_flat_creases = false;
};

TabSide tab_side(const std::string& word) {
  constexpr std::pair<std::string_view, TabSide> kSides[] = {
      {"auto", TabSide::Auto},    {"alternate", TabSide::Alternate}, {"left", TabSide::First},
      {"right", TabSide::Second}, {"both", TabSide::Both},           {"none", TabSide::None}};
  return std::ranges::find(kSides, word, &std::pair<std::string_view, TabSide>::first)->second;
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

SheetOptions sheet_options(const PrintArgs& args) {
  SheetOptions options;
  options.size = args.size;
  options.size.up = args.up[0];
  options.size.scale = args.scale;
  options.page = {paper_size(args.page), args.margin};
  if (args.landscape != (options.page.size.x() > options.page.size.y()) && args.landscape)
    std::swap(options.page.size.x(), options.page.size.y());
  options.place.gap = args.gap;
  options.tabs.side = tab_side(args.tabs);
  options.tabs.depth = args.tab_width;
  options.tabs.angle = args.tab_angle;
  options.labels.edge_ids = options.labels.part_names = !args.no_labels;
  options.labels.size_pt = args.label_size;
  options.labels.smallest_pt = std::min(4.0, args.label_size);
  options.marks = mark_options(args.marks);
  options.split = args.split;
  options.flat = args.flat;
  return options;
}

// What the file knows about the finished model; a file without a folded form has only its flat size.
FoldedShape shape_of(FoldFile& file) {
  if (!file.folded.empty() && !file.net.mesh_face.empty() && !file.net.mesh_vertex.empty()) {
    const Mesh mesh = folded_mesh(file);
    attach_mesh(file.net, mesh);
    return folded_shape(mesh);
  }
  FoldedShape shape;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : file.folded) box.extend(p);
  for (const Vec2& p : file.net.sheet.vertices)
    if (file.folded.empty()) box.extend(Vec3(p.x(), p.y(), 0));
  if (!box.isEmpty()) shape.size = box.sizes();
  return shape;
}

nlohmann::json json_of(const SheetReport& r) {
  const Tabs& t = r.tabs;
  return {{"pages", r.pages},
          {"parts", r.parts},
          {"fill_ratio", r.fill_ratio},
          {"scale_mm_per_unit", r.scale},
          {"final_size_mm", {r.final_size.x(), r.final_size.y(), r.final_size.z()}},
          {"folds_cut", r.folds_cut},
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

std::string human(const SheetReport& r) {
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
  if (r.folds_cut > 0) text += fmt::format("{} folds became seams so that the parts fit\n", r.folds_cut);
  if (r.pages_without_ruler > 0) text += fmt::format("{} pages have no room for the ruler\n", r.pages_without_ruler);
  return text;
}

// "bunny.svg" for the only page, "bunny-1.svg", "bunny-2.svg", ... for several.
std::string page_path(const std::string& path, std::size_t page, std::size_t num_pages) {
  if (num_pages == 1) return path;
  const std::size_t dot = path.size() - extension(path).size() - 1;
  return fmt::format("{}-{}{}", path.substr(0, dot), page + 1, path.substr(dot));
}

void require_kind(const std::string& path) {
  const std::string kind = extension(path);
  if (path != "-" && kind != "pdf" && kind != "svg" && kind != "dxf")
    throw InvalidOption(fmt::format("'{}' is no kind of page that print writes", path), "use .pdf, .svg or .dxf");
}

void write_pages(Session& session, const std::string& path, const std::vector<Drawing>& pages,
                 const std::string& title) {
  const std::string kind = extension(path);
  if (path == "-" || kind == "pdf") {
    session.write(path, write_pdf(pages, title, fmt::format("plico {}", plico::version())));
    return;
  }
  for (std::size_t i = 0; i < pages.size(); ++i)
    session.write(page_path(path, i, pages.size()), kind == "svg" ? write_svg(pages[i]) : write_dxf(pages[i]));
}

std::string stem(const std::string& path) {
  if (path == "-") return "net";
  const std::size_t slash = path.find_last_of('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.find_last_of('.'));
}

int print(const PrintArgs& args, Session& session) {
  const SheetOptions options = sheet_options(args);
  const std::string name = stem(args.net);
  const std::vector<std::string> outputs = session.outputs(name + ".pdf");
  for (const std::string& path : outputs) require_kind(path);
  FoldFile file = read_fold(session.read(args.net), args.net);
  const SheetResult result = make_sheet(file.net, shape_of(file), options, session.run());
  const SheetVerdict verdict = verify_sheet(result.sheet);
  session.report()["print"] = json_of(result.report);
  session.report()["print"]["overlaps"] = verdict.overlaps;
  const DrawOptions how{draw_style(args.style), args.show_flat_creases, args.title.empty() ? name : args.title};
  const std::vector<Drawing> pages = draw(result.sheet, how);
  for (const std::string& path : outputs) write_pages(session, path, pages, how.title);
  session.print(human(result.report));
  for (const std::string& problem : verdict.problems) session.warn(problem);
  return verdict.sound() ? kDone : kNo;
}

}  // namespace

Command print_command() {
  auto args = std::make_shared<PrintArgs>();
  Command command("print", "Lay out a net on pages with glue tabs and edge ids, as PDF, SVG or DXF");
  command.example("plico print bird.fold --height 150mm", "bird.pdf on A4, the finished bird 150 mm tall")
      .example("plico print bird.fold --page Letter -o bird.pdf -o bird.svg -o bird.dxf", "one layout in three formats")
      .example("plico print bird.fold --longest 40cm --split --marks start,seam",
               "a large model for a class: parts cut to fit, marks to build by")
      .positional("net", "FOLD file of a net; '-' is standard input", args->net)
      .length("--height", "height of the finished model, along --up", args->size.height)
      .length("--width", "width of the finished model, along x", args->size.width)
      .length("--longest", "longest side of the finished model", args->size.longest)
      .option("--scale", "K", "millimetres per unit of the model", args->scale)
      .choice("--up", "axis of the height", args->up, {"y", "z"})
      .option("--page", "SIZE", "A5, A4, A3, A2, Letter, Legal, Tabloid or WIDTHxHEIGHT", args->page)
      .flag("--landscape", "turn the page", args->landscape)
      .length("--margin", "left free around each page", args->margin)
      .length("--gap", "between parts", args->gap)
      .flag("--split", "cut parts that are too large for a page along folds", args->split)
      .choice("--tabs", "which side of a seam has the tab", args->tabs,
              {"auto", "alternate", "left", "right", "both", "none"})
      .length("--tab-width", "depth of the tabs", args->tab_width)
      .angle("--tab-angle", "slant of the tabs", args->tab_angle)
      .flag("--no-labels", "leave out edge ids and part names", args->no_labels)
      .option("--label-size", "POINTS", "size of edge ids, made smaller down to 4 where needed", args->label_size)
      .option("--marks", "LIST", "start: a square where to begin; seam: strokes that meet; or both", args->marks)
      .choice("--style", "colours and line weights", args->style, {"paper", "origami", "laser", "bw"})
      .angle("--flat", "folds up to this angle count as flat and are hidden", args->flat)
      .flag("--show-flat-creases", "draw them all the same", args->show_flat_creases)
      .option("--title", "TEXT", "name beside the legend; default the file's", args->title)
      .action([args](Session& session) { return print(*args, session); });
  return command;
}

}  // namespace plico::cli
