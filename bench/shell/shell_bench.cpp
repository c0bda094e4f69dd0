// Disjoint convex shells: 53 pairs of bars ([Xi17] fig. 5.15) and shapes of overlapping parts ([Xi17] tables 5.1, 5.2),
// the dissertation's three methods beside the full search. usage: bench_shell [--meshes DIR] [--json FILE] [--quick]
// (DIR: OBJ files with one o or g group a part)
#include <cmath>
#include <fstream>
#include <iterator>

#include "../../tests/controlled_pairs.h"
#include "certify.h"
#include "plico/base/libm.h"
#include "plico/convex/shape_parts.h"
#include "plico/convex/shells.h"
#include "plico/io/mesh/face_groups.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/workflow/shell_shape.h"
#include "table.h"

namespace {

using namespace plico;

constexpr CutMethod kMethods[] = {CutMethod::Lsf, CutMethod::Svm, CutMethod::SvmOffset, CutMethod::Full};

double percent_lost(const ControlledPair& pair, const Plane& plane) {
  const std::vector<ConvexPolyhedron> both = {pair.first, pair.second};
  return 100 * (1 - (volume(clip(pair.first, plane, 0)) + volume(clip(pair.second, plane.flipped(), 0))) /
                        union_volume(both));
}

// The oracle: many normals, spread evenly over the sphere, the best offset of each, polished.
double brute_force(const ControlledPair& pair, int normals) {
  double best = INFINITY;
  for (int i = 0; i < normals; ++i) {
    const double z = 1 - (2 * i + 1.0) / normals, turn = i * kPi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
    const Plane start = best_offset({pair.first, pair.second}, {r * plico::cos(turn), r * plico::sin(turn), z});
    best = std::min(best, percent_lost(pair, polished_cut({pair.first, pair.second}, start)));
  }
  return best;
}

void controlled(bench::Table& table, bool quick) {
  double sum[4] = {};
  int count = 0, beaten = 0, off_anchor = 0;
  for (const ControlledPair& pair : controlled_pairs()) {
    bench::Table::Row row = {pair.family + ", " + pair.name};
    double full = 0, seconds = 0;
    for (int m = 0; m < 4; ++m) {
      Rng rng(1);
      Plane plane;
      seconds = bench::seconds([&] { plane = cut_plane({pair.first, pair.second}, kMethods[m], rng); });
      sum[m] += full = percent_lost(pair, plane);
      row.push_back(full);
    }
    const double oracle = quick ? NAN : brute_force(pair, 400);
    row.push_back(quick ? nlohmann::json() : nlohmann::json(oracle));
    row.push_back(pair.least_loss);
    row.push_back(1e3 * seconds);
    table.row(std::move(row));
    ++count;
    beaten += oracle < full - 1e-3;
    off_anchor += std::abs(full - pair.least_loss) > 1.5e-3;  // 1e-5 of the volume, and the anchor's own rounding
  }
  table.row({"mean", sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count, nullptr, nullptr, nullptr});
  fmt::print("{} pairs, the oracle is better by more than 1e-5 in {}; {} anchors missed by more than 1e-5\n", count,
             beaten, off_anchor);
}

// Ten pairs, at least one a family with a loss: is any plane better than ours by more than 0.3 % of the union?
void certified(bench::Table& table) {
  int chosen = 0;
  for (const ControlledPair& pair : controlled_pairs()) {
    for (const char* wanted : {"elbow, 40 deg", "elbow, 90 deg", "elbow, 120 deg", "uneven elbow, 60 deg",
                               "uneven elbow, 150 deg", "cross-end, 20 deg", "cross-end, 70 deg",
                               "end-overlap, length 1", "T, sunk 0.35, tilt 20", "X, 60 deg, offset 1.2"}) {
      if (pair.family + ", " + pair.name != wanted) continue;
      const std::vector<ConvexPolyhedron> both = {pair.first, pair.second};
      const double all = union_volume(both), shared = volume(intersection(pair.first, pair.second, 0));
      const double ours = percent_lost(pair, full_cut({pair.first, pair.second})) / 100 * all + shared;
      bench::Certificate certificate;
      const double seconds =
          bench::seconds([&] { certificate = bench::certify(pair.first, pair.second, ours, 0.003 * all, 1'000'000); });
      chosen += certificate.bound >= ours - 0.003 * all ? 1 : 0;
      table.row(
          {wanted, 100 * (ours - shared) / all, 100 * (certificate.bound - shared) / all, certificate.boxes, seconds});
    }
  }
  fmt::print("{} of 10 pairs proven to be within 0.3 % of the union of the best\n", chosen);
}

// A mesh in one piece is a shape when a file beside it labels its faces, as 'plico segment' writes one.
std::filesystem::path labels_of(std::filesystem::path path) { return path.replace_extension(".seg"); }

bool is_shape(const std::filesystem::path& path) {
  return path.extension() == ".obj" || std::filesystem::exists(labels_of(path));
}

std::vector<ShapePart> read_parts(const std::filesystem::path& path) {
  std::ifstream in(path);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const PolygonSoup soup = read_mesh_source(bytes, path.string()).soup;
  if (const auto labels = labels_of(path); std::filesystem::exists(labels)) {
    const FaceGroups groups = read_face_labels(read_file(labels.string()), labels.string());
    return parts_by_groups(soup, groups.of_face, groups.names);
  }
  if (!has_obj_groups(bytes)) return parts_by_components(soup);
  const FaceGroups groups = read_obj_groups(bytes, path.string());
  return parts_by_groups(soup, groups.of_face, groups.names);
}

// [Xi17] tables 5.1 (seconds, simplification and regularization included) and 5.2; its "exact" is svm-offset.
void printed_rows(bench::Table& table) {
  const struct {
    const char* model;
    double loss[3], seconds[3];
  } rows[] = {{"[Xi17] Squirtle", {.25, .45, .22}, {3.401, 6.051, 6.307}},
              {"[Xi17] Cow", {11.93, 1.32, 1.03}, {7.575, 14.257, 14.888}},
              {"[Xi17] Pikachu", {.181, .102, .096}, {5.504, 7.866, 8.017}},
              {"[Xi17] mean of 20", {6.18, 2.12, 1.11}, {8.9, 16.8, 17.3}}};
  for (const auto& row : rows)
    for (int m = 0; m < 3; ++m)
      table.row({m == 0 ? row.model : "", std::string(name(kMethods[m])), nullptr, nullptr, nullptr, nullptr,
                 row.loss[m], nullptr, nullptr, 1e3 * row.seconds[m]});
}

void composites(bench::Table& table, const std::string& folder) {
  double sum[4] = {};
  int models = 0, beaten = 0, invalid = 0;
  for (const std::filesystem::path& path : bench::mesh_files(folder)) {
    if (!is_shape(path)) continue;
    const std::vector<ShapePart> parts = read_parts(path);
    double least = INFINITY;
    for (int m = 0; m < 4; ++m) {
      ShellOptions options;
      options.method = kMethods[m];
      JudgedShells judged;
      const double seconds = bench::seconds([&] { judged = shell_shape(parts, options, {}); });
      const Shells& shells = judged.shells;
      const double loss = 100 * shells.loss();
      sum[m] += loss;
      invalid += judged.verdict.valid() ? 0 : 1;
      if (options.method == CutMethod::Full) beaten += loss > least + 1e-6;
      least = std::min(least, loss);
      table.row({m == 0 ? path.stem().string() : "", std::string(name(options.method)), parts.size(),
                 shells.nested.size(), shells.lost.size(), 100 * shells.least_kept(), loss, judged.verdict.plane_tests,
                 judged.verdict.valid() ? "yes" : "no", 1e3 * seconds});
    }
    ++models;
  }
  printed_rows(table);
  if (models == 0) return;
  fmt::print(
      "{} models: mean loss lsf {:.3g}, svm {:.3g}, svm-offset {:.3g}, full {:.3g} %; full over svm-offset {:.3g}; "
      "full beaten by another in {}; {} results not valid\n",
      models, sum[0] / models, sum[1] / models, sum[2] / models, sum[3] / models, sum[3] / sum[2], beaten, invalid);
}

// The pair of each shape that loses most when it is alone: what no plane can save of the shape's loss.
void worst_pairs(bench::Table& table, const std::string& folder) {
  for (const std::filesystem::path& path : bench::mesh_files(folder)) {
    if (!is_shape(path)) continue;
    const std::vector<ShapePart> parts = read_parts(path);
    std::vector<ConvexPolyhedron> hulls;
    for (const ShapePart& part : parts) hulls.push_back(convex_hull(part.points));
    const double all = union_volume(hulls);
    double most = 0;
    std::size_t a = 0, b = 0;
    Plane best;
    for (std::size_t i = 0; i < hulls.size(); ++i)
      for (std::size_t j = i + 1; j < hulls.size(); ++j) {
        const ConvexPolyhedron shared = intersection(hulls[i], hulls[j], 0);
        if (shared.empty() || volume(shared) > 0.9 * std::min(volume(hulls[i]), volume(hulls[j]))) continue;
        const CutPair pair{hulls[i], hulls[j]};
        const Plane plane = full_cut(pair);
        const double lost = cut_loss(pair, frame_of(plane, {0, 0, 0})).value - volume(shared);
        if (lost <= most) continue;
        most = lost, a = i, b = j, best = plane;
      }
    if (a == b) continue;
    const CutPair pair{hulls[a], hulls[b]};
    const double shared = volume(intersection(hulls[a], hulls[b], 0));
    const bench::Certificate certificate = bench::certify(hulls[a], hulls[b], most + shared, 0.003 * all, 50'000);
    Rng rng(1);
    const Plane offset = cut_plane(pair, CutMethod::SvmOffset, rng);
    table.row({path.stem().string(), parts[a].name + ", " + parts[b].name,
               100 * (cut_loss(pair, frame_of(offset, {0, 0, 0})).value - shared) / all, 100 * most / all,
               100 * (certificate.bound - shared) / all, certificate.boxes});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bench::Arguments arguments = bench::arguments(argc, argv);
  bench::Table pairs("Two bars: loss in percent of the union ([Xi17] fig. 5.15: lsf 11.43, svm 2.1, exact 0.9)",
                     {"pair", "lsf", "svm", "svm-offset", "full", "400 normals", "anchor", "full ms"});
  controlled(pairs, arguments.quick);
  bench::Table bounds("\nBranch and bound: no plane loses less than the bound",
                      {"pair", "full %", "bound %", "boxes", "s"});
  if (!arguments.quick) certified(bounds);
  bench::Table shapes("\nShapes of overlapping parts",
                      {"shape", "method", "parts", "nested", "lost", "kept %", "loss %", "tests", "valid", "ms"});
  composites(shapes, arguments.meshes);
  bench::Table worst(
      "\nThe worst pair of each shape, in percent of the whole shape: no plane loses less than the bound",
      {"shape", "pair", "svm-offset", "full", "bound", "boxes"});
  if (!arguments.quick) worst_pairs(worst, arguments.meshes);
  bench::write_json(arguments, {&pairs, &bounds, &shapes, &worst});
  return 0;
}
