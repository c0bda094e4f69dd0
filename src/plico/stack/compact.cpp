#include "plico/stack/compact.h"

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr int kMostEdges = 8;    // exchanged at once
constexpr long kStall = 60'000;  // exchanges without progress before a fresh start
constexpr int kPollEvery = 256;  // exchanges

// One chain over one boustrophedon of one height, and how far it gets.
class Attempt {
 public:
  Attempt(const SquareGraph& graph, std::vector<int> path, const CompactOptions& options, int symmetry, int height)
      : graph_(&graph),
        exchange_(graph, std::move(path), options.reach),
        fit_(snake(options.width, options.depth, symmetry), height, graph.size()),
        panels_(graph.size()) {
    reach_ = look(0);
  }

  const PileReach& reach() const { return reach_; }
  bool fits() const { return reach_.fits; }

  // One random exchange near the pile where the chain fails; true when it got farther. Slots that were left empty came
  // before, so the panel that fails is that much nearer to the beginning.
  bool improve(Rng& rng) {
    const int back = rng.below(3), h = fit_.height();
    const int fixed = std::max(0, (reach_.piles - back) * h - 1 - reach_.waste - rng.below(h));
    const int end = std::min(panels_, (reach_.piles + 1) * h);
    const int start = fixed + rng.below(std::max(1, end - fixed));
    const int first = exchange_.exchange(std::min(start, panels_ - 1), fixed, kMostEdges, rng);
    if (first < 0) return false;
    const PileReach reach = look(first - 1);
    if (!reach.at_least(reach_)) {
      exchange_.undo();
      stale_ = std::min(stale_, first - 1);
      return false;
    }
    const bool farther = !reach_.at_least(reach);
    reach_ = reach;
    return farther;
  }

  Stack stack() const {
    Stack stack{exchange_.path(), strip_headings(*graph_, exchange_.path()), fit_.folds(), {}};
    stack.box = box_of(stack_slots(stack.headings, stack.folds));
    return stack;
  }

 private:
  // Hinges from `first_changed` on are others than at the last look. Letters are made as far as the look needs them.
  PileReach look(int first_changed) {
    int first = std::max(0, std::min(first_changed, stale_));
    stale_ = panels_;
    if (headings_.size() > static_cast<std::size_t>(first)) headings_.resize(first);
    if (letters_.size() > headings_.size()) letters_.resize(headings_.size());
    PileReach reach = fit_.look(letters_, first);
    while (reach.wants_letters) {
      first = static_cast<int>(letters_.size());
      extend(std::max<long>((reach.piles + 2L) * fit_.height(), first + 1));
      reach = fit_.look(letters_, first);
    }
    return reach;
  }

  void extend(long hinges) {
    strip_headings(*graph_, exchange_.path(), headings_, std::min<long>(hinges, panels_ - 1));
    alternate(headings_, letters_);
  }

  const SquareGraph* graph_;
  PathExchange exchange_;
  PileFit fit_;
  int panels_;
  Headings headings_;
  std::vector<Heading> letters_;
  PileReach reach_;
  int stale_ = 0;  // what the fit knows from here on is of an exchange that was undone
};

struct Search {
  const SquareGraph& graph;
  const std::vector<int>& cycle;
  bool closed;
  const CompactOptions& options;
  const Run& run;
  Rng rng;
  CompactResult result;
  int floor = 1;  // layers that are low enough

  // The cycle cut at a random place, run one way or the other.
  std::vector<int> random_cut() {
    std::vector<int> path = cycle;
    if (closed) std::rotate(path.begin(), path.begin() + rng.below(graph.size()), path.end());
    if (rng.below(2) == 1) std::reverse(path.begin(), path.end());
    return path;
  }
  Attempt attempt(int height) {
    std::vector<int> path = random_cut();
    const int symmetry = rng.below(8);
    return {graph, std::move(path), options, symmetry, height};
  }
  int height() const { return result.best.box.height; }
  bool take(const Attempt& attempt) {
    if (!attempt.fits()) return false;
    Stack stack = attempt.stack();
    if (result.best.path.empty() || stack.box.height < height()) result.best = std::move(stack);
    return true;
  }
};

// Some stack at once: heights are doubled until a few cuts find one.
void first_stack(Search& search) {
  const int panels = search.graph.size();
  for (int more = 0;; more = more == 0 ? 1 : 2 * more) {
    const int height = std::min(panels, search.floor + more);
    for (int i = 0; i < 16; ++i)
      if (search.take(search.attempt(height))) return;
  }
}

// Lower stacks by cuts alone, as long as every height has one.
void try_cuts(Search& search) {
  int left = search.options.cuts;
  while (search.height() > search.floor && left > 0 && !search.run.over()) {
    const int height = search.floor + (search.height() - search.floor) / 2;
    bool lower = false;
    for (int i = 0; i < std::max(16, search.options.cuts / 8) && left > 0 && !lower && !search.run.over(); ++i, --left)
      lower = search.take(search.attempt(height));
    if (!lower) return;
  }
}

// The cut that gets farthest of a few.
Attempt best_cut(Search& search, int height) {
  Attempt best = search.attempt(height);
  for (int i = 1; i < 32 && !best.fits(); ++i) {
    Attempt other = search.attempt(height);
    if (other.reach().at_least(best.reach())) best = std::move(other);
  }
  return best;
}

// The lowest height is tried first and every second time; in between one halfway, so that a chain that does not become
// perfect becomes better.
void exchange_squares(Search& search) {
  CompactResult& result = search.result;
  bool halfway = false;
  while (search.height() > search.floor && result.exchanges < search.options.exchanges && !search.run.over()) {
    Attempt attempt = best_cut(search, search.floor + (halfway ? (search.height() - search.floor) / 2 : 0));
    halfway = !halfway;
    for (long idle = 0; idle < kStall && !attempt.fits() && result.exchanges < search.options.exchanges; ++idle) {
      if (++result.exchanges % kPollEvery == 0 && search.run.over()) break;
      if (attempt.improve(search.rng)) idle = 0;
    }
    search.take(attempt);
  }
}

void check(const CompactOptions& options, int panels) {
  require(options.width >= 1, "width", options.width, "at least 1");
  require(options.depth >= 1, "depth", options.depth, "at least 1");
  require(static_cast<long>(options.width) * options.depth <= panels, "base",
          fmt::format("{}x{}", options.width, options.depth), fmt::format("of at most {} panels", panels));
  require(options.cuts >= 1, "cuts", options.cuts, "at least 1");
  require(options.exchanges >= 0, "exchanges", options.exchanges, "at least 0");
}

}  // namespace

int ideal_layers(int panels, int width, int depth) {
  const long base = static_cast<long>(width) * depth;
  return static_cast<int>((panels + base - 1) / base);
}

CompactResult compact_stack(const SquareGraph& graph, const std::vector<int>& cycle, bool closed,
                            const CompactOptions& options, const Run& run) {
  check(options, graph.size());
  const bool closes = closed && graph.side_to(cycle.back(), cycle.front()) >= 0;
  Search search{graph, cycle, closes, options, run, Rng(options.seed), {}};
  search.floor = std::max(options.height, ideal_layers(graph.size(), options.width, options.depth));
  first_stack(search);
  try_cuts(search);
  exchange_squares(search);
  CompactResult& result = search.result;
  if (search.height() <= search.floor)
    result.ending = Ending::Found;
  else if (run.over())
    result.ending = run.ending();
  return std::move(result);
}

double size_sum(const StackBox& box, double thickness) { return box.width + box.depth + thickness * box.height; }

std::optional<StackBox> best_base_in(const StackBox& room, int panels, double thickness) {
  const auto [narrow, wide] = std::minmax(room.width, room.depth);
  std::optional<StackBox> best;
  for (int width = 1; width <= narrow && static_cast<long>(width) * width <= panels; ++width) {
    for (int depth = width; depth <= wide && static_cast<long>(width) * depth <= panels; ++depth) {
      if (best && width + depth > size_sum(*best, thickness)) break;
      const StackBox box{width, depth, ideal_layers(panels, width, depth)};
      if (box.height > room.height) continue;
      // Of bases that are equally good, the one with the lower piles.
      if (!best || size_sum(box, thickness) <= size_sum(*best, thickness) * (1 + 1e-12)) best = box;
    }
  }
  return best;
}

StackBox best_base(int panels, double thickness) { return *best_base_in({panels, panels, panels}, panels, thickness); }

}  // namespace plico
