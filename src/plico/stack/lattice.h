// Where the panels of a stack lie: cells (x, y), layer above layer. Each hinge of a stack is folded by +180 degrees, by
// -180 degrees or stays flat, so the chain is a walk through slots. Source: [Xi17] 6.3.4; the rule is exact for panels
// of any thickness (a test holds it against thick boxes).
#pragma once
#include <compare>
#include <cstdint>
#include <vector>

namespace plico {

// Directions in the plane, a quarter turn to the left apart: East is +x, North is +y.
enum class Heading : std::uint8_t { East, North, West, South };
constexpr int index(Heading h) { return static_cast<int>(h); }
constexpr bool along_x(Heading h) { return index(h) % 2 == 0; }
constexpr Heading turned(Heading h, int left_turns) { return static_cast<Heading>((index(h) + left_turns) & 3); }
constexpr Heading opposite(Heading h) { return turned(h, 2); }

// How a strip of squares runs when it is laid flat: the direction in which it crosses each hinge, one less than panels.
using Headings = std::vector<Heading>;

enum class StackFold : std::int8_t { Mountain = -1, Flat = 0, Valley = 1 };  // -180, 0, +180 degrees

struct Slot {
  int x = 0, y = 0, layer = 0;
  auto operator<=>(const Slot&) const = default;
};

// Boxes of slots, in panels.
struct StackBox {
  int width = 0, depth = 0, height = 0;
  long slots() const { return static_cast<long>(width) * depth * height; }
  bool operator==(const StackBox&) const = default;
};

// A stack of one chain, first panel in slot (0, 0, 0) with its front up.
//   - A fold goes one layer up or down in the same cell: a valley up while the front looks up.
//   - A flat hinge goes to the neighbour cell on its heading, mirrored once for each earlier fold on the same axis:
//     s_i (-1)^(k - m) for the k-th hinge on its axis with m flat ones before it.
// The walk is a stack exactly when no slot comes twice.
class StackWalk {
 public:
  const Slot& slot() const { return slot_; }
  bool front_up() const { return front_up_; }
  Heading flat_direction(Heading heading) const;
  void pass(Heading heading, StackFold fold);

 private:
  Slot slot_;
  bool front_up_ = true;
  bool mirrored_[2] = {false, false};  // x, y
};

// The slot of every panel. O(n). Throws InvalidInput unless there is one fold a heading.
std::vector<Slot> stack_slots(const Headings& headings, const std::vector<StackFold>& folds);

bool all_distinct(std::vector<Slot> slots);                            // O(n log n)
StackBox box_of(const std::vector<Slot>& slots);                       // the least one around them
std::vector<double> fold_angles(const std::vector<StackFold>& folds);  // radians

// All stacks of a chain whose first panel is fixed. Exponential: for small chains.
long count_stacks(const Headings& headings);

// The fewest layers of any stack of the chain on a base of width x depth cells, either way round, by looking at all of
// them; `most` + 1 when it has none of at most `most` layers. Exponential: for small chains.
int least_layers(const Headings& headings, int width, int depth, int most);

}  // namespace plico
