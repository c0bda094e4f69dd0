// plico print: a net as pages to print and files to cut.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/fabricate/fabricate.h"
#include "plico/fold/open_slits.h"
#include "plico/io/page/drawing.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/pattern/fold_colors.h"
#include "plico/io/text/file.h"
#include "plico/verify/page_layout.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/page_files.h"
#include "plico/workflow/jobs/print_options.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/kit_joints.h"
#include "plico/workflow/parts_file.h"

namespace plico::jobs {
namespace {

struct NetArgs {
  std::string net;
  PrintArgs print;
  std::vector<std::string> put;
};

// "PANEL,PAGE,X,Y,ANGLE": pages from 1, millimetres, degrees.
PanelPlace panel_place(const std::string& text) {
  std::array<double, 5> numbers{};
  std::size_t from = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const char* const end = text.data() + comma;
    const auto read = std::from_chars(text.data() + from, end, numbers[i]);
    const bool last = i + 1 == numbers.size();
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(numbers[i]) || last != (comma == text.size()) ||
        (i < 2 && (numbers[i] != std::floor(numbers[i]) || std::abs(numbers[i]) > 1e9)))
      throw InvalidOption(fmt::format("--put: '{}' is not PANEL,PAGE,X,Y,ANGLE", text), "--put 17,1,40,120,90");
    from = comma + 1;
  }
  return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]) - 1, Vec2(numbers[2], numbers[3]),
          radians(numbers[4])};
}

nlohmann::json json_of_places(const LayoutReport& report) {
  nlohmann::json places = nlohmann::json::array();
  for (std::size_t p = 0; p < report.places.size(); ++p) {
    const PanelPlace& place = report.places[p];
    places.push_back({{"part", report.part_names[p]},
                      {"page", place.page + 1},
                      {"panel", place.panel},
                      {"x", place.at.x()},
                      {"y", place.at.y()},
                      {"angle_deg", degrees(place.angle)},
                      {"panels", nlohmann::json::array()}});
  }
  for (std::size_t f = 0; f < report.printed_part.size(); ++f) places[report.printed_part[f]]["panels"].push_back(f);
  return places;
}

// What the file knows about the finished model; a file without a folded form has only its flat size.
FoldedShape shape_of(FoldFile& file, const std::optional<PartsClaim>& parts, const NetArgs& args,
                     LayoutOptions& options, Session& session) {
  if (!file.folded.empty() && !file.net.mesh_face.empty() && !file.net.mesh_vertex.empty()) {
    const Mesh mesh = folded_mesh(file);
    attach_mesh(file.net, mesh);
    if (parts) options.joints = joint_facets(mesh, file.net, joints_of(*parts, mesh), parts->pieces, options.titles);
    options.size.up = up_axis(args.print.up, mesh, session);
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

void require_kind(const std::string& path) {
  const std::string kind = extension(path);
  if (path != "-" && kind != "pdf" && kind != "svg" && kind != "dxf")
    throw InvalidOption(fmt::format("'{}' is no kind of page that print writes", path), "use .pdf, .svg or .dxf");
}

std::string stem(const std::string& path) {
  if (path == "-") return "net";
  const std::size_t slash = path.find_last_of('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.find_last_of('.'));
}

// A crease pattern may have cuts with paper on both sides, which are printed as the knife goes: once a side.
void open_slits_of(Unfolding& net) {
  if (!net.mesh_face.empty()) return;  // nets are cut open as they are made
  const int edges = net.sheet.num_edges();
  net.sheet = open_slits(net.sheet);
  if (net.sheet.num_edges() == edges) return;
  net.part = parts_of(net.sheet);
  if (!net.mate.empty()) net.mate.resize(net.sheet.edges.size(), -1);
}

int print(const NetArgs& args, Session& session) {
  LayoutOptions options = layout_options(args.print);
  for (const std::string& text : args.put) options.places.push_back(panel_place(text));
  const std::string name = stem(args.net);
  const std::vector<std::string> outputs = session.outputs(name + ".pdf");
  for (const std::string& path : outputs) require_kind(path);
  FoldFile file = read_sheet(args.net, session);
  options.size.fill_page = file.unit == "unit";  // a file in millimetres says how large it is
  const std::optional<PartsClaim> parts = parts_claim(file);
  if (parts) {
    options.titles = part_titles(parts->names, parts->pieces);
    options.seams = parts->seam;
    if (static_cast<int>(options.titles.size()) != file.net.num_parts())
      throw InvalidInput(
          "fold/parts",
          fmt::format("plico:parts tells of {} pieces, the net has {}", options.titles.size(), file.net.num_parts()),
          args.net);
  }
  open_slits_of(file.net);
  const FoldedShape shape = shape_of(file, parts, args, options, session);
  const LayoutResult result = lay_out_pages(file.net, shape, options, session.run());
  const LayoutVerdict verdict = verify_layout(result.layout);
  session.report()["print"] = json_of(result.report);
  session.report()["print"]["overlaps"] = verdict.overlaps;
  session.report()["print"]["off_page"] = verdict.off_page;
  session.report()["print"]["places"] = json_of_places(result.report);
  const DrawOptions how = draw_options(args.print, name);
  const std::vector<Drawing> pages = draw(result.layout, how, plain_paint(file.net.sheet, colors_of(file)));
  for (const std::string& path : outputs) write_pages(session, path, pages, how.title, args.print.one_svg);
  session.print(layout_text(result.report));
  for (const std::string& problem : verdict.problems) session.warn(problem);
  return verdict.sound() ? kDone : kNo;
}

}  // namespace

Job print_job() {
  auto args = std::make_shared<NetArgs>();
  Job job("print", "Lay out a net on pages with glue tabs and edge ids, as PDF, SVG or DXF");
  job.example("plico print bird.fold --height 150mm", "bird.pdf on A4, the finished bird 150 mm tall")
      .example("plico print bird.fold --page Letter -o bird.pdf -o bird.svg -o bird.dxf", "one layout in three formats")
      .example("plico print bird.fold --longest 40cm --split --marks start,seam",
               "a large model for a class: parts cut to fit, marks to build by")
      .positional("net", "net or crease pattern: FOLD, .cp, .opx, .ori or SVG; '-' is standard input", args->net);
  add_print_options(job, args->print);
  job.option(
      "--put", "PANEL,PAGE,X,Y,ANGLE",
      "lay the part with this panel on this page, its first corner X and Y mm from the lower left, its first side "
      "at ANGLE degrees; the report tells where parts lie; repeatable",
      args->put);
  job.action([args](Session& session) { return print(*args, session); });
  return job;
}

}  // namespace plico::jobs
