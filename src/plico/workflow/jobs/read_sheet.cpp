#include "plico/workflow/jobs/read_sheet.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/pattern/pattern_file.h"
#include "plico/io/text/file.h"

namespace plico::jobs {

FoldFile read_sheet(const std::string& path, Session& session, const DrawingOptions& drawing) {
  PatternFile pattern = read_pattern(session.read(path), path, drawing);
  for (const std::string& note : pattern.notes) session.say(note);
  if (!pattern.notes.empty()) session.report()["notes"] = pattern.notes;
  return std::move(pattern.file);
}

void add_drawing_options(Job& job, DrawingOptions& drawing) {
  job.option("--merge", "LENGTH", "drawings: line ends closer than this are joined; 0: found from the drawing",
             drawing.merge, at_least(0))
      .option("--flatten", "LENGTH",
              "SVG: how far the straight creases that replace a curve may be from it; 0: 1/400 of the drawing",
              drawing.flatten, at_least(0));
}

std::vector<std::string> fold_outputs(const Session& session) {
  std::vector<std::string> outputs = session.outputs("-");
  for (const std::string& path : outputs) {
    const std::string kind = extension(path);
    if (path == "-" || kind.empty() || kind == "fold" || kind == "json") continue;
    const bool is_page = kind == "pdf" || kind == "svg" || kind == "dxf";
    throw InvalidOption(
        fmt::format("{} would be a FOLD file under another name", path),
        fmt::format("write NAME.fold, then plico {} NAME.fold -o {}", is_page ? "print" : "export", path));
  }
  return outputs;
}

void write_fold_files(FoldFile file, const std::vector<std::string>& paths, Session& session) {
  file.report = session.provenance().dump();
  const std::string bytes = write_fold(file);
  for (const std::string& path : paths) session.write(path, bytes);
}

}  // namespace plico::jobs
