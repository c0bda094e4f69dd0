#include "plico/stack/lattice.h"

#include <algorithm>
#include <cstdlib>

#include "plico/base/error.h"
#include "plico/base/vec.h"

namespace plico {
namespace {

constexpr StackFold kFolds[] = {StackFold::Valley, StackFold::Flat, StackFold::Mountain};

// Slots that a chain of n panels can reach from the middle of a cube.
class Occupied {
 public:
  explicit Occupied(std::size_t panels)
      : side_(2 * static_cast<int>(panels) + 1), taken_(static_cast<std::size_t>(side_) * side_ * side_, 0) {}
  char& at(const Slot& s) {
    const int half = side_ / 2;
    return taken_[(static_cast<std::size_t>(s.layer + half) * side_ + s.y + half) * side_ + s.x + half];
  }

 private:
  int side_;
  std::vector<char> taken_;
};

struct Bounds {
  Slot low, high;
  void add(const Slot& s) {
    low = {std::min(low.x, s.x), std::min(low.y, s.y), std::min(low.layer, s.layer)};
    high = {std::max(high.x, s.x), std::max(high.y, s.y), std::max(high.layer, s.layer)};
  }
  StackBox box() const { return {high.x - low.x + 1, high.y - low.y + 1, high.layer - low.layer + 1}; }
};

bool fits(const StackBox& inner, const StackBox& outer) {
  const bool straight = inner.width <= outer.width && inner.depth <= outer.depth;
  const bool turned = inner.width <= outer.depth && inner.depth <= outer.width;
  return inner.height <= outer.height && (straight || turned);
}

long stacks_from(const Headings& headings, std::size_t hinge, const StackWalk& walk, Occupied& occupied) {
  if (hinge == headings.size()) return 1;
  long count = 0;
  for (StackFold fold : kFolds) {
    StackWalk next = walk;
    next.pass(headings[hinge], fold);
    char& taken = occupied.at(next.slot());
    if (taken) continue;
    taken = 1;
    count += stacks_from(headings, hinge + 1, next, occupied);
    taken = 0;
  }
  return count;
}

bool packs(const Headings& headings, std::size_t hinge, const StackWalk& walk, const Bounds& bounds,
           const StackBox& box, Occupied& occupied) {
  if (hinge == headings.size()) return true;
  for (StackFold fold : kFolds) {
    StackWalk next = walk;
    next.pass(headings[hinge], fold);
    Bounds grown = bounds;
    grown.add(next.slot());
    char& taken = occupied.at(next.slot());
    if (taken || !fits(grown.box(), box)) continue;
    taken = 1;
    const bool done = packs(headings, hinge + 1, next, grown, box, occupied);
    taken = 0;
    if (done) return true;
  }
  return false;
}

}  // namespace

Heading StackWalk::flat_direction(Heading heading) const {
  return mirrored_[along_x(heading) ? 0 : 1] ? opposite(heading) : heading;
}

void StackWalk::pass(Heading heading, StackFold fold) {
  if (fold == StackFold::Flat) {
    const Heading to = flat_direction(heading);
    const int step = index(to) < 2 ? 1 : -1;
    (along_x(to) ? slot_.x : slot_.y) += step;
    return;
  }
  slot_.layer += (fold == StackFold::Valley) == front_up_ ? 1 : -1;
  front_up_ = !front_up_;
  bool& mirrored = mirrored_[along_x(heading) ? 0 : 1];
  mirrored = !mirrored;
}

std::vector<Slot> stack_slots(const Headings& headings, const std::vector<StackFold>& folds) {
  if (headings.size() != folds.size())
    throw InvalidInput("stack/folds", fmt::format("{} folds for {} hinges", folds.size(), headings.size()));
  StackWalk walk;
  std::vector<Slot> slots{walk.slot()};
  slots.reserve(headings.size() + 1);
  for (std::size_t i = 0; i < headings.size(); ++i) {
    walk.pass(headings[i], folds[i]);
    slots.push_back(walk.slot());
  }
  return slots;
}

bool all_distinct(std::vector<Slot> slots) {
  std::sort(slots.begin(), slots.end());
  return std::adjacent_find(slots.begin(), slots.end()) == slots.end();
}

StackBox box_of(const std::vector<Slot>& slots) {
  if (slots.empty()) return {};
  Bounds bounds{slots.front(), slots.front()};
  for (const Slot& slot : slots) bounds.add(slot);
  return bounds.box();
}

std::vector<double> fold_angles(const std::vector<StackFold>& folds) {
  std::vector<double> angles;
  angles.reserve(folds.size());
  for (StackFold fold : folds) angles.push_back(static_cast<int>(fold) * kPi);
  return angles;
}

long count_stacks(const Headings& headings) {
  Occupied occupied(headings.size() + 1);
  const StackWalk walk;
  occupied.at(walk.slot()) = 1;
  return stacks_from(headings, 0, walk, occupied);
}

int least_layers(const Headings& headings, int width, int depth, int most) {
  Occupied occupied(headings.size() + 1);
  const StackWalk walk;
  occupied.at(walk.slot()) = 1;
  const long panels = static_cast<long>(headings.size()) + 1, base = static_cast<long>(width) * depth;
  for (int height = static_cast<int>((panels + base - 1) / base); height <= most; ++height)
    if (packs(headings, 0, walk, {}, {width, depth, height}, occupied)) return height;
  return most + 1;
}

}  // namespace plico
