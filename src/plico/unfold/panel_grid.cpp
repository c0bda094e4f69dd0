#include "plico/unfold/panel_grid.h"

#include <algorithm>
#include <bit>

#include "plico/base/error.h"

namespace plico {

PanelGrid::PanelGrid(int panels, double extent)
    : per_unit_(1 / extent),
      mask_(std::bit_ceil(static_cast<std::size_t>(std::max(panels, 1)) * 2) - 1),
      bucket_(mask_ + 1) {}

void PanelGrid::insert(int panel, const Box2& box) {
  const FloatBox own(box);
  const Cells cells = cells_of(own);
  for (std::int32_t y = cells.y0; y <= cells.y1; ++y) {
    for (std::int32_t x = cells.x0; x <= cells.x1; ++x) {
      const std::uint32_t first = (x == cells.x0 ? kFirstColumn : 0) | (y == cells.y0 ? kFirstRow : 0);
      bucket_[slot(x, y)].push_back({own, panel, tag_of(x, y) | first});
    }
  }
}

void PanelGrid::remove(int panel, const Box2& box) {
  const Cells cells = cells_of(FloatBox(box));
  for (std::int32_t y = cells.y0; y <= cells.y1; ++y) {
    for (std::int32_t x = cells.x0; x <= cells.x1; ++x) {
      std::vector<Entry>& bucket = bucket_[slot(x, y)];
      const auto at = std::find_if(bucket.begin(), bucket.end(),
                                   [&](const Entry& e) { return e.panel == panel && (e.tag & kCell) == tag_of(x, y); });
      PLICO_ASSERT(at != bucket.end());
      *at = bucket.back();
      bucket.pop_back();
    }
  }
}

}  // namespace plico
