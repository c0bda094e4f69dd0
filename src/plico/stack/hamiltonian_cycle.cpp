#include "plico/stack/hamiltonian_cycle.h"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/stack/cyclic_sequences.h"

namespace plico {
namespace {

constexpr int kMostPairs = 8;
constexpr long kPatience = 300'000;  // tries; where it lasts, another start is the better bet

// A closed walk that takes a link away from its first square to its second, adds one from the second to the third, and
// so on; the last link, back to the first square, is added. No square comes twice.
struct Exchange {
  std::array<int, 2 * kMostPairs> squares{};
  int size = 0;

  bool has(int square) const {
    return std::find(squares.begin(), squares.begin() + size, square) != squares.begin() + size;
  }
  void push(int square) { squares[size++] = square; }
};

// Cycles that together visit every square once.
class CycleCover {
 public:
  CycleCover(const VoxelShell& shell, Rng rng)
      : shell_(shell), linked_(shell.size(), 0), sequences_(shell.size(), rng) {}

  // The squares around every vertex whose coordinates are all even or all odd: each square has one such corner.
  void make_rings() {
    for (int s = 0; s < shell_.size(); ++s) {
      const std::array<Vec3, 4> corners = corners_of(shell_.squares[s]);
      for (int i = 0; i < 4; ++i)
        if (is_centre(corners[i])) linked_[s] = static_cast<std::uint8_t>(1 << i | 1 << (i + 3) % 4);
    }
    std::vector<char> done(shell_.size(), 0);
    for (int s = 0; s < shell_.size(); ++s) {
      if (done[s]) continue;
      int root = -1;
      for (int at = s, side = side_of_link(s, 0); !done[at];) {
        done[at] = 1;
        root = sequences_.join(root, at);
        const ShellSquare& square = shell_.squares[at];
        at = square.neighbor[side];
        side = other_link(at, square.entry[side]);
      }
      firsts_.push_back(s);
    }
    num_cycles_ = static_cast<int>(firsts_.size());
    largest_ = firsts_.front();
  }

  int num_cycles() const { return num_cycles_; }
  int root(int square) const { return sequences_.root(square); }
  bool is_linked(int square, int side) const { return linked_[square] >> side & 1; }
  int side_of_link(int square, int which) const {
    for (int side = 0; side < 4; ++side)
      if (is_linked(square, side) && which-- == 0) return side;
    return -1;
  }
  int side_without_link(int square, int which) const {
    for (int side = 0; side < 4; ++side)
      if (!is_linked(square, side) && which-- == 0) return side;
    return -1;
  }
  int other_link(int square, int side) const {
    const int first = side_of_link(square, 0);
    return first == side ? side_of_link(square, 1) : first;
  }

  // A square of some cycle that is not the largest.
  int square_of_small_cycle(Rng& rng) {
    const int largest = root(largest_);
    while (!firsts_.empty()) {
      const int i = rng.below(static_cast<int>(firsts_.size()));
      const int cycle = root(firsts_[i]);
      if (cycle != largest) return sequences_.at(cycle, rng.below(sequences_.size(cycle)));
      firsts_[i] = firsts_.back();
      firsts_.pop_back();
    }
    return largest_;
  }

  // How the number of cycles would change. O(pairs log n).
  int change(const Exchange& x) {
    find_cuts(x);
    int cycles_before = 0;
    for (int i = 0; i < num_cuts_; ++i) cycles_before += i == 0 || cuts_[i].root != cuts_[i - 1].root;
    return count_joined(x) - cycles_before;
  }

  // Carries out the exchange that change() was asked about last.
  void apply(const Exchange& x, int change) {
    cut_segments();
    join_segments(x);
    for (int i = 0; i < x.size; ++i) flip_link(x.squares[i], x.squares[(i + 1) % x.size]);
    num_cycles_ += change;
  }

  std::vector<int> cycle() { return sequences_.sequence(root(largest_)); }

 private:
  // Between the element at `position` and the one after it, of which one is the start of a segment and one the end.
  struct Cut {
    int root = 0, position = 0;
    int end = 0, start = 0;  // indices into the exchange's squares
  };

  static bool is_centre(const Vec3& p) {
    const int x = static_cast<int>(p.x()), y = static_cast<int>(p.y()), z = static_cast<int>(p.z());
    return (x & 1) == (y & 1) && (y & 1) == (z & 1);
  }

  void find_cuts(const Exchange& x) {
    num_cuts_ = x.size / 2;
    for (int i = 0; i < num_cuts_; ++i) {
      const int a = x.squares[2 * i], b = x.squares[2 * i + 1];
      const int cycle = sequences_.root(a), pa = sequences_.position(a), pb = sequences_.position(b);
      const bool forward = pb == (pa + 1) % sequences_.size(cycle);
      cuts_[i] = forward ? Cut{cycle, pa, 2 * i, 2 * i + 1} : Cut{cycle, pb, 2 * i + 1, 2 * i};
    }
    std::sort(cuts_.begin(), cuts_.begin() + num_cuts_,
              [](const Cut& c, const Cut& d) { return c.root != d.root ? c.root < d.root : c.position < d.position; });
    // A segment runs from the start after one cut to the end before the next of the same cycle.
    for (int i = 0; i < num_cuts_; ++i) {
      int next = i + 1;
      if (next == num_cuts_ || cuts_[next].root != cuts_[i].root)
        for (next = i; next > 0 && cuts_[next - 1].root == cuts_[i].root;) --next;
      other_end_[cuts_[i].start] = cuts_[next].end;
      other_end_[cuts_[next].end] = cuts_[i].start;
    }
  }

  static int added_from(const Exchange& x, int i) { return i % 2 ? (i + 1) % x.size : (i + x.size - 1) % x.size; }

  int count_joined(const Exchange& x) const {
    int cycles = 0;
    std::array<bool, 2 * kMostPairs> seen{};
    for (int i = 0; i < x.size; ++i) {
      if (seen[i]) continue;
      ++cycles;
      for (int at = i; !seen[at];) {
        const int joined = added_from(x, at);
        seen[at] = seen[joined] = true;
        at = other_end_[joined];
      }
    }
    return cycles;
  }

  void cut_segments() {
    for (int i = 0; i < num_cuts_;) {
      int last = i;
      while (last + 1 < num_cuts_ && cuts_[last + 1].root == cuts_[i].root) ++last;
      // Turned so that the sequence begins after the last cut.
      const auto [before, after] = sequences_.cut(cuts_[i].root, cuts_[last].position + 1);
      int rest = sequences_.join(after, before);
      int from = cuts_[last].start, begin = cuts_[last].position - sequences_.size(rest);
      for (int c = i; c <= last; ++c) {
        const auto [segment, remaining] = sequences_.cut(rest, cuts_[c].position - begin);
        segment_[from] = segment_[cuts_[c].end] = segment;
        is_start_[from] = true;
        is_start_[cuts_[c].end] = false;
        begin = cuts_[c].position;
        from = cuts_[c].start;
        rest = remaining;
      }
      i = last + 1;
    }
  }

  void join_segments(const Exchange& x) {
    std::array<bool, 2 * kMostPairs> joined{};
    int largest = sequences_.size(root(largest_));
    for (int i = 0; i < x.size; ++i) {
      if (joined[i] || !is_start_[i]) continue;
      int whole = -1;
      for (int at = i; !joined[at];) {
        const int far = other_end_[at];
        joined[at] = joined[far] = true;
        if (!is_start_[at]) sequences_.reverse(segment_[at]);
        whole = sequences_.join(whole, segment_[at]);
        at = added_from(x, far);
      }
      firsts_.push_back(x.squares[i]);
      if (sequences_.size(whole) > largest) {
        largest = sequences_.size(whole);
        largest_ = x.squares[i];
      }
    }
  }

  void flip_link(int a, int b) {
    const ShellSquare& square = shell_.squares[a];
    for (int side = 0; side < 4; ++side) {
      if (square.neighbor[side] != b) continue;
      linked_[a] = static_cast<std::uint8_t>(linked_[a] ^ 1 << side);
      linked_[b] = static_cast<std::uint8_t>(linked_[b] ^ 1 << square.entry[side]);
      return;
    }
  }

  const VoxelShell& shell_;
  std::vector<std::uint8_t> linked_;  // of every square: a bit for each side whose neighbour is next in its cycle
  CyclicSequences sequences_;
  std::vector<int> firsts_;  // a square of every cycle that is not the largest, maybe of others too
  int largest_ = 0;          // a square of the largest cycle, as far as it was seen
  int num_cycles_ = 0;

  // The exchange at hand.
  std::array<Cut, kMostPairs> cuts_{};
  int num_cuts_ = 0;
  std::array<int, 2 * kMostPairs> other_end_{}, segment_{};
  std::array<bool, 2 * kMostPairs> is_start_{};
};

// One attempt: rings, merged until one is left or nothing more happens.
class CycleSearch {
 public:
  CycleSearch(const VoxelShell& shell, Rng rng) : shell_(shell), rng_(rng), cover_(shell, rng.stream(0)) {}

  // Ends after `most` tries, or when the last kPatience of them have not made cycles fewer.
  void search(long most, const Run& run) {
    cover_.make_rings();
    rings_ = cover_.num_cycles();
    merge_side_by_side();
    long since = 0;
    for (int cycles = cover_.num_cycles(); cycles > 1 && tries_ < most && tries_ - since < kPatience;) {
      if (tries_++ % 1024 == 0 && run.over()) return;
      walk();
      if (cover_.num_cycles() < cycles) cycles = cover_.num_cycles(), since = tries_;
    }
  }

  int rings() const { return rings_; }
  int num_cycles() const { return cover_.num_cycles(); }
  long tries() const { return tries_; }
  std::vector<int> cycle() { return cover_.cycle(); }

 private:
  int across(int square, int side) const { return shell_.squares[square].neighbor[side]; }

  // Whether two squares are neighbours without being linked.
  bool can_add(int a, int b) const {
    for (int which = 0; which < 2; ++which)
      if (across(a, cover_.side_without_link(a, which)) == b) return true;
    return false;
  }

  void merge_side_by_side() {
    for (int a = 0; a < shell_.size() && cover_.num_cycles() > 1; ++a)
      for (int choice = 0; choice < 8; ++choice) merge_at(a, choice);
  }

  void merge_at(int a, int choice) {
    Exchange x;
    x.push(a);
    extend(x, choice & 1, choice >> 1 & 1, choice >> 2 & 1);
    if (x.size != 4 || !can_add(x.squares[3], a)) return;
    if (const int change = cover_.change(x); change < 0) cover_.apply(x, change);
  }

  // From the last square: away with one of its links, a new one from there, and away with a link of that square.
  void extend(Exchange& x, int link, int added, int next_link) {
    const int a = x.squares[x.size - 1];
    const int b = across(a, cover_.side_of_link(a, link));
    if (x.has(b)) return;
    x.push(b);
    step(x, added, next_link);
  }

  bool step(Exchange& x, int added, int link) {
    const int b = x.squares[x.size - 1];
    const int c = across(b, cover_.side_without_link(b, added));
    const int d = across(c, cover_.side_of_link(c, link));
    if (x.has(c) || x.has(d) || c == d) return false;
    x.push(c);
    x.push(d);
    return true;
  }

  // One random walk; carried out as soon as it closes without making more cycles.
  void walk() {
    Exchange x;
    x.push(cover_.square_of_small_cycle(rng_));
    const std::uint64_t bits = rng_.next();
    extend(x, static_cast<int>(bits & 1), static_cast<int>(bits >> 1 & 1), static_cast<int>(bits >> 2 & 1));
    if (x.size != 4) return;
    for (int turn = 3;; turn += 2) {
      if (can_add(x.squares[x.size - 1], x.squares[0])) {
        if (const int change = cover_.change(x); change <= 0) return cover_.apply(x, change);
      }
      if (x.size == 2 * kMostPairs) return;
      if (!step(x, static_cast<int>(bits >> turn & 1), static_cast<int>(bits >> (turn + 1) & 1))) return;
    }
  }

  const VoxelShell& shell_;
  Rng rng_;
  CycleCover cover_;
  int rings_ = 0;
  long tries_ = 0;
};

}  // namespace

CycleResult find_hamiltonian_cycle(const VoxelShell& shell, const CycleOptions& options, const Run& run) {
  require(options.max_tries >= 0, "max tries", options.max_tries, "at least 0");
  if (shell.size() == 0) throw InvalidInput("stack/empty", "there is no voxel, so no square");
  if (const std::size_t pieces = pieces_of(shell).size(); pieces > 1)
    throw InvalidInput("stack/pieces", fmt::format("the shell has {} pieces, a chain needs one", pieces));
  const Rng rng(options.seed);
  CycleResult result;
  for (int attempt = 0; result.left != 1 && result.tries < options.max_tries && !run.over(); ++attempt) {
    CycleSearch search(shell, rng.stream(attempt));
    search.search(options.max_tries - result.tries, run);
    result.rings = search.rings();
    result.tries += search.tries();
    result.left = search.num_cycles();
    if (result.left == 1) result.cycle = search.cycle();
  }
  result.ending = result.left == 1 ? Ending::Found : run.over() ? run.ending() : Ending::Exhausted;
  return result;
}

}  // namespace plico
