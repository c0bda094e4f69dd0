#include "plico/workflow/jobs/stack_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/fabricate/page.h"

namespace plico::jobs {
namespace {

// "6x6"; "auto" leaves both 0.
void read_base(const std::string& text, StackMeshOptions& options) {
  if (text == "auto") return;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  const bool crossed = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  const auto depth = crossed ? std::from_chars(width.ptr + 1, end, options.depth) : width;
  if (!crossed || depth.ec != std::errc{} || depth.ptr != end || options.width < 1 || options.depth < 1)
    throw InvalidOption(fmt::format("base = {} must be auto or WxD, as 6x6, each at least 1", text));
}

// Empty for text with a unit, or none at all.
std::optional<double> plain_number(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc{} && read.ptr == end ? std::optional(number) : std::nullopt;
}

// "0.08" is voxel sides already; "2mm" is of squares that measure `side_mm`.
double in_sides(const std::string& flag, const std::string& text, double side_mm) {
  const std::optional<double> plain = plain_number(text);
  const double sides = plain ? *plain : parse_length_mm(text) / side_mm;
  if (sides > 0 && sides < 0.5) return sides;
  const std::string of = plain ? "" : fmt::format(" are {:.4g} sides of {:g} mm (--side) and", sides, side_mm);
  throw InvalidOption(fmt::format("{}: {}{} must be in (0, 0.5)", flag, text, of));
}

// The three lengths of "6x6x4.5", in the mesh's unit, or of "60x60x45mm", where a millimetre is `millimetre` long.
Vec3 read_box(const std::string& text, double millimetre) {
  Vec3 box = Vec3::Zero();
  const bool metric = text.ends_with("mm");
  const char *at = text.data(), *end = at + text.size() - (metric ? 2 : 0);
  bool good = true;
  for (int i = 0; i < 3 && good; ++i) {
    if (i > 0) good = at != end && *at++ == 'x';
    const auto read = std::from_chars(at, end, box[i]);
    good = good && read.ec == std::errc{} && std::isfinite(box[i]) && box[i] > 0;
    at = read.ptr;
  }
  if (!good || at != end)
    throw InvalidOption(fmt::format("box = {} must be WxDxH, as 6x6x4.5 or 60x60x45mm, each above 0", text));
  return metric ? Vec3(box * millimetre) : box;
}

// The option with the smallest box that holds so many panels, in digits that do not make it smaller.
std::string roomy_box(int panels, double thickness, double side) {
  const StackBox base = best_base(panels, thickness);
  const double height = thickness * ideal_layers(panels, base.width, base.depth);
  const double scale = 1.001 * side;
  return fmt::format("--box {:.4g}x{:.4g}x{:.4g}", scale * base.width, scale * base.depth, scale * height);
}

}  // namespace

Job& add_stack_options(Job& job, StackArgs& args) {
  job.option("--thickness", "T", "of the panels, in voxel sides below 0.5, or as 2mm, where a square measures --side",
             args.thickness)
      .option("--trim", "T",
              "of every side of a panel, told as the thickness, from half of it to all of it (else all of it)",
              args.trim)
      .flag("--all", "a chain of each piece of the voxels, in files numbered from the largest on, not only of that one",
            args.all)
      .choice(
          "--motion",
          "plan and prove how the stack unfolds: into one pile, or on into the shape; a page (.html) asks for shape",
          args.motion, {"none", "pile", "shape"})
      .option("--base", "WxD", "of the stack, in panels; auto: the base with the least W + D + H", args.base)
      .option(
          "--box", "WxDxH",
          "the stack must fit into it, in the mesh's unit or, as 60x60x45mm, by --side; its base is the best that does",
          args.box)
      .length("--side", "of a square, on sheets (.svg, .dxf, .pdf) and as a solid (.stl, .3mf)", args.side_mm)
      .choice("--solid", "what a solid has: the panels in the stack, one panel, or the panels in the shape", args.solid,
              {"stack", "panel", "shape"})
      .option("--page", "SIZE", "of the sheets: A4, Letter, ..., or WIDTHxHEIGHT", args.page);
  return add_voxel_options(job, args);
}

StackMeshOptions stacking_of(const StackArgs& args, const Session& session) {
  require(args.side_mm > 0, "side", args.side_mm, "above 0");
  StackMeshOptions options{.seed = session.seed()};
  options.thickness = in_sides("--thickness", args.thickness, args.side_mm);
  if (!args.trim.empty()) options.trim = in_sides("--trim", args.trim, args.side_mm);
  read_base(args.base, options);
  check(options);
  paper_size(args.page);  // refuses a size that there is not
  return options;
}

std::string thickness_text(const StackArgs& args, const StackMeshOptions& options) {
  if (plain_number(args.thickness)) return {};
  return fmt::format("panels     {} thick, {:.4g} of the squares' sides of {:g} mm (--side)\n", args.thickness,
                     options.thickness, args.side_mm);
}

int choose_base_in_box(const StackArgs& args, const VoxelMesh& voxels, StackMeshOptions& options) {
  if (args.base != "auto") throw InvalidOption("a base and a box exclude each other", "--box only");
  const double side = voxels.solid.side;
  const Vec3 box = read_box(args.box, side / args.side_mm);
  const int panels = voxels.shell.size();
  const auto count = [&](double length, double unit) {
    return static_cast<int>(std::min<double>(std::floor(length / unit + 1e-9), panels));
  };
  const StackBox room{count(box.x(), side), count(box.y(), side), count(box.z(), side * options.thickness)};
  const std::optional<StackBox> base = best_base_in(room, panels, options.thickness);
  if (!base)
    throw InvalidOption(
        fmt::format("box = {} has room for {} x {} panels in {} layers, not for the {} of the chain, which need a "
                    "volume of at least {:.4g}",
                    args.box, room.width, room.depth, room.height, panels,
                    panels * options.thickness * side * side * side),
        roomy_box(panels, options.thickness, side));
  options.width = base->width;
  options.depth = base->depth;
  return room.height;
}

}  // namespace plico::jobs
