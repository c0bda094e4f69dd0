#include "read_sheet.h"

#include <nlohmann/json.hpp>

#include "plico/io/pattern/pattern_file.h"

namespace plico::cli {

FoldFile read_sheet(const std::string& path, Session& session) {
  PatternFile pattern = read_pattern(session.read(path), path);
  for (const std::string& note : pattern.notes) session.say(note);
  if (!pattern.notes.empty()) session.report()["notes"] = pattern.notes;
  return std::move(pattern.file);
}

}  // namespace plico::cli
