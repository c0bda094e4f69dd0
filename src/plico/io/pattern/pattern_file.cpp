#include "plico/io/pattern/pattern_file.h"

#include <algorithm>

#include "plico/base/error.h"
#include "plico/io/pattern/cp.h"
#include "plico/io/pattern/opx.h"
#include "plico/io/pattern/ori.h"
#include "plico/io/pattern/svg_pattern.h"
#include "plico/io/text/file.h"

namespace plico {
namespace {

PatternFile with_notes(FoldFile file) {
  std::vector<std::string> notes = std::move(file.notes);
  file.notes.clear();
  return {std::move(file), std::move(notes)};
}

PatternFile drawing(ImportedPattern imported) {
  const std::vector<int> parts = parts_of(imported.sheet);
  const int sheets = 1 + *std::max_element(parts.begin(), parts.end());
  if (sheets > 1)
    imported.notes.push_back(fmt::format("{} separate sheets are drawn: each is folded by itself", sheets));
  return {fold_file(imported.sheet), std::move(imported.notes)};
}

// The name of a mesh where a sheet is wanted: the most common slip.
bool is_named_as_mesh(const std::string& name) {
  constexpr std::string_view kMeshes[] = {"obj", "off", "stl", "ply"};
  return std::ranges::find(kMeshes, extension(name)) != std::end(kMeshes);
}

PatternFile read_as(std::string_view bytes, PatternFormat format, const std::string& name,
                    const DrawingOptions& options) {
  switch (format) {
    case PatternFormat::Fold:
      return with_notes(read_fold(bytes, name));
    case PatternFormat::Cp:
      return drawing(read_cp(bytes, name, options));
    case PatternFormat::Opx:
      return drawing(read_opx(bytes, name, options));
    case PatternFormat::Svg:
      return drawing(read_svg_pattern(bytes, name, options));
    case PatternFormat::Ori:
      return drawing(read_ori(bytes, name).pattern);
  }
  return {};
}

}  // namespace

std::string_view name(PatternFormat format) {
  constexpr std::string_view kNames[] = {"FOLD", "CP", "OPX", "SVG", "ORI"};
  return kNames[static_cast<int>(format)];
}

std::optional<PatternFormat> pattern_format_of(const std::string& path) {
  const std::string ext = extension(path);
  if (ext == "ori" || path.ends_with(".ori.json")) return PatternFormat::Ori;
  if (ext == "fold" || ext == "json") return PatternFormat::Fold;
  if (ext == "cp") return PatternFormat::Cp;
  if (ext == "opx") return PatternFormat::Opx;
  if (ext == "svg") return PatternFormat::Svg;
  return {};
}

std::optional<PatternFormat> sniff_pattern_format(std::string_view bytes) {
  const auto first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  if (bytes[first] == '{')
    return bytes.find("\"ordered_face_ids\"") != std::string_view::npos ? PatternFormat::Ori : PatternFormat::Fold;
  if (bytes[first] >= '0' && bytes[first] <= '4') return PatternFormat::Cp;
  if (bytes.find("OriLineProxy") != std::string_view::npos) return PatternFormat::Opx;
  if (bytes.find("<svg") != std::string_view::npos) return PatternFormat::Svg;
  return {};
}

PatternFile read_pattern(std::string_view bytes, const std::string& name, const DrawingOptions& options) {
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw InvalidInput("read/empty", fmt::format("{} is empty", name), name);
  if (is_named_as_mesh(name))
    throw InvalidInput("read/mesh", fmt::format("{} is a mesh, a net or a crease pattern is wanted", name), name,
                       fmt::format("plico unfold {} -o net.fold", name));
  const auto by_name = pattern_format_of(name), by_content = sniff_pattern_format(bytes);
  // Without a name that says otherwise it is FOLD, whose reader says best what is wrong.
  const PatternFormat format = by_name ? *by_name : by_content.value_or(PatternFormat::Fold);
  try {
    return read_as(bytes, format, name, options);
  } catch (const InvalidInput& error) {
    if (!by_content || by_content == format || !error.suggestion().empty()) throw;
    throw InvalidInput(error.code(), error.what(), error.where(),
                       fmt::format("rename the file: it looks like {}", plico::name(*by_content)));
  }
}

}  // namespace plico
