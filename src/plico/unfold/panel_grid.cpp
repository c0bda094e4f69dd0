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
  const Cells cells = cells_of(box);
  for (std::int32_t y = cells.y0; y <= cells.y1; ++y)
    for (std::int32_t x = cells.x0; x <= cells.x1; ++x) bucket_[slot(x, y)].push_back({panel, x, y, box});
}

void PanelGrid::remove(int panel, const Box2& box) {
  const Cells cells = cells_of(box);
  for (std::int32_t y = cells.y0; y <= cells.y1; ++y) {
    for (std::int32_t x = cells.x0; x <= cells.x1; ++x) {
      std::vector<Entry>& bucket = bucket_[slot(x, y)];
      const auto at = std::find_if(bucket.begin(), bucket.end(),
                                   [&](const Entry& e) { return e.panel == panel && e.x == x && e.y == y; });
      PLICO_ASSERT(at != bucket.end());
      *at = bucket.back();
      bucket.pop_back();
    }
  }
}

}  // namespace plico
