// plico print: a net as pages to print and files to cut.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
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
};

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
  job.action([args](Session& session) { return print(*args, session); });
  return job;
}

}  // namespace plico::jobs
