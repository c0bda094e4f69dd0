#include "plico/workflow/jobs/stack_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/fabricate/runs.h"
#include "plico/io/mesh/stl.h"
#include "plico/verify/page_layout.h"
#include "plico/workflow/jobs/page_files.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/stack_views.h"

namespace plico::jobs {
namespace {

bool is_sheet(const std::string& path) {
  return path.ends_with(".svg") || path.ends_with(".dxf") || path.ends_with(".pdf");
}

bool is_solid(const std::string& path) { return path.ends_with(".stl") || path.ends_with(".3mf"); }

ChainSolid solid_of(const std::string& name) {
  return name == "stack" ? ChainSolid::Stack : name == "panel" ? ChainSolid::Panel : ChainSolid::Shape;
}

std::string stem(const std::string& path) {
  const std::size_t first = path.find_last_of('/') + 1;
  return path.substr(first, path.rfind('.') - first);
}

// The runs of the chain, judged before they are drawn; false when they are not sound.
bool lay_out_sheets(const StackFiles& what, Session& session, nlohmann::json& report, PageLayout& layout) {
  const StackedChain& chain = what.chain;
  RunOptions options;
  options.side = what.args.side_mm;
  options.trim = chain.claim.trim / chain.verdict.side * options.side;
  options.page.size = paper_size(what.args.page);
  layout = lay_out_runs(chain.claim.sheet, options);
  report["sheets"] = {{"runs", layout.parts.size()}, {"pages", layout.pages.size()}, {"side_mm", options.side}};
  session.print(fmt::format("sheets     {} runs on {} pages, squares of {:g} mm\n", layout.parts.size(),
                            layout.pages.size(), options.side));
  const LayoutVerdict verdict = verify_layout(layout);
  for (const std::string& problem : verdict.problems) session.warn(problem);
  return verdict.sound();
}

void write_sheets(Session& session, const std::string& path, const PageLayout& layout) {
  DrawOptions how;
  how.title = stem(path);
  how.flat_creases = true;
  how.ruler = false;
  write_pages(session, path, draw(layout, how), how.title);
}

void write_chain(const StackFiles& what, const std::string& path, Session& session) {
  const StackedChain& chain = what.chain;
  if (is_solid(path)) {
    const PlacedSolid solid = chain_solid(chain.claim, solid_of(what.args.solid), what.args.side_mm);
    return session.write(path, path.ends_with(".stl") ? write_stl(copies_of(solid)) : write_3mf(solid));
  }
  if (path.ends_with(".csv")) return session.write(path, chain_table(what.voxels, chain.found.best, chain.claim));
  if (path.ends_with(".png")) return session.write(path, stack_picture(chain.claim));
  if (path.ends_with(".html")) {
    ViewerInput page = unpacking_page(*what.motion);
    page.title = stem(path);
    page.report = session.provenance().dump();
    return session.write(path, viewer_page(page));
  }
  if (path.ends_with(".glb")) return session.write(path, unpacking_animation(*what.motion));
  write_fold_files(what.motion ? chain_motion_file(*what.motion) : chain_file(chain.claim), {path}, session);
}

}  // namespace

void check_stack_output(const std::string& path) {
  for (const char* ending : {".fold", ".csv", ".stl", ".3mf", ".html", ".glb", ".png", ".svg", ".dxf", ".pdf"})
    if (path == "-" || path.ends_with(ending)) return;
  throw InvalidOption(
      fmt::format("{} does not end in .fold, .csv, .stl, .3mf, .html, .glb, .png, .svg, .dxf or .pdf", path));
}

bool write_stack_files(const StackFiles& what, const std::vector<std::string>& paths, Session& session,
                       nlohmann::json& report) {
  PageLayout sheets;
  if (std::ranges::any_of(paths, is_sheet) && !lay_out_sheets(what, session, report, sheets)) return false;
  for (const std::string& path : paths)
    if (is_sheet(path))
      write_sheets(session, path, sheets);
    else
      write_chain(what, path, session);
  return true;
}

}  // namespace plico::jobs
