// plico origami gallery: all crease patterns of a folder as a page and a table.
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/pattern/pattern_file.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/origami_gallery.h"

namespace plico::jobs {
namespace {

struct GalleryArgs {
  std::string folder;
  GalleryOptions options;
};

std::vector<std::string> pattern_names(const std::string& folder, Session& session) {
  std::vector<std::string> names;
  for (const std::string& name : session.names_in(folder))
    if (pattern_format_of(name)) names.push_back(name);
  if (names.empty())
    throw InvalidInput("gallery/empty", folder + " has no crease pattern: FOLD, .cp, .opx, .ori or SVG", folder);
  return names;
}

int make_gallery(const GalleryArgs& args, Session& session) {
  const std::vector<std::string> names = pattern_names(args.folder, session);
  const std::string out = session.output_folder("gallery");
  GalleryOptions options = args.options;
  options.motion.seed = session.seed();
  std::vector<GalleryRow> rows;
  for (const std::string& name : names) {
    rows.push_back(gallery_row(name, session.read(args.folder + "/" + name), options, session.run()));
    const GalleryRow& row = rows.back();
    session.detail(row.refused.empty() ? fmt::format("{}: {:.4g} %{}, {:.2f} s", name, 100 * row.progress,
                                                     row.proven ? " proven" : "", row.seconds)
                                       : name + ": " + row.refused);
    if (session.run().over()) break;
  }
  session.write(out + "/index.html", gallery_page(rows));
  session.write(out + "/gallery.csv", gallery_csv(rows));
  session.report()["summary"] = gallery_summary(rows);
  session.say(gallery_summary(rows));
  return rows.size() < names.size() ? Session::exit_code(session.run().ending()) : kDone;
}

}  // namespace

Job origami_gallery_job() {
  const auto args = std::make_shared<GalleryArgs>();
  args->options.seconds_each = 20;
  Job job =
      Job("origami gallery", "Read and fold every crease pattern of a folder, and show how far each comes")
          .example("plico origami gallery patterns -o gallery", "gallery/index.html to look at, gallery/gallery.csv")
          .example("plico origami gallery patterns --each 5s -v -o gallery", "at most 5 seconds a pattern, a line each")
          .example("plico origami gallery patterns --each 0 -o gallery",
                   "no time limit: the same figures on every machine")
          .positional("FOLDER", "its FOLD, .cp, .opx, .ori and SVG files; folders inside are left out", args->folder)
          .duration("--each", "time for one pattern, 20s when not given; 0: no limit", args->options.seconds_each)
          .action([args](Session& session) { return make_gallery(*args, session); });
  add_drawing_options(job, args->options.drawing);
  return job;
}

}  // namespace plico::jobs
