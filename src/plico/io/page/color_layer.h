// The looks of a model on its pages: colours as polygons; as one picture a page where some panel has a picture.
#pragma once
#include "plico/io/page/drawing.h"

namespace plico {

inline constexpr double kBleed = 1.5;              // millimetres: colours go on beyond cuts and into tabs
inline constexpr double kPixelsPerMillimetre = 8;  // 203 dots per inch

// Fills `fills` or `picture` of a page: tabs in `tab_color` at the bottom, then a strip along each side of each panel,
// where the colour of the side goes on, then the panels. O(panels + pixels).
void add_colors(const PageLayout& layout, int page, const PanelPaint& paint, const Color& tab_color, Drawing& drawing);

// What is printed at a point of the page below all strokes. O(fills).
Color color_under(const Drawing& drawing, const Vec2& p);

}  // namespace plico
