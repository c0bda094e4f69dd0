#include "plico/stack/pile_fit.h"

#include <algorithm>
#include <bit>

#include "plico/base/error.h"

namespace plico {
namespace {

constexpr int kMostShort = 15;  // layers; longer gaps waste more than they win

// bits |= other << by, both `words` long.
void or_shifted(std::uint64_t* bits, const std::uint64_t* other, int words, int by) {
  const int whole = by / 64, part = by % 64;
  for (int i = words - 1; i >= whole; --i) {
    std::uint64_t value = other[i - whole] << part;
    if (part > 0 && i > whole) value |= other[i - whole - 1] >> (64 - part);
    bits[i] |= value;
  }
}

bool test(const std::uint64_t* bits, int at) { return (bits[at / 64] >> (at % 64) & 1) != 0; }

int lowest(const std::uint64_t* bits, int words) {
  for (int i = 0; i < words; ++i)
    if (bits[i] != 0) return 64 * i + std::countr_zero(bits[i]);
  return -1;
}

}  // namespace

void alternate(const Headings& headings, std::vector<Heading>& letters) {
  bool odd[2] = {false, false};
  for (std::size_t i = 0; i < letters.size(); ++i) odd[along_x(headings[i]) ? 0 : 1] ^= true;
  for (std::size_t i = letters.size(); i < headings.size(); ++i) {
    bool& mirrored = odd[along_x(headings[i]) ? 0 : 1];
    letters.push_back(mirrored ? opposite(headings[i]) : headings[i]);
    mirrored = !mirrored;
  }
}

std::vector<Heading> snake(int width, int depth, int symmetry) {
  const bool rows_along_y = (symmetry & 4) != 0;
  const int length = rows_along_y ? depth : width, rows = rows_along_y ? width : depth;
  Heading along = rows_along_y ? Heading::North : Heading::East;
  Heading across = rows_along_y ? Heading::East : Heading::North;
  if ((symmetry & 1) != 0) along = opposite(along);
  if ((symmetry & 2) != 0) across = opposite(across);
  std::vector<Heading> steps;
  for (int row = 0; row < rows; ++row) {
    if (row > 0) steps.push_back(across);
    steps.insert(steps.end(), length - 1, row % 2 == 0 ? along : opposite(along));
  }
  return steps;
}

bool PileReach::at_least(const PileReach& other) const {
  if (fits != other.fits) return fits;
  return piles != other.piles ? piles > other.piles : waste <= other.waste;
}

PileFit::PileFit(const std::vector<Heading>& steps, int height, int panels) : height_(height), panels_(panels) {
  const long slots = (static_cast<long>(steps.size()) + 1) * height;
  if (height < 1 || panels < 1 || slots < panels)
    throw InvalidInput("stack/too-small", fmt::format("{} piles of {} layers have {} slots for {} panels",
                                                      steps.size() + 1, height, slots, panels));
  bool odd[2] = {false, false};
  for (Heading step : steps) {
    bool& mirrored = odd[along_x(step) ? 0 : 1];
    wanted_.push_back(mirrored ? opposite(step) : step);
    mirrored = !mirrored;
  }
  slack_ = static_cast<int>(slots - panels);
  shorts_ = std::min({kMostShort, slack_, height - 1}) + 1;
  words_ = slack_ / 64 + 1;
  reach_.assign(wanted_.size() * shorts_ * words_, 0);
  mask_.resize(words_);
}

std::uint64_t* PileFit::row(int pile, int shorts) {
  return reach_.data() + (static_cast<std::size_t>(pile) * shorts_ + shorts) * words_;
}
const std::uint64_t* PileFit::row(int pile, int shorts) const {
  return reach_.data() + (static_cast<std::size_t>(pile) * shorts_ + shorts) * words_;
}

int PileFit::first_hinge_of(int pile) const { return std::max(0, (pile + 1) * height_ - 1 - slack_); }

// The last panel of pile j has number (j + 1) height - 1 - waste, and so has the hinge behind it.
bool PileFit::step(int pile, const std::vector<Heading>& letters) {
  std::fill(mask_.begin(), mask_.end(), 0);
  const int full = (pile + 1) * height_ - 1;
  for (int waste = 0; waste <= slack_; ++waste) {
    const int hinge = full - waste;
    if (hinge < 0) break;
    if (hinge < panels_ - 1 && letters[hinge] == wanted_[pile]) mask_[waste / 64] |= std::uint64_t{1} << (waste % 64);
  }
  std::uint64_t any = 0;
  for (int end = 0; end < shorts_; ++end) {
    std::uint64_t* to = row(pile, end);
    std::fill(to, to + words_, 0);
    if (pile == 0)
      to[0] |= end < 64 ? std::uint64_t{1} << end : 0;
    else
      for (int begin = 0; begin < shorts_ && begin + end < height_; ++begin)
        or_shifted(to, row(pile - 1, begin), words_, begin + end);
    for (int i = 0; i < words_; ++i) any |= to[i] &= mask_[i];
  }
  return any != 0;
}

bool PileFit::ends_in(int pile) const {
  const long slots = (static_cast<long>(pile) + 1) * height_ - panels_;  // of these, left empty
  if (slots < 0) return false;
  if (pile == 0) return true;
  for (int begin = 0; begin < shorts_; ++begin) {
    const int waste = lowest(row(pile - 1, begin), words_);
    if (waste >= 0 && waste + begin <= slots) return true;
  }
  return false;
}

int PileFit::least_waste(int pile) const {
  int least = slack_ + 1;
  for (int end = 0; end < shorts_; ++end)
    if (const int waste = lowest(row(pile, end), words_); waste >= 0) least = std::min(least, waste + end);
  return least;
}

PileReach PileFit::look(const std::vector<Heading>& letters, int first_changed) {
  int pile = 0;
  while (pile < known_ && (pile + 1) * height_ - 1 < first_changed) ++pile;
  last_pile_ = -1;
  const int piles = static_cast<int>(wanted_.size()) + 1;
  for (; pile < piles; ++pile) {
    known_ = pile;
    if (ends_in(pile)) {
      last_pile_ = pile;
      return {true, pile, 0};
    }
    const bool known = static_cast<long>(letters.size()) >= std::min<long>(panels_ - 1, (pile + 1L) * height_);
    if (!known) return {false, pile, pile > 0 ? least_waste(pile - 1) : 0, true};
    if (pile + 1 == piles || !step(pile, letters)) break;
  }
  return {false, pile, pile > 0 ? least_waste(pile - 1) : 0};
}

std::vector<StackFold> PileFit::folds() const {
  PLICO_ASSERT(last_pile_ >= 0);
  std::vector<int> leave(last_pile_);  // hinges between piles
  int waste = -1, end = -1;
  for (int pile = last_pile_ - 1; pile >= 0; --pile) {
    if (pile == last_pile_ - 1) {
      const long empty = (static_cast<long>(last_pile_) + 1) * height_ - panels_;
      for (end = 0; waste < 0; ++end) {
        waste = lowest(row(pile, end), words_);
        if (waste + end > empty) waste = -1;
      }
      --end;
    } else {
      int begin = 0;  // of the pile above, which is the end of this one
      while (waste - begin - end < 0 || !test(row(pile, begin), waste - begin - end)) ++begin;
      waste -= begin + end;
      end = begin;
    }
    leave[pile] = (pile + 1) * height_ - 1 - waste;
  }
  std::vector<StackFold> folds(panels_ - 1);
  bool up = true, front_up = true;
  std::size_t next = 0;
  for (int hinge = 0; hinge + 1 < panels_; ++hinge) {
    if (next < leave.size() && leave[next] == hinge) {
      ++next;
      up = !up;
      continue;  // flat
    }
    folds[hinge] = up == front_up ? StackFold::Valley : StackFold::Mountain;
    front_up = !front_up;
  }
  return folds;
}

}  // namespace plico
