#include "plico/io/page/color_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "plico/fabricate/pieces.h"

namespace plico {
namespace {

constexpr double kOnSide = 1e-4;  // of the longest side of a panel
constexpr double kInset = 0.1;    // millimetres: strips take their colour so far inside, away from seams of a texture
constexpr int kSamples = 2;       // a pixel, each way

double distance_to_line(const Vec2& p, const Vec2& a, const Vec2& b) {
  return std::abs(cross(b - a, p - a)) / (b - a).norm();
}

// A polygon on the page, and its colour at each point of it.
struct Area {
  std::vector<Vec2> points;
  Color color;                                  // all over, unless:
  std::function<Color(const Vec2&)> look = {};  // has a picture
};

// From the plane of a panel, in the unit of the net, to its page, and back.
struct PanelOnPage {
  Vec2 origin, x;
  double scale;

  Vec2 on_page(const Vec2& p) const { return origin + scale * (p.x() * x + p.y() * perpendicular(x)); }
  Vec2 in_panel(const Vec2& p) const { return Vec2((p - origin).dot(x), (p - origin).dot(perpendicular(x))) / scale; }
};

class Colorist {
 public:
  Colorist(const PageLayout& layout, const PanelPaint& paint) : layout_(layout), paint_(paint) {}

  void add_part(const PlacedPart& part, const Color& tab_color) {
    for (const Tab& tab : part.tabs) tabs_.push_back({{tab.corners.rbegin(), tab.corners.rend()}, tab_color});
    for (const PlacedPanel& panel : part.panels)
      if (panel.panel >= 0 && panel.panel < static_cast<int>(paint_.panels.size())) add_panel(panel);
  }

  void write_to(Drawing& drawing) {
    std::vector<Area> areas = std::move(tabs_);
    for (std::vector<Area>* more : {&strips_, &panels_}) std::ranges::move(*more, std::back_inserter(areas));
    if (areas.empty()) return;
    if (std::ranges::any_of(areas, [](const Area& area) { return static_cast<bool>(area.look); }))
      drawing.picture = rastered(areas);
    else
      for (Area& area : areas) drawing.fills.push_back({std::move(area.points), area.color});
  }

 private:
  void add_panel(const PlacedPanel& panel) {
    const PanelOnPage at{panel.corners[0], (panel.corners[1] - panel.corners[0]).normalized(), layout_.scale};
    for (const Patch& patch : paint_.panels[panel.panel]) {
      Area area{{}, patch.color, look_of(patch, at)};
      for (const Vec2& p : patch.corners) area.points.push_back(at.on_page(p));
      add_strips(panel, area);
      panels_.push_back(std::move(area));
    }
  }

  std::function<Color(const Vec2&)> look_of(const Patch& patch, const PanelOnPage& at) const {
    if (patch.picture < 0) return {};
    return [this, &patch, at](const Vec2& p) {
      return product(patch.color, color_at(paint_.pictures[patch.picture], patch.uv_at(at.in_panel(p))));
    };
  }

  // Beside each side of a patch that lies on a side of its panel.
  void add_strips(const PlacedPanel& panel, const Area& area) {
    const std::size_t n = area.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &a = area.points[i], &b = area.points[(i + 1) % n];
      if (!((b - a).norm() > 0) || !lies_on_rim(panel, a, b)) continue;
      const Vec2 along = (b - a).normalized(), out = -perpendicular(along);
      const Vec2 from = a - kBleed * along, to = b + kBleed * along;
      Area strip{{to, from, from + kBleed * out, to + kBleed * out}, area.color};
      if (area.look)
        strip.look = [look = area.look, a, along, out, length = (b - a).norm()](const Vec2& p) {
          const double inset = std::min(kInset, length / 4);
          const double t = std::clamp((p - a).dot(along), inset, length - inset);
          return look(a + t * along - inset * out);
        };
      strips_.push_back(std::move(strip));
    }
  }

  static bool lies_on_rim(const PlacedPanel& panel, const Vec2& a, const Vec2& b) {
    const std::size_t n = panel.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &from = panel.corners[i], &to = panel.corners[(i + 1) % n];
      const double length = (to - from).norm(), near = kOnSide * length;
      if (!(length > 0)) continue;
      const Vec2 along = (to - from) / length;
      const auto on_side = [&](const Vec2& p) {
        const double t = (p - from).dot(along);
        return t > -near && t < length + near && distance_to_line(p, from, to) <= near;
      };
      if (on_side(a) && on_side(b)) return true;
    }
    return false;
  }

  static PagePicture rastered(const std::vector<Area>& areas) {
    Eigen::AlignedBox2d box;
    for (const Area& area : areas)
      for (const Vec2& p : area.points) box.extend(p);
    PagePicture result;
    const Vec2 low = (box.min() * kPixelsPerMillimetre).array().floor(),
               high = (box.max() * kPixelsPerMillimetre).array().ceil();
    result.picture.width = static_cast<int>(high.x() - low.x());
    result.picture.height = static_cast<int>(high.y() - low.y());
    result.picture.rgba.assign(std::size_t{4} * result.picture.width * result.picture.height, 0);
    result.low = low / kPixelsPerMillimetre;
    result.size = (high - low) / kPixelsPerMillimetre;
    for (const Area& area : areas) fill(area, result);
    return result;
  }

  // Row by row the pixels whose centres lie inside.
  static void fill(const Area& area, PagePicture& page) {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : area.points) box.extend(p);
    const auto row_at = [&](double y) { return (page.low.y() + page.size.y() - y) * kPixelsPerMillimetre - 0.5; };
    const int first = std::max(0, static_cast<int>(std::ceil(row_at(box.max().y()))));
    const int last = std::min(page.picture.height - 1, static_cast<int>(std::floor(row_at(box.min().y()))));
    for (int row = first; row <= last; ++row) fill_row(area, row, page);
  }

  static void fill_row(const Area& area, int row, PagePicture& page) {
    const double y = page.low.y() + page.size.y() - (row + 0.5) / kPixelsPerMillimetre;
    std::vector<double> crossings;
    for (std::size_t i = 0, j = area.points.size() - 1; i < area.points.size(); j = i++) {
      const Vec2 &a = area.points[i], &b = area.points[j];
      if ((a.y() > y) != (b.y() > y)) crossings.push_back(a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()));
    }
    std::ranges::sort(crossings);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const auto column_at = [&](double x) { return (x - page.low.x()) * kPixelsPerMillimetre - 0.5; };
      const int first = std::max(0, static_cast<int>(std::ceil(column_at(crossings[k]))));
      const int last = std::min(page.picture.width - 1, static_cast<int>(std::floor(column_at(crossings[k + 1]))));
      for (int column = first; column <= last; ++column) set_pixel(area, column, row, page);
    }
  }

  static void set_pixel(const Area& area, int column, int row, PagePicture& page) {
    Color color = area.color;
    if (area.look) {
      color = {};
      for (int down = 0; down < kSamples; ++down)
        for (int across = 0; across < kSamples; ++across) {
          const Vec2 at((column + (across + 0.5) / kSamples) / kPixelsPerMillimetre,
                        page.size.y() - (row + (down + 0.5) / kSamples) / kPixelsPerMillimetre);
          const Color sample = area.look(page.low + at);
          for (std::size_t k = 0; k < 3; ++k) color[k] += sample[k] / (kSamples * kSamples);
        }
    }
    std::uint8_t* pixel = page.picture.rgba.data() + std::size_t{4} * (std::size_t(row) * page.picture.width + column);
    for (std::size_t k = 0; k < 3; ++k)
      pixel[k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[k], 0.0, 1.0)));
    pixel[3] = 255;
  }

  const PageLayout& layout_;
  const PanelPaint& paint_;
  std::vector<Area> tabs_, strips_, panels_;
};

}  // namespace

void add_colors(const PageLayout& layout, int page, const PanelPaint& paint, const Color& tab_color, Drawing& drawing) {
  Colorist colorist(layout, paint);
  for (const PlacedPart& part : layout.parts)
    if (part.page == page) colorist.add_part(part, tab_color);
  colorist.write_to(drawing);
}

Color color_under(const Drawing& drawing, const Vec2& p) {
  const PagePicture& page = drawing.picture;
  const Vec2 at = (p - page.low) * kPixelsPerMillimetre;
  const int column = static_cast<int>(std::floor(at.x())),
            row = page.picture.height - 1 - static_cast<int>(std::floor(at.y()));
  if (column >= 0 && column < page.picture.width && row >= 0 && row < page.picture.height) {
    const std::uint8_t* pixel =
        page.picture.rgba.data() + std::size_t{4} * (std::size_t(row) * page.picture.width + column);
    return pixel[3] ? Color{pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0} : kWhite;
  }
  for (auto fill = drawing.fills.rbegin(); fill != drawing.fills.rend(); ++fill)
    if (contains(fill->points, std::array{p})) return fill->color;
  return kWhite;
}

}  // namespace plico
