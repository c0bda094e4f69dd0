// Nets for hands: what craft printed before it improved nets, and what it prints now, for models 20 cm and 10 cm long.
// Goals: hull left over 40 % less in the median, no branch of more than three panels on a fold under 5 mm, no needle by
// its short side, under 10 s a model; as large as one page holds, 45 % of the paper used in the median.
//   bench_paper [--meshes DIR] [--only page|20|10] [--json FILE] [--quick]
#include <ctime>
#include <thread>

#include "plico/base/error.h"
#include "plico/fabricate/hand_measures.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/text/file.h"
#include "plico/mesh/flat_regions.h"
#include "plico/mesh/measures.h"
#include "plico/motion/planner.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/craft.h"
#include "table.h"

namespace plico::bench {
namespace {

constexpr std::size_t kMostShapes = 20;
constexpr int kMostFaces = 700;

std::vector<std::pair<std::string, Mesh>> shapes(const Arguments& args) {
  std::vector<std::pair<std::string, Mesh>> all;
  for (const char* animal : {"bird", "dog", "fish", "dinosaur"})
    all.emplace_back(animal, Mesh(make_shape(animal, {.faces = 300})));
  for (const char* solid : {"star", "small-stellated-dodecahedron", "truncated-icosahedron", "torus", "sphere"})
    if (!args.quick) all.emplace_back(solid, Mesh(make_shape(solid)));
  for (const auto& file : mesh_files(args.meshes)) {
    try {
      Mesh mesh = to_mesh(read_mesh_source(read_file(file), file));
      if (mesh.num_faces() < 100 || mesh.num_faces() > kMostFaces || components(mesh).count != 1) continue;
      if (all.size() < kMostShapes) all.emplace_back(file.stem(), with_flat_regions_whole(std::move(mesh)));
    } catch (const Error& error) {
      fmt::print("left out: {}: {}\n", file.stem().string(), error.what());
    }
  }
  return all;
}

struct Crafted {
  CraftResult result;
  HandMeasures net, hands;  // of the net as it folds, and of the printed parts
  double seconds = 0;       // of all processors: a busy machine does not change them
};

Crafted crafted(const Mesh& mesh, HandWish wish, double longest_mm, const Run& run) {
  CraftOptions options;
  options.wish = wish;
  options.layout.split = longest_mm > 0;
  options.layout.weak_folds = wish == HandWish::None ? WeakFolds::Keep : WeakFolds::CutFew;
  if (longest_mm > 0) options.layout.size.longest = longest_mm;
  Crafted made;
  const std::clock_t start = std::clock();
  made.result = craft(mesh, options, run);
  made.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  made.hands = made.result.layout.report.hands;
  made.net = measure_for_hands(made.result.net, made.result.layout.report.scale);
  return made;
}

std::string both(double before, double after, const char* unit = "") {
  return fmt::format("{:.3g} > {:.3g}{}", before, after, unit);
}

double less_left_over(const HandMeasures& before, const HandMeasures& after) {
  return before.left_over() > 1e-9 ? 1 - after.left_over() / before.left_over() : 0;
}

std::string covered(const HandMeasures& before, const HandMeasures& after) {
  return both(100 * before.net_area / before.hull_area, 100 * after.net_area / after.hull_area, " %");
}

// Before > after of everything that is measured; returns by how much the hull left over shrank, of the net and of the
// printed parts.
std::pair<double, double> row(Table& table, const std::string& name, const Mesh& mesh, double longest_mm,
                              const Run& run) {
  const Crafted was = crafted(mesh, HandWish::None, longest_mm, run);
  const Crafted is = crafted(mesh, HandWish::Hands, longest_mm, run);
  const HandMeasures &a = was.hands, &b = is.hands;
  const LayoutReport &before = was.result.layout.report, &after = is.result.layout.report;
  const double net_less = less_left_over(was.net, is.net), less = less_left_over(a, b);
  const auto ids_out = [](const LayoutReport& r) { return static_cast<double>(r.labels.omitted); };
  table.row({fmt::format("{} {:g} cm", name, longest_mm / 10), mesh.num_faces(), covered(was.net, is.net),
             fmt::format("{:.0f} %", 100 * net_less), covered(a, b), fmt::format("{:.0f} %", 100 * less),
             both(a.shortest_carrying, b.shortest_carrying), both(a.weak, b.weak), b.least_weak, after.weak_folds_cut,
             both(a.needles, b.needles), both(a.tight_seams, b.tight_seams),
             both(static_cast<double>(before.tabs.tabs.size()), static_cast<double>(after.tabs.tabs.size())),
             both(ids_out(before), ids_out(after)), both(before.parts, after.parts), both(before.pages, after.pages),
             both(100 * before.fill_ratio, 100 * after.fill_ratio),
             is.result.proven() >= was.result.proven() ? "yes" : "NO", both(was.seconds, is.seconds)});
  return {net_less, less};
}

void bench_size(const Arguments& args, Table& table, double longest_mm, const Run& run) {
  std::vector<double> net_less, less;
  for (const auto& [name, mesh] : shapes(args)) {
    try {
      const auto [of_net, of_parts] = row(table, name, mesh, longest_mm, run);
      net_less.push_back(of_net);
      less.push_back(of_parts);
    } catch (const InvalidInput& error) {
      fmt::print("left out: {} at {:g} cm: {}\n", name, longest_mm / 10, error.what());
    }
  }
  fmt::print("{:g} cm: hull left over by the nets {:.0f} % less in the median, by the printed parts {:.0f} %\n",
             longest_mm / 10, 100 * median(net_less), 100 * median(less));
}

void bench_page(const Arguments& args, Table& table, const Run& run) {
  std::vector<double> was, is;
  for (const auto& [name, mesh] : shapes(args)) {
    const Crafted before = crafted(mesh, HandWish::None, 0, run), after = crafted(mesh, HandWish::Hands, 0, run);
    was.push_back(100 * before.result.layout.report.fill_ratio);
    is.push_back(100 * after.result.layout.report.fill_ratio);
    table.row({name, mesh.num_faces(), was.back(), is.back(), before.hands.weak, after.hands.weak, after.seconds});
  }
  fmt::print("paper used in the median: {:.0f} % > {:.0f} %\n", median(was), median(is));
}

int bench(const Arguments& args, const std::string& only) {
  silence_planners();
  const Run run{.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))};
  Table page("as large as one page holds, before and after", {"mesh", "faces", "paper %", "now %", "weak", "now", "s"});
  if (only.empty() || only == "page") bench_page(args, page, run);
  Table sized("before > after", {"mesh", "faces", "net over hull", "left less", "parts over hull", "less",
                                 "carrying mm", "weak", "at least", "cuts", "needles", "tight", "tabs", "ids out",
                                 "parts", "pages", "paper %", "proof kept", "s"});
  for (double longest_mm : {200.0, 100.0})
    if (only.empty() || only == fmt::format("{:g}", longest_mm / 10)) bench_size(args, sized, longest_mm, run);
  write_json(args, {&page, &sized});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  std::vector<char*> words(argv, argv + argc);
  const std::string only = plico::bench::taken(words, "--only");
  return plico::bench::bench(plico::bench::arguments(static_cast<int>(words.size()), words.data()), only);
}
