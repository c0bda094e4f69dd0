// Placing parts on pages: true shapes on a raster, largest first, lowest place first, several rotations each.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fabricate/page.h"
#include "plico/fold/page_layout.h"

namespace plico {

// Which block is kept free for: legend with ruler, the ruler alone, or none.
enum class KeyWish { All, Ruler, None };

struct PlaceOptions {
  double gap = 3;  // between parts, millimetres, at least 0
  KeyWish key = KeyWish::All;
};

struct PlaceItem {
  std::vector<std::vector<Vec2>> pieces;  // convex, counter-clockwise: panels and tabs, millimetres
  std::vector<Vec2> hull;                 // of all of them
  double area = 0;                        // covered
};

struct Placement {
  int page = 0;
  double angle = 0;           // first turned about the origin,
  Vec2 shift = Vec2::Zero();  // then moved

  Vec2 operator()(const Vec2& p) const { return rotation(angle) * p + shift; }
};

struct Placed {
  std::vector<Placement> placements;  // of each item
  std::vector<Page> pages;            // with a place for the key on each
  double fill_ratio = 0;              // covered area over printable area of all pages, in [0, 1]
};

// Width and height of the block with legend and ruler, millimetres.
Vec2 key_size(KeyForm form, double ruler);

// Every item fits the printable area in some angle_that_fits; throws InvalidInput otherwise. Items never overlap: cells
// are taken whenever touched. Deterministic; when the run is over, many items are placed in a hurry, on more pages.
// Items with a place in `given` (empty, or one of each item) lie there, whatever lies there already, and the others
// where there is room left; pages without an item are left out. O(items * rotations * cells) word operations at worst.
Placed place(const std::vector<PlaceItem>& items, const PageOptions& page, const PlaceOptions& options,
             const Run& run = {}, const std::vector<std::optional<Placement>>& given = {});

}  // namespace plico
