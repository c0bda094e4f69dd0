// Sheets in files of any kind we know: FOLD with nets, crease patterns and motions, and drawings of crease patterns.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plico/io/pattern/fold.h"
#include "plico/io/pattern/imported_pattern.h"

namespace plico {

enum class PatternFormat { Fold, Cp, Opx, Svg, Ori };
std::string_view name(PatternFormat format);                                // "FOLD"
std::optional<PatternFormat> pattern_format_of(const std::string& path);    // by the extension
std::optional<PatternFormat> sniff_pattern_format(std::string_view bytes);  // by the contents

struct PatternFile {
  FoldFile file;
  std::vector<std::string> notes;  // what reading changed or assumed, one sentence each; say it
};

// The sheet of a file in memory; the format by the extension of `name`, else by the contents. Throws InvalidInput with
// a code, the place in the file and often a suggestion.
PatternFile read_pattern(std::string_view bytes, const std::string& name = "input", const DrawingOptions& options = {});

}  // namespace plico
