#include "plico/workflow/hand_work.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {
namespace {

std::vector<double> lengths_in_mm(const Unfolding& net, double scale) {
  std::vector<double> lengths;
  for (int e = 0; e < net.sheet.num_edges(); ++e) {
    if (net.mate[e] > e) continue;  // a seam counts once
    const Crease& edge = net.sheet.edges[e];
    lengths.push_back(scale * (net.sheet.vertices[edge.a] - net.sheet.vertices[edge.b]).norm());
  }
  return lengths;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

HandWork hand_work(const Unfolding& net, const LayoutReport& report) {
  HandWork work;
  const std::vector<double> lengths = lengths_in_mm(net, report.scale);
  work.edges = static_cast<int>(lengths.size());
  work.small = static_cast<int>(std::ranges::count_if(lengths, [](double mm) { return mm < kSmallEdge; }));
  work.omitted = report.labels.omitted;
  work.ids = report.labels.placed + report.labels.leaders + report.labels.omitted;
  work.seams = report.tabs.seams + report.tabs.short_seams;
  work.bare = report.tabs.omitted + report.tabs.short_seams;
  return work;
}

std::optional<LargerPages> larger_pages(const Unfolding& net, const FoldedShape& shape, const LayoutOptions& options,
                                        const LayoutReport& report, const Run& run) {
  const double middle = median(lengths_in_mm(net, report.scale));
  LayoutOptions larger = options;
  larger.split = true;
  larger.cuts.clear();  // they were found for this size
  Run quiet = run;
  quiet.progress = nullptr;
  for (const double factor : {1.25, 1.6, 2.0, 2.5, 3.2, 4.0}) {
    if (run.over()) return {};
    if (factor * middle < kSmallEdge) continue;  // most edges would still be short
    const double longest = 5 * std::ceil(factor * report.final_size.maxCoeff() / 5);
    larger.size = {};
    larger.size.longest = longest;
    larger.size.up = options.size.up;
    try {
      const LayoutReport laid_out = lay_out_pages(net, shape, larger, quiet).report;
      const HandWork work = hand_work(net, laid_out);
      if (!work.too_small()) return LargerPages{longest, laid_out.pages, work};
    } catch (const InvalidInput&) {
      return {};  // a panel fits no page
    }
  }
  return {};
}

}  // namespace plico
