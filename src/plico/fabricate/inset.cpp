#include "plico/fabricate/inset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "plico/base/libm.h"
#include "plico/base/units.h"
#include "plico/fabricate/pieces.h"
#include "plico/fabricate/place.h"
#include "plico/geom/polygon.h"
#include "plico/mesh/upright.h"

namespace plico {
namespace {

constexpr std::array kInsetSides{40.0, 34.0, 28.0, 24.0, 20.0};  // millimetres
constexpr double kInsetLine = 2.8, kStepPoints = 6, kInsetStride = 2, kAround = 1.5;
constexpr int kMostLines = 3;

std::vector<Vec2> box_at(const Vec2& low, const Vec2& size) {
  return {low, low + Vec2(size.x(), 0), low + size, low + Vec2(0, size.y())};
}

// Everything on a page that may not be covered.
PieceGrid taken(const PageLayout& layout) {
  PieceGrid grid(12);
  for (const PlacedPart& part : layout.parts) {
    for (const PlacedPanel& panel : part.panels)
      for (auto& piece : convex_pieces(panel.corners)) grid.add(std::move(piece), part.page);
    for (const Tab& tab : part.tabs)
      grid.add({tab.corners[1], tab.corners[0], tab.corners[3], tab.corners[2]}, part.page);
  }
  for (std::size_t p = 0; p < layout.pages.size(); ++p) {
    const Page& page = layout.pages[p];
    if (page.key_form == KeyForm::None) continue;
    Vec2 size = key_size(page.key_form, page.ruler);
    if (!page.key_upright) std::swap(size.x(), size.y());
    grid.add(box_at(page.key_at, size), static_cast<int>(p));
  }
  return grid;
}

// The highest, then leftmost place.
std::optional<Vec2> free_place(const PageLayout& layout, int page, const PieceGrid& grid, const Vec2& size) {
  const Vec2 low = layout.margin.low(), high = layout.pages[page].size - layout.margin.high() - size;
  for (double y = high.y(); y >= low.y(); y -= kInsetStride)
    for (double x = low.x(); x <= high.x(); x += kInsetStride) {
      const Vec2 at(x, y), clear = Vec2::Constant(kAround);
      if (!grid.overlaps(box_at(at - clear, size + 2 * clear), page)) return at;
    }
  return std::nullopt;
}

// Where one looks from: the front right and a little from above, as stills do, or else around and from below.
struct Direction {
  double around, above;  // degrees
};
constexpr std::array kDirections{Direction{-35, 25},  Direction{55, 25},  Direction{145, 25},  Direction{-125, 25},
                                 Direction{-35, -25}, Direction{55, -25}, Direction{145, -25}, Direction{-125, -25}};
constexpr double kClearlyBetter = 1.3;  // the first is taken unless another one shows so much more

// Rows: right, up, towards the eye.
Eigen::Matrix3d camera(const Direction& from, char up) {
  const double around = radians(from.around), above = radians(from.above);
  Eigen::Matrix3d axes;
  axes.row(0) = Vec3(plico::cos(around), plico::sin(around), 0);
  axes.row(2) =
      Vec3(plico::cos(above) * plico::sin(around), -plico::cos(above) * plico::cos(around), plico::sin(above));
  axes.row(1) = axes.row(2).cross(axes.row(0));
  return axes * z_up_from(up);
}

// The panels as seen, farthest first, in a square of side 1; the greatest of a page's pictures is the same everywhere.
struct Seen {
  std::vector<int> order;
  std::vector<std::vector<Vec2>> panels;
};

Seen seen(const ModelView& view, const Direction& from) {
  const Eigen::Matrix3d eye = camera(from, view.up);
  Seen result;
  Eigen::AlignedBox2d box;
  std::vector<double> depth;
  for (const auto& corners : view.panels) {
    double sum = 0;
    std::vector<Vec2> flat;
    for (const Vec3& p : corners) {
      const Vec3 q = eye * p;
      flat.emplace_back(q.x(), q.y());
      box.extend(flat.back());
      sum += q.z() / static_cast<double>(corners.size());
    }
    depth.push_back(sum);
    result.panels.push_back(std::move(flat));
  }
  const double scale = 1 / std::max(box.sizes().maxCoeff(), 1e-300);
  for (auto& panel : result.panels)
    for (Vec2& p : panel) p = scale * (p - box.center()) + Vec2(0.5, 0.5);
  result.order.resize(depth.size());
  std::iota(result.order.begin(), result.order.end(), 0);
  std::stable_sort(result.order.begin(), result.order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
  return result;
}

// "1 A, 4 B" in lines that fit.
std::vector<std::string> step_lines(const PageLayout& layout, int page, const std::vector<int>& step, double width,
                                    const Font& font) {
  std::vector<std::pair<int, std::string>> parts;
  for (const PlacedPart& part : layout.parts)
    if (part.page == page) parts.emplace_back(step[part.part], part.name);
  std::sort(parts.begin(), parts.end());
  std::vector<std::string> lines{"step"};
  for (const auto& [number, name] : parts) {
    const std::string word = fmt::format(" {} {},", number, name);
    if (font.width(lines.back() + word, kStepPoints * kMillimetresPerPoint) > width) lines.emplace_back();
    lines.back() += word;
  }
  lines.back().pop_back();
  if (static_cast<int>(lines.size()) > kMostLines) {
    lines.resize(kMostLines);
    lines.back() += " …";
  }
  return lines;
}

// How much of the parts on the page faces the eye; what lies in front of it is not looked at.
double shown(const Seen& view, const Unfolding& net, const std::vector<char>& here) {
  double area = 0;
  for (std::size_t panel = 0; panel < view.panels.size(); ++panel)
    if (here[net.part[panel]]) area += std::max(0.0, signed_area(view.panels[panel]));
  return area;
}

const Seen& best_view(const std::vector<Seen>& views, const Unfolding& net, const std::vector<char>& here) {
  const Seen* best = &views.front();
  double most = kClearlyBetter * shown(*best, net, here);
  for (const Seen& view : views) {
    const double area = shown(view, net, here);
    if (area > most) best = &view, most = area;
  }
  return *best;
}

bool put_inset(PageLayout& layout, int page, const PieceGrid& grid, const std::vector<Seen>& views,
               const Unfolding& net, const std::vector<int>& step, const Font& font) {
  std::vector<char> here(net.num_parts(), 0);
  for (const PlacedPart& part : layout.parts) here[part.part] = part.page == page;
  const Seen& view = best_view(views, net, here);
  for (double side : kInsetSides) {
    Inset inset;
    inset.lines = step_lines(layout, page, step, side, font);
    inset.size = Vec2(side, side + kInsetLine * static_cast<double>(inset.lines.size()));
    const std::optional<Vec2> at = free_place(layout, page, grid, inset.size);
    if (!at) continue;
    inset.at = *at;
    const Vec2 picture(at->x(), at->y() + inset.size.y() - side);
    for (int panel : view.order) {
      Inset::Panel drawn{{}, here[net.part[panel]] != 0};
      for (const Vec2& p : view.panels[panel]) drawn.corners.push_back(picture + side * p);
      inset.panels.push_back(std::move(drawn));
    }
    layout.pages[page].inset = std::move(inset);
    return true;
  }
  return false;
}

}  // namespace

int add_insets(PageLayout& layout, const Unfolding& net, const ModelView& view, const std::vector<int>& step,
               const Font& font) {
  if (view.panels.empty() || view.panels.size() > kMostToPicture) return static_cast<int>(layout.pages.size());
  const PieceGrid grid = taken(layout);
  std::vector<Seen> views;
  for (const Direction& from : kDirections) views.push_back(seen(view, from));
  int without = 0;
  for (int page = 0; page < static_cast<int>(layout.pages.size()); ++page)
    without += !put_inset(layout, page, grid, views, net, step, font);
  return without;
}

}  // namespace plico
