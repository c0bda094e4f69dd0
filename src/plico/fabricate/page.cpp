#include "plico/fabricate/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

struct Paper {
  std::string_view name;
  double width, height;  // millimetres
};
constexpr Paper kPapers[] = {{"letter", 215.9, 279.4},    {"legal", 215.9, 355.6},     {"tabloid", 279.4, 431.8},
                             {"ledger", 279.4, 431.8},    {"executive", 184.2, 266.7}, {"arch-a", 228.6, 304.8},
                             {"arch-b", 304.8, 457.2},    {"arch-c", 457.2, 609.6},    {"arch-d", 609.6, 914.4},
                             {"mat-12x12", 304.8, 304.8}, {"mat-12x24", 304.8, 609.6}};

// The sheets of ISO 216, "a4" or "b3": each is half of the one before, rounded down.
std::optional<Vec2> iso_sheet(std::string_view name) {
  if (name.size() != 2 || (name[0] != 'a' && name[0] != 'b') || name[1] < '0' || name[1] > '8') return std::nullopt;
  int width = name[0] == 'a' ? 841 : 1000, height = name[0] == 'a' ? 1189 : 1414;
  for (char n = '0'; n < name[1]; ++n) {
    const int half = height / 2;
    height = width;
    width = half;
  }
  return Vec2(width, height);
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

// "12" and "18in": a unit that only the second length has holds for both.
Vec2 custom_size(const std::string& width, const std::string& height) {
  const std::size_t unit = height.find_first_not_of("0123456789.");
  const bool bare = width.find_first_not_of("0123456789.") == std::string::npos;
  const std::string suffix = bare && unit != std::string::npos ? height.substr(unit) : "";
  return {parse_length_mm(width + suffix), parse_length_mm(height)};
}

}  // namespace

void check(const PageOptions& options) {
  if (!(options.size.minCoeff() >= 30 && options.size.maxCoeff() <= 5000))
    throw InvalidOption(
        fmt::format("page = {:g}x{:g} mm must be in [30, 5000] mm", options.size.x(), options.size.y()));
  const double most = options.size.minCoeff() / 2 - 10;
  const Margins& m = options.margin;
  for (double margin : {m.left, m.bottom, m.right, m.top})
    if (!(margin >= 0 && margin <= most))
      throw InvalidOption(fmt::format("margin = {:g} mm must be in [0, {:g}] mm on this page", margin, most));
}

Vec2 printable(const PageOptions& page) { return page.size - page.margin.low() - page.margin.high(); }

Margins parse_margins(std::string_view text) {
  std::vector<double> given;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    given.push_back(parse_length_mm(text.substr(from, comma - from)));
    from = comma + 1;
  }
  if (given.size() == 1) return given[0];
  if (given.size() == 2) return {given[1], given[0], given[1], given[0]};
  if (given.size() == 4) return {given[3], given[2], given[1], given[0]};
  throw InvalidOption(fmt::format("margin '{}' must be one length, two, or four: top,right,bottom,left", text));
}

Vec2 paper_size(std::string_view name) {
  const std::string wanted = lower(name);
  if (const auto iso = iso_sheet(wanted)) return *iso;
  for (const Paper& paper : kPapers)
    if (paper.name == wanted) return {paper.width, paper.height};
  const std::size_t times = wanted.find('x');
  if (times == std::string::npos || times == 0 || times + 1 == wanted.size())
    throw InvalidOption(fmt::format("'{}' is not a paper size", name), "try A4, B3, Letter or 300x400mm");
  return custom_size(wanted.substr(0, times), wanted.substr(times + 1));
}

FoldedShape folded_shape(const Mesh& mesh) {
  FoldedShape shape{bounding_box(mesh).sizes(), std::vector<double>(mesh.num_edges()), {}};
  for (EdgeId e : mesh.edges()) shape.seam_angle[e] = fold_angle(mesh, e);
  for (FaceId f : mesh.faces()) {
    std::vector<Vec3>& corners = shape.faces.emplace_back();
    for (HalfedgeId h : mesh.halfedges(f)) corners.push_back(mesh.point(mesh.from(h)));
  }
  return shape;
}

bool SizeOptions::is_given() const {
  return !(std::isnan(height) && std::isnan(width) && std::isnan(longest) && std::isnan(scale));
}

double scale_of(const FoldedShape& shape, const SizeOptions& options) {
  const double up = options.up == 'z' ? shape.size.z() : shape.size.y();
  const struct {
    const char* name;
    double wanted, extent;
  } sizes[] = {{"height", options.height, up},
               {"width", options.width, shape.size.x()},
               {"longest", options.longest, shape.size.maxCoeff()},
               {"scale", options.scale, 1}};
  const char* given = nullptr;
  double scale = 1;
  for (const auto& [name, wanted, extent] : sizes) {
    if (std::isnan(wanted)) continue;
    if (given) throw InvalidOption(fmt::format("{} and {} are both given, one decides the size", given, name));
    given = name;
    if (!(wanted > 0)) throw InvalidOption(fmt::format("{} = {:g} must be above 0", name, wanted));
    if (!(extent > 0)) throw InvalidOption(fmt::format("the model has no {}", name), "try --longest");
    scale = wanted / extent;
  }
  return scale;
}

}  // namespace plico
