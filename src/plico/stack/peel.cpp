#include "plico/stack/peel.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "plico/base/error.h"
#include "plico/stack/peel_by_samples.h"
#include "plico/stack/peel_level.h"

namespace plico {
namespace {

class PeelSearch {
 public:
  // `sample` as PeelLevel has it.
  PeelSearch(const Linkage& chain, int sign, const PeelOptions& options, double sample, const Run& run)
      : bodies_(chain, sign, options.air),
        options_(options),
        sample_(sample),
        run_(run),
        hinges_(chain.num_hinges()),
        levels_(chain.num_hinges()) {
    effort_.nodes = nodes_at_best_ = options.nodes;
  }

  Peel run() {
    enter(0, {});
    while (static_cast<int>(steps_.size()) < hinges_ && !is_given_up()) {
      const int first = static_cast<int>(steps_.size());
      const std::vector<OpenAngles> way = levels_[first]->next_way(effort_, run_);
      if (way.empty()) {
        if (first == 0) break;
        keep();
        steps_.pop_back();
        continue;
      }
      if (!enter(first + 1, way.back())) continue;
      steps_.push_back(step(first, way));
      if (static_cast<int>(steps_.size()) > opened_) {
        opened_ = static_cast<int>(steps_.size());
        nodes_at_best_ = effort_.nodes;
      }
    }
    keep();
    result_.whole = result_.opened == hinges_;
    result_.nodes = options_.nodes - effort_.nodes;
    result_.intervals = effort_.intervals;
    return std::move(result_);
  }

 private:
  int width(int first) const { return std::min(options_.widest, hinges_ - first); }

  // The window moves on by one hinge: `before` are the angles at its last place, empty at the first.
  bool enter(int first, const std::optional<OpenAngles>& before) {
    if (first == hinges_) return true;
    OpenAngles angles{};
    for (int i = 0; i < width(first); ++i) {
      const bool was_open = before && i + 1 < width(first - 1);
      angles[i] = was_open ? (*before)[i + 1] : bodies_.pile_angle(first + i);
    }
    if (!levels_[first])
      levels_[first] = std::make_unique<PeelLevel>(bodies_, first, width(first), options_.step, sample_);
    return levels_[first]->enter(angles);
  }

  PeelStep step(int first, const std::vector<OpenAngles>& way) const {
    PeelStep step{first, {}};
    for (const OpenAngles& angles : way)
      step.angles.push_back(Eigen::Map<const Eigen::VectorXd>(angles.data(), width(first)));
    return step;
  }

  bool is_given_up() const {
    return effort_.nodes <= 0 || nodes_at_best_ - effort_.nodes > options_.patience || run_.over();
  }

  // The steps are as many as they will be for a while: are they the longest prefix so far?
  void keep() {
    const int opened = static_cast<int>(steps_.size());
    if (opened <= result_.opened) return;
    result_.opened = opened;
    result_.steps = steps_;
  }

  const PeelBodies bodies_;
  const PeelOptions& options_;
  const double sample_;
  const Run& run_;
  const int hinges_;
  PeelEffort effort_;
  int opened_ = 0;                                  // in the longest prefix
  long nodes_at_best_ = 0;                          // left when the longest prefix grew
  std::vector<std::unique_ptr<PeelLevel>> levels_;  // of those that were entered
  std::vector<PeelStep> steps_;
  Peel result_;
};

void check_options(const PeelOptions& options) {
  require(options.air > 0 && options.air < 0.5, "air", options.air, "in (0, 0.5)");
  require(options.widest >= 1 && options.widest <= kMostOpen, "widest", options.widest, "1 to 4");
  require(options.step >= 1 && 90 % options.step == 0, "step", options.step, "a divisor of 90");
  require(options.nodes >= 0, "nodes", options.nodes, "at least 0");
  require(options.patience >= 1, "patience", options.patience, "at least 1");
}

}  // namespace

Peel peel(const Linkage& chain, int sign, const PeelOptions& options, const Run& run) {
  check_options(options);
  return PeelSearch(chain, sign, options, 0, run).run();
}

Peel peel_by_samples(const Linkage& chain, int sign, double apart, const PeelOptions& options, const Run& run) {
  check_options(options);
  require(apart > 0, "apart", apart, "above 0");
  return PeelSearch(chain, sign, options, apart, run).run();
}

}  // namespace plico
