#include "plico/stack/peel.h"

#include <algorithm>

#include "plico/base/error.h"
#include "plico/stack/peel_grid.h"
#include "plico/stack/peel_step.h"

namespace plico {
namespace {

// Where the search stands: `first` is the next hinge to open, `option` the next way to try.
struct Stand {
  int first = 0, option = 0;
};

class PeelSearch {
 public:
  PeelSearch(const Linkage& chain, int sign, const PeelOptions& options, const Run& run)
      : bodies_(chain, sign, options.air),
        options_(options),
        run_(run),
        hinges_(chain.num_hinges()),
        left_(options.nodes),
        seen_(chain.num_hinges() + 1, 0) {}

  Peel run() {
    std::vector<Stand> stands{{}};
    while (!stands.empty() && !run_.over()) {
      const int first = stands.back().first;
      keep(first);
      if (first == hinges_) break;
      if (stands.back().option == 2 * options_.widest) {
        stands.pop_back();
        if (!steps_.empty()) steps_.pop_back();
        continue;
      }
      const int option = stands.back().option++;
      const int count = 1 + option % options_.widest;
      if (first + count > hinges_ || seen_[first + count]) continue;
      if (!open(first, count, option >= options_.widest)) continue;
      seen_[first + count] = 1;
      stands.push_back({first + count, 0});
    }
    result_.nodes = options_.nodes - left_;
    return std::move(result_);
  }

 private:
  bool open(int first, int count, bool on_grid) {
    const PeelWindow window(bodies_, first, count);
    std::vector<Angles3> way;
    if (!on_grid) {
      if (window.free_between(window.start(), window.end(), result_.intervals)) way = {window.start(), window.end()};
    } else if (count > 1) {  // one hinge has no other way
      way = find_on_grid(window, left_, result_.intervals, run_);
    }
    if (way.empty()) return false;
    PeelStep& step = steps_.emplace_back();
    step.first = first;
    for (const Angles3& angles : way) step.angles.push_back(Eigen::Map<const Eigen::VectorXd>(angles.data(), count));
    return true;
  }

  // The longest prefix so far.
  void keep(int opened) {
    if (opened < result_.opened) return;
    result_.opened = opened;
    result_.steps = steps_;
    result_.whole = opened == hinges_;
  }

  const PeelBodies bodies_;
  const PeelOptions& options_;
  const Run& run_;
  const int hinges_;
  long left_;
  std::vector<char> seen_;
  std::vector<PeelStep> steps_;
  Peel result_;
};

}  // namespace

Peel peel(const Linkage& chain, int sign, const PeelOptions& options, const Run& run) {
  require(options.air > 0 && options.air < 0.5, "air", options.air, "in (0, 0.5)");
  require(options.widest >= 1 && options.widest <= 3, "widest", options.widest, "1, 2 or 3");
  require(options.nodes >= 0, "nodes", options.nodes, "at least 0");
  return PeelSearch(chain, sign, options, run).run();
}

}  // namespace plico
