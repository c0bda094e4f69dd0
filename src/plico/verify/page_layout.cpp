#include "plico/verify/page_layout.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "plico/geom/polygon.h"
#include "plico/verify/overlap.h"

namespace plico {
namespace {

constexpr double kTolerance = 1e-6;  // millimetres

// The part of a convex polygon on the left of the line from a to b (Sutherland and Hodgman).
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = cross(Vec2(b - a), Vec2(p - a)), at_q = cross(Vec2(b - a), Vec2(q - a));
    if (at_p >= 0) result.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) result.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return result;
}

// How much of the convex `shape` lies in the polygon.
double area_inside(const std::vector<Vec2>& shape, const std::vector<Vec2>& polygon) {
  double area = 0;
  for (const auto& [i, j, k] : triangulate(polygon)) {
    std::vector<Vec2> left = clipped(shape, polygon[i], polygon[j]);
    left = clipped(left, polygon[j], polygon[k]);
    left = clipped(left, polygon[k], polygon[i]);
    if (left.size() > 2) area += signed_area(left);
  }
  return area;
}

struct PanelSide {
  const PlacedPanel* panel = nullptr;
  int side = 0;
  const Vec2& from() const { return panel->corners[side]; }
  const Vec2& to() const { return panel->corners[(side + 1) % panel->corners.size()]; }
};

std::vector<Vec2> counter_clockwise(const Tab& tab) {
  return {tab.corners[3], tab.corners[2], tab.corners[1], tab.corners[0]};
}

class Judge {
 public:
  explicit Judge(const PageLayout& layout) : layout_(layout) {
    for (const PlacedPart& part : layout.parts)
      for (const PlacedPanel& panel : part.panels)
        for (int i = 0; i < static_cast<int>(panel.edges.size()); ++i) sides_[panel.edges[i]].push_back({&panel, i});
  }

  LayoutVerdict run() {
    for (int page = 0; page < static_cast<int>(layout_.pages.size()); ++page) judge_page(page);
    for (const PlacedPart& part : layout_.parts) {
      judge_outlines(part);
      for (const Tab& tab : part.tabs) judge_tab(tab);
    }
    return std::move(verdict_);
  }

 private:
  void complain(std::string problem) {
    if (verdict_.problems.size() < 20) verdict_.problems.push_back(std::move(problem));
  }

  void judge_page(int page) {
    CreasePattern all;
    const auto add = [&](const std::vector<Vec2>& piece, int part) {
      all.faces.emplace_back();
      for (const Vec2& p : piece) {
        all.faces.back().push_back(all.num_vertices());
        all.vertices.push_back(p);
      }
      if (inside_margins(piece, page)) return;
      ++verdict_.off_page;
      complain(fmt::format("part {} reaches beyond the margin of page {}", part, page + 1));
    };
    for (const PlacedPart& part : layout_.parts) {
      if (part.page != page) continue;
      for (const PlacedPanel& panel : part.panels) add(panel.corners, part.part);
      for (const Tab& tab : part.tabs) add(counter_clockwise(tab), part.part);
    }
    if (const auto& inset = layout_.pages[page].inset) {
      const Vec2 low = inset->at, high = low + inset->size;
      add({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, -1);
    }
    const Overlaps overlaps = find_overlaps(all);
    verdict_.overlaps += overlaps.count;
    for (const OverlappingPair& pair : overlaps.listed)
      complain(fmt::format("pieces {} and {} of page {} overlap by {:.3g} mm2", pair.a, pair.b, page + 1, pair.area));
  }

  bool inside_margins(const std::vector<Vec2>& piece, int page) const {
    const Vec2 loose = Vec2::Constant(kTolerance), low = layout_.margin.low() - loose;
    const Vec2 high = layout_.pages[page].size - layout_.margin.high() + loose;
    for (const Vec2& p : piece)
      if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) return false;
    return true;
  }

  // The outer outline minus its holes has the area of all panels and tabs.
  void judge_outlines(const PlacedPart& part) {
    double enclosed = 0, pieces = 0;
    for (const auto& outline : part.outlines) enclosed += signed_area(outline);
    for (const PlacedPanel& panel : part.panels) pieces += signed_area(panel.corners);
    for (const Tab& tab : part.tabs) pieces += signed_area(counter_clockwise(tab));
    if (std::abs(enclosed - pieces) <= kTolerance * (1 + pieces)) return;
    ++verdict_.open_outlines;
    complain(
        fmt::format("the outline of part {} encloses {:g} mm2, its pieces have {:g} mm2", part.name, enclosed, pieces));
  }

  void judge_tab(const Tab& tab) {
    const auto own = sides_.find(tab.edge), mate = sides_.find(tab.mate);
    if (own == sides_.end() || mate == sides_.end() || own->second.size() != 1 || mate->second.size() != 1 ||
        !stands_on(own->second[0], tab)) {
      ++verdict_.loose_tabs;
      complain(fmt::format("the tab of edge {} does not stand on that edge", tab.edge));
      return;
    }
    const PanelSide under = mate->second[0];
    const std::vector<Vec2> turned = turned_over(tab, own->second[0], under);
    const double area = signed_area(turned);
    if (area_inside(turned, under.panel->corners) >= area - kTolerance * (1 + area)) return;
    ++verdict_.misfit_tabs;
    complain(fmt::format("the tab of edge {} sticks out of the panel it is glued under", tab.edge));
  }

  // Both ends of the base lie on the side, in its direction.
  static bool stands_on(const PanelSide& side, const Tab& tab) {
    const Vec2 edge = side.to() - side.from(), x = edge.normalized();
    const Vec2 a = tab.corners[0] - side.from(), b = tab.corners[1] - side.from();
    const auto off = [&](const Vec2& p) { return std::abs(cross(x, p)) > kTolerance; };
    return !off(a) && !off(b) && a.dot(x) >= -kTolerance && a.dot(x) < b.dot(x) && b.dot(x) <= edge.norm() + kTolerance;
  }

  // The tab on the inner side of its mate edge, counter-clockwise: where it is glued.
  static std::vector<Vec2> turned_over(const Tab& tab, const PanelSide& own, const PanelSide& under) {
    const Vec2 x = (own.to() - own.from()).normalized(), y = -perpendicular(x);
    const Vec2 to_x = (under.from() - under.to()).normalized(), to_y = perpendicular(-to_x);  // into the panel
    std::vector<Vec2> turned;
    for (const Vec2& p : tab.corners) {
      const Vec2 d = p - own.from();
      turned.push_back(under.to() + d.dot(x) * to_x + d.dot(y) * to_y);
    }
    return {turned[3], turned[2], turned[1], turned[0]};
  }

  const PageLayout& layout_;
  std::map<int, std::vector<PanelSide>> sides_;
  LayoutVerdict verdict_;
};

}  // namespace

LayoutVerdict verify_layout(const PageLayout& layout) { return Judge(layout).run(); }

}  // namespace plico
