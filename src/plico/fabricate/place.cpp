#include "plico/fabricate/place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fabricate/cells.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/geom/rectangle_fit.h"

namespace plico {
namespace {

constexpr std::size_t kFew = 60;  // parts that are placed with care even when the run is over
constexpr double kCell = 1;       // millimetres
constexpr double kKeyGap = 3;

// An item turned by some angle, as cells; `corner` is the lower left corner of its box.
struct Turned {
  double angle = 0;
  Vec2 corner, size;
  Cells cells{0, 0};
};

Eigen::AlignedBox2d turned_box(const PlaceItem& item, double angle) {
  const Eigen::Matrix2d turn = rotation(angle);
  Eigen::AlignedBox2d box;
  for (const Vec2& p : item.hull) box.extend(turn * p);
  return box;
}

Turned turned(const PlaceItem& item, double angle) {
  const Eigen::AlignedBox2d box = turned_box(item, angle);
  Turned t{angle, box.min(), box.sizes(),
           Cells(static_cast<int>(box.sizes().x() / kCell) + 2, static_cast<int>(box.sizes().y() / kCell) + 2)};
  const Eigen::Matrix2d turn = rotation(angle);
  std::vector<Vec2> moved;
  for (const auto& piece : item.pieces) {
    moved.clear();
    for (const Vec2& p : piece) moved.push_back((turn * p - t.corner) / kCell);
    t.cells.cover(moved);
  }
  return t;
}

struct Spot {
  int x = 0, y = 0;
  Vec2 size;
};

// The forms that a wish allows, the fullest first.
std::vector<KeyForm> forms(KeyWish wish) {
  if (wish == KeyWish::None) return {};
  if (wish == KeyWish::Ruler) return {KeyForm::RulerOnly};
  return {KeyForm::Row, KeyForm::Stack, KeyForm::RulerOnly};
}

// A page being filled.
class PageFiller {
 public:
  PageFiller(const PageOptions& page, const PlaceOptions& options)
      : page_(&page),
        wanted_(options.key),
        room_(printable(page)),
        gap_(options.gap),
        taken_(static_cast<int>(std::ceil(room_.x() / kCell)), static_cast<int>(std::ceil(room_.y() / kCell))) {}

  // Keeps the lower edge free for the key.
  void reserve_key(KeyForm form, double ruler) {
    const Vec2 size = key_size(form, ruler);
    const double height = form == KeyForm::None ? 0 : size.y() + kKeyGap - gap_;
    for (int y = 0; y < static_cast<int>(std::ceil(height / kCell)); ++y) taken_.set_row(y, 0, taken_.width() - 1);
    key_ = form;
    key_at_ = Vec2((room_.x() - size.x()) / 2, 0);
    reserved_ = form == KeyForm::None ? 0 : size.y() + kKeyGap;
  }

  // The lowest, then leftmost free place.
  std::optional<Spot> find(const Turned& t, const Cells& grown) const {
    const int r = static_cast<int>(std::ceil(radius()));
    const int last_x = static_cast<int>(std::floor((room_.x() - t.size.x()) / kCell));
    const int last_y = static_cast<int>(std::floor((room_.y() - t.size.y()) / kCell));
    for (int y = 0; y <= last_y; ++y)
      for (int x = 0; x <= last_x; ++x)
        if (!taken_.hit_by(grown, x - r, y - r)) return Spot{x, y, t.size};
    return std::nullopt;
  }

  void put(const Turned& t, const Spot& spot, int item) {
    taken_.add(t.cells, spot.x, spot.y);
    items_.push_back({item, t.angle, Vec2(spot.x, spot.y) * kCell - t.corner});
    used_.extend(Eigen::AlignedBox2d(Vec2(spot.x, spot.y) * kCell, Vec2(spot.x, spot.y) * kCell + t.size));
  }

  // A part that needs the whole page stands at its top, alone.
  void put_alone(const PlaceItem& item, int index, double angle) {
    const Turned t = turned(item, angle);
    const Vec2 at = (room_ - t.size).cwiseMax(0).cwiseProduct(Vec2(0.5, 1));
    taken_ = Cells(taken_.width(), taken_.height());
    std::vector<Vec2> moved;
    const Eigen::Matrix2d turn = rotation(angle);
    for (const auto& piece : item.pieces) {
      moved.clear();
      for (const Vec2& p : piece) moved.push_back((turn * p - t.corner + at) / kCell);
      taken_.cover(moved);
    }
    key_ = KeyForm::None;
    items_.push_back({index, angle, at - t.corner});
    alone_ = true;
  }

  // Where someone wants it, in the page's coordinates; what lies there already stays.
  void put_given(const PlaceItem& item, int index, const Placement& at) {
    const Vec2 margin = page_->margin.low();
    std::vector<Vec2> moved;
    for (const auto& piece : item.pieces) {
      moved.clear();
      for (const Vec2& p : piece) moved.push_back((at(p) - margin) / kCell);
      taken_.cover(moved);
      for (const Vec2& p : moved) hides_key_ = hides_key_ || p.y() * kCell < reserved_;
    }
    items_.push_back({index, at.angle, at.shift - margin});
    given_ = true;
  }

  double radius() const { return gap_ / kCell + 0.5; }
  bool empty() const { return items_.empty(); }
  bool alone() const { return alone_; }
  int first_item() const {
    return std::min_element(items_.begin(), items_.end(), [](const Item& a, const Item& b) { return a.item < b.item; })
        ->item;
  }

  // The finished page; parts are moved to the middle of the room above the key.
  Page finish(int number, double ruler, std::vector<Placement>& placements) {
    Page page;
    page.size = page_->size;
    page.ruler = ruler;
    const Vec2 margin = page_->margin.low();
    Vec2 shift = margin;
    if (alone_ || hides_key_) {
      find_key(page);
    } else {
      page.key_form = key_;
      page.key_at = key_at_ + margin;
    }
    if (!alone_ && !given_) {
      const Vec2 low(0, reserved_), room = room_ - low;
      shift += low + (room - used_.sizes()) / 2 - used_.min();
    }
    for (const auto& [item, angle, at] : items_) placements[item] = {number, angle, at + shift};
    return page;
  }

 private:
  // Somewhere on a page that one part fills: the fullest form for which there is room.
  void find_key(Page& page) const {
    for (KeyForm form : forms(wanted_)) {
      for (bool upright : {true, false}) {
        Vec2 size = key_size(form, page.ruler);
        if (!upright) std::swap(size.x(), size.y());
        Turned t{0, Vec2::Zero(), size,
                 Cells(static_cast<int>(std::ceil(size.x())), static_cast<int>(std::ceil(size.y())))};
        for (int y = 0; y < t.cells.height(); ++y) t.cells.set_row(y, 0, t.cells.width() - 1);
        const std::optional<Spot> spot = find(t, t.cells.grown(radius()));
        if (!spot) continue;
        page.key_form = form;
        page.key_upright = upright;
        page.key_at = Vec2(spot->x, spot->y) * kCell + page_->margin.low();
        return;
      }
    }
  }

  struct Item {
    int item;
    double angle;
    Vec2 at;
  };
  const PageOptions* page_;
  KeyWish wanted_;
  Vec2 room_;
  double gap_;
  Cells taken_;
  std::vector<Item> items_;
  Eigen::AlignedBox2d used_;
  KeyForm key_ = KeyForm::None;
  Vec2 key_at_ = Vec2::Zero();
  double reserved_ = 0;
  bool alone_ = false, given_ = false, hides_key_ = false;
};

// The direction that most sides share up to quarter turns, when most do: the grain of a box-like part.
std::optional<double> grain(const PlaceItem& item) {
  double x = 0, y = 0, all = 0;
  for (const auto& piece : item.pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Vec2 side = piece[(i + 1) % piece.size()] - piece[i];
      const double angle = 4 * plico::atan2(side.y(), side.x()), length = side.norm();
      x += length * plico::cos(angle);
      y += length * plico::sin(angle);
      all += length;
    }
  }
  if (plico::hypot(x, y) < 0.6 * all) return std::nullopt;
  return plico::atan2(y, x) / 4;
}

// Rotations to try: along the grain or the least rectangle, then in between; fewer when there are many parts.
std::vector<double> rotations(const PlaceItem& item, std::size_t num_items, const Vec2& room) {
  double base = -grain(item).value_or(least_area_rectangle(item.hull).angle);
  const Vec2 size = turned_box(item, base).sizes();
  if ((size.x() > size.y()) != (room.x() > room.y())) base += kPi / 2;  // long side along long side
  const int steps = num_items <= kFew ? 12 : 4;
  std::vector<double> angles;
  for (int i = 0; i < steps; ++i) angles.push_back(base + i * 2 * kPi / steps);
  if (const auto fits = angle_that_fits(item.hull, room)) angles.push_back(*fits);
  return angles;
}

KeyForm key_that_fits(const Vec2& room, KeyWish wish, double& ruler) {
  for (double length : {100.0, 50.0, 20.0}) {
    ruler = length;
    for (KeyForm form : forms(wish))
      if (key_size(form, length).x() <= room.x()) return form;
  }
  return KeyForm::None;
}

class Placer {
 public:
  Placer(const std::vector<PlaceItem>& items, const PageOptions& page, const PlaceOptions& options,
         const std::vector<std::optional<Placement>>& given)
      : items_(items),
        page_(page),
        options_(options),
        given_(given),
        room_(printable(page)),
        form_(key_that_fits(room_, options.key, ruler_)) {}

  Placed run(const Run& run) {
    std::vector<int> order(items_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater<>(), [&](int i) { return signed_area(items_[i].hull); });
    int done = 0;
    const bool any_given = put_all_given();
    for (int i : order) {
      run.report("placing parts", done++, static_cast<long>(order.size()));
      if (!is_given(i)) add(i, items_.size() > kFew && run.over());
    }
    std::erase_if(pages_, [](const PageFiller& page) { return page.empty(); });
    if (!any_given) std::ranges::stable_sort(pages_, {}, &PageFiller::first_item);  // part A on page 1
    Placed placed;
    placed.placements.resize(items_.size());
    for (std::size_t p = 0; p < pages_.size(); ++p)
      placed.pages.push_back(pages_[p].finish(static_cast<int>(p), ruler_, placed.placements));
    double area = 0;
    for (const PlaceItem& item : items_) area += item.area;
    if (!pages_.empty()) placed.fill_ratio = area / (room_.prod() * static_cast<double>(pages_.size()));
    return placed;
  }

 private:
  bool is_given(std::size_t i) const { return i < given_.size() && given_[i].has_value(); }
  bool put_all_given() {
    bool any = false;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (!is_given(i)) continue;
      any = true;
      while (static_cast<int>(pages_.size()) <= given_[i]->page) pages_.push_back(new_page());
      pages_[given_[i]->page].put_given(items_[i], static_cast<int>(i), *given_[i]);
    }
    return any;
  }

  // In a hurry the first way that fits is taken, on the last page or a new one.
  void add(int i, bool hurry) {
    std::vector<Turned> ways;
    std::vector<Cells> grown;
    for (double angle : rotations(items_[i], items_.size(), room_)) {
      const Vec2 size = turned_box(items_[i], angle).sizes();
      if (size.x() > room_.x() || size.y() > room_.y()) continue;
      ways.push_back(turned(items_[i], angle));
      grown.push_back(ways.back().cells.grown(options_.gap / kCell + 0.5));
      if (hurry) break;
    }
    if (ways.empty()) throw InvalidInput("fabricate/part-too-large", fmt::format("part {} fits no page", i));
    const std::size_t first = hurry && !pages_.empty() ? pages_.size() - 1 : 0;
    for (std::size_t p = first; p < pages_.size(); ++p)
      if (!pages_[p].alone() && put_lowest(pages_[p], i, ways, grown)) return;
    pages_.push_back(new_page());
    if (!put_lowest(pages_.back(), i, ways, grown)) pages_.back().put_alone(items_[i], i, ways.back().angle);
  }

  PageFiller new_page() const {
    PageFiller page(page_, options_);
    page.reserve_key(form_, ruler_);
    return page;
  }

  bool put_lowest(PageFiller& page, int item, const std::vector<Turned>& ways, const std::vector<Cells>& grown) {
    std::optional<Spot> best;
    std::size_t way = 0;
    const auto cost = [](const Spot& s) { return std::pair(s.y * kCell + s.size.y(), s.x * kCell + s.size.x()); };
    for (std::size_t w = 0; w < ways.size(); ++w) {
      if (best && items_.size() == 1) break;  // nothing else to make room for: the straight way looks best
      const std::optional<Spot> spot = page.find(ways[w], grown[w]);
      if (spot && (!best || cost(*spot) < cost(*best))) best = spot, way = w;
    }
    if (best) page.put(ways[way], *best, item);
    return best.has_value();
  }

  const std::vector<PlaceItem>& items_;
  const PageOptions& page_;
  const PlaceOptions& options_;
  const std::vector<std::optional<Placement>>& given_;
  Vec2 room_;
  double ruler_ = 100;
  KeyForm form_;
  std::vector<PageFiller> pages_;
};

}  // namespace

Vec2 key_size(KeyForm form, double ruler) {
  switch (form) {
    case KeyForm::Row:
      return {ruler + 75, 9};
    case KeyForm::Stack:
      return {ruler + 2, 21};
    case KeyForm::RulerOnly:
      return {ruler + 2, 8};
    case KeyForm::None:
      break;
  }
  return Vec2::Zero();
}

Placed place(const std::vector<PlaceItem>& items, const PageOptions& page, const PlaceOptions& options, const Run& run,
             const std::vector<std::optional<Placement>>& given) {
  check(page);
  if (!(options.gap >= 0 && options.gap <= 100))
    throw InvalidOption(fmt::format("gap = {:g} mm must be in [0, 100] mm", options.gap));
  return Placer(items, page, options, given).run(run);
}

}  // namespace plico
