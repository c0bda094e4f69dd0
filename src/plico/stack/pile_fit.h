// Does a chain fit into a block, pile after pile in a given order? All stacks of this kind at once, by bit sets.
//
// Every cell of the base holds one pile, walked from its base to its roof or back; between piles one hinge stays flat.
// A pile may end a few layers short of the roof or base, where the next one begins. A hinge can lead from one pile to
// the next exactly when their *alternating headings* agree (StackWalk: s_i (-1)^k of the hinge, direction times (-1)^m
// of the step), so all that matters of a chain is one of four letters a hinge.
#pragma once
#include <cstdint>
#include <vector>

#include "plico/stack/lattice.h"

namespace plico {

// The heading of each hinge, mirrored once for each earlier hinge on its axis. Appends to `letters` from its end on.
void alternate(const Headings& headings, std::vector<Heading>& letters);

// The steps of a boustrophedon over width x depth cells: rows there and back. `symmetry` in [0, 8) picks the corner
// where it starts and whether rows run along x or along y. Every earlier pile is out of the lane of a step (lane rule).
std::vector<Heading> snake(int width, int depth, int symmetry);

// How far a chain gets into a block.
struct PileReach {
  bool fits = false;
  int piles = 0;               // that could be filled and left again
  int waste = 0;               // fewest slots left empty in these piles
  bool wants_letters = false;  // the letters ended before the answer was known
  auto operator<=>(const PileReach&) const = default;
  bool at_least(const PileReach& other) const;  // farther, or as far with no more waste
};

class PileFit {
 public:
  // Piles in the order of `steps`, one more than steps, each at most `height` panels; `panels` of the chain. Throws
  // InvalidInput when the block has fewer slots than panels.
  PileFit(const std::vector<Heading>& steps, int height, int panels);

  // Looks at the chain with these alternating headings. What is known of piles that end before `first_changed` hinge is
  // kept from the last call. There may be fewer letters than hinges: see wants_letters. O(piles * (slack + shorts^2 *
  // slack / 64)).
  PileReach look(const std::vector<Heading>& letters, int first_changed = 0);

  // The folds of a stack after a look that `fits`: one a hinge; first panel with its front up at the base.
  std::vector<StackFold> folds() const;

  int height() const { return height_; }
  int first_hinge_of(int pile) const;  // the earliest hinge by which that pile can be left

 private:
  using Bits = std::vector<std::uint64_t>;  // bit w: reachable with w slots wasted
  bool step(int pile, const std::vector<Heading>& letters);
  bool ends_in(int pile) const;  // can all panels that are left lie in this pile?
  std::uint64_t* row(int pile, int shorts);
  const std::uint64_t* row(int pile, int shorts) const;
  int least_waste(int pile) const;

  std::vector<Heading> wanted_;  // letters of the steps
  int height_, panels_, shorts_, slack_, words_;
  std::vector<std::uint64_t> reach_;  // pile x shorts at its end x words
  Bits mask_;
  int known_ = 0;       // piles whose rows are valid
  int last_pile_ = -1;  // where the chain ended in the last look
};

}  // namespace plico
