#include "read_sheet.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/pattern/pattern_file.h"
#include "plico/io/text/file.h"

namespace plico::cli {

FoldFile read_sheet(const std::string& path, Session& session) {
  PatternFile pattern = read_pattern(session.read(path), path);
  for (const std::string& note : pattern.notes) session.say(note);
  if (!pattern.notes.empty()) session.report()["notes"] = pattern.notes;
  return std::move(pattern.file);
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

}  // namespace plico::cli
