#include "plico/fabricate/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fabricate/pieces.h"
#include "plico/fabricate/place.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"

namespace plico {
namespace {

using Box = std::array<Vec2, 4>;

Box box_around(const Vec2& center, double angle, const Vec2& size) {
  const Vec2 u = rotation(angle) * Vec2(size.x() / 2, 0), v = rotation(angle) * Vec2(0, size.y() / 2);
  return {center - u - v, center + u - v, center + u + v, center - u + v};
}

// Text is never upside down: its angle is in (-90, 90] degrees.
double upright(double angle) {
  while (angle > kPi / 2 + 1e-9) angle -= kPi;
  while (angle <= -kPi / 2 + 1e-9) angle += kPi;
  return angle;
}

class Labeller {
 public:
  Labeller(PageLayout& layout, const std::vector<std::string>& seam_name, const Font& font, const LabelOptions& options)
      : layout_(layout), seam_name_(seam_name), font_(font), options_(options), paper_(12), written_(12) {
    for (const PlacedPart& part : layout.parts) take_paper(part);
    for (std::size_t p = 0; p < layout.pages.size(); ++p) take_key(static_cast<int>(p));
  }

  LabelReport write(const Run& run) {
    const bool named = options_.part_names && layout_.parts.size() > 1;
    for (PlacedPart& part : layout_.parts)
      if (named) name_part(part);
    if (!options_.edge_ids) return report_;
    for (PlacedPart& part : layout_.parts) label_edges(part, run);
    for (const Crowded& edge : crowded_)
      if (!run.over()) lead_out(edge);
    return report_;
  }

 private:
  static constexpr double kEasilyRead = 5;  // points
  static constexpr double kBesideText = 1;  // millimetres kept free around a page's small picture and its lines

  // A side of a panel, with its tab.
  struct Crowded {
    PlacedPart* part;
    const PlacedPanel* panel;
    const Tab* tab;
    int side;
  };

  void take_paper(const PlacedPart& part) {
    for (const PlacedPanel& panel : part.panels)
      for (auto& piece : convex_pieces(panel.corners)) paper_.add(std::move(piece), part.page);
    for (const Tab& tab : part.tabs)
      paper_.add({tab.corners[1], tab.corners[0], tab.corners[3], tab.corners[2]}, part.page);
    for (const Label& label : part.labels) {
      const Box b = box_around(label.center, label.angle, room_for(label.text, label.size));
      written_.add({b.begin(), b.end()}, part.page);
    }
    for (const Mark& mark : part.marks) {
      Eigen::AlignedBox2d box;
      for (const Vec2& p : mark.points) box.extend(p);
      const Vec2 size = box.sizes() + Vec2::Constant(0.4);
      const Box b = box_around(box.center(), 0, size);
      written_.add({b.begin(), b.end()}, part.page);
    }
  }

  void take_key(int page) {
    const Page& p = layout_.pages[page];
    if (p.inset) {
      const Box b = box_around(p.inset->at + p.inset->size / 2, 0, p.inset->size + Vec2::Constant(2 * kBesideText));
      paper_.add({b.begin(), b.end()}, page);
    }
    if (p.key_form == KeyForm::None) return;
    Vec2 size = key_size(p.key_form, p.ruler);
    if (!p.key_upright) std::swap(size.x(), size.y());
    const Box b = box_around(p.key_at + size / 2, 0, size);
    paper_.add({b.begin(), b.end()}, page);
  }

  Vec2 room_for(const std::string& text, double size) const {
    return {font_.width(text, size) + 0.35 * size, Font::cap_height(size) + 0.35 * size};
  }

  // The size goes down in steps of a point, to what is easily read, or from there to what can just be read.
  std::vector<double> sizes(bool easily_read) const {
    std::vector<double> result;
    for (double pt = options_.size_pt; pt > options_.smallest_pt - 1e-9; pt -= 1)
      if ((pt > kEasilyRead - 1e-9 || pt == options_.size_pt) == easily_read)
        result.push_back(pt * kMillimetresPerPoint);
    return result;
  }

  bool write_in(PlacedPart& part, const std::vector<Vec2>& area, const std::string& text, const Vec2& center,
                double angle, double size) {
    const Box box = box_around(center, angle, room_for(text, size));
    if (!contains(area, box) || written_.overlaps(box, part.page)) return false;
    written_.add({box.begin(), box.end()}, part.page);
    part.labels.push_back({text, center, upright(angle), size});
    return true;
  }

  void name_part(PlacedPart& part) {
    std::vector<const PlacedPanel*> panels;
    for (const PlacedPanel& panel : part.panels) panels.push_back(&panel);
    std::ranges::stable_sort(panels, std::greater<>(), [](const PlacedPanel* p) { return signed_area(p->corners); });
    if (panels.size() > 8) panels.resize(8);
    const std::string step = part.step > 0 ? fmt::format(", step {}", part.step) : "";
    if (!part.title.empty() && write_large(part, panels, fmt::format("{} {}{}", part.name, part.title, step))) return;
    if (!part.title.empty() && write_large(part, panels, fmt::format("{} {}", part.name, part.title))) return;
    if (!step.empty() && write_large(part, panels, part.name + step)) return;
    if (!write_large(part, panels, part.name)) name_beside(part);
  }

  // Small parts have no panel with room for their letter: it goes beside them, along the longest side that has room.
  void name_beside(PlacedPart& part) {
    if (part.outlines.empty()) return;
    const std::vector<Vec2>& outline = part.outlines.front();
    std::vector<std::pair<Vec2, Vec2>> sides;
    for (std::size_t i = 0; i < outline.size(); ++i) sides.emplace_back(outline[i], outline[(i + 1) % outline.size()]);
    std::ranges::stable_sort(sides, std::greater<>(),
                             [](const auto& side) { return (side.second - side.first).norm(); });
    for (double pt : {12.0, 9.0})
      for (const auto& [a, b] : sides)
        if (write_beside(part, a, b, part.name, pt * kMillimetresPerPoint)) return;
  }

  bool write_large(PlacedPart& part, const std::vector<const PlacedPanel*>& panels, const std::string& text) {
    for (double pt : {20.0, 16.0, 12.0, 9.0})
      for (const PlacedPanel* panel : panels)
        if (write_in(part, panel->corners, text, centroid(panel->corners), 0, pt * kMillimetresPerPoint)) return true;
    return false;
  }

  void label_edges(PlacedPart& part, const Run& run) {
    std::map<int, const Tab*> tab_of;
    for (const Tab& tab : part.tabs) tab_of[tab.edge] = &tab;
    for (const PlacedPanel& panel : part.panels) {
      if (run.over()) return;
      for (int i = 0; i < static_cast<int>(panel.edges.size()); ++i) {
        const std::string& text = seam_name_[panel.edges[i]];
        if (text.empty()) continue;
        const auto tab = tab_of.find(panel.edges[i]);
        const Crowded edge{&part, &panel, tab == tab_of.end() ? nullptr : tab->second, i};
        if (write_at(edge, sizes(true)))
          ++report_.placed;
        else
          crowded_.push_back(edge);
      }
    }
  }

  bool write_at(const Crowded& edge, const std::vector<double>& sizes) {
    const std::string& text = seam_name_[edge.panel->edges[edge.side]];
    return std::ranges::any_of(sizes, [&](double size) {
      if (edge.tab && write_on_tab(*edge.part, *edge.tab, text, size)) return true;
      return write_in_panel(*edge.part, *edge.panel, edge.side, text, size);
    });
  }

  bool write_on_tab(PlacedPart& part, const Tab& tab, const std::string& text, double size) {
    const Vec2 base = (tab.corners[0] + tab.corners[1]) / 2, tip = (tab.corners[2] + tab.corners[3]) / 2;
    const Vec2 along = tab.corners[1] - tab.corners[0];
    const std::vector<Vec2> area{tab.corners[1], tab.corners[0], tab.corners[3], tab.corners[2]};
    return write_in(part, area, text, base + 0.47 * (tip - base), plico::atan2(along.y(), along.x()), size);
  }

  // Along the edge, a little inside; in the middle or towards an end.
  bool write_in_panel(PlacedPart& part, const PlacedPanel& panel, int side, const std::string& text, double size) {
    const Vec2 &a = panel.corners[side], &b = panel.corners[(side + 1) % panel.corners.size()];
    const Vec2 along = (b - a).normalized(), in = perpendicular(along);
    const double half = room_for(text, size).y() / 2, angle = plico::atan2(along.y(), along.x());
    for (double away : {half + 0.35, half + 1.0})
      for (double at : {0.5, 0.4, 0.6, 0.3, 0.7})
        if (write_in(part, panel.corners, text, a + at * (b - a) + away * in, angle, size)) return true;
    return false;
  }

  // On free paper beyond the edge, upright, joined to the middle of the edge (or of its tab's tip) by a line; where
  // there is none, small at its edge.
  void lead_out(const Crowded& edge) {
    const std::vector<Vec2>& corners = edge.panel->corners;
    const Vec2 &a = corners[edge.side], &b = corners[(edge.side + 1) % corners.size()];
    const double size = std::max(options_.smallest_pt, std::min(options_.size_pt, 5.5)) * kMillimetresPerPoint;
    if (write_beside(*edge.part, a, b, seam_name_[edge.panel->edges[edge.side]], size))
      ++report_.leaders;
    else
      ++(write_at(edge, sizes(false)) ? report_.placed : report_.omitted);
  }

  // Beside the side from a to b of a part on its left.
  bool write_beside(PlacedPart& part, const Vec2& a, const Vec2& b, const std::string& text, double size) {
    const Vec2 out = -perpendicular((b - a).normalized());
    const Vec2 room = room_for(text, size);
    const Vec2 start = (a + b) / 2 + 0.4 * out;
    for (double distance : {2.0, 3.5, 5.0, 7.0}) {
      for (double turn : {0.0, 0.5, -0.5, 1.0, -1.0}) {
        const Vec2 way = rotation(turn) * out, end = start + distance * way;
        const Vec2 center = end + Vec2(way.x() * room.x() / 2, way.y() * room.y() / 2);
        const Box box = box_around(center, 0, room), line = thin(start, end);
        if (!on_page(box, part.page) || paper_.overlaps(box, part.page) || paper_.overlaps(line, part.page)) continue;
        if (written_.overlaps(box, part.page) || written_.overlaps(line, part.page)) continue;
        written_.add({box.begin(), box.end()}, part.page);
        written_.add({line.begin(), line.end()}, part.page);
        part.labels.push_back({text, center, 0, size, {start - 0.4 * out, end}});
        return true;
      }
    }
    return false;
  }

  static Box thin(const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    return box_around((a + b) / 2, plico::atan2(along.y(), along.x()), {along.norm(), 0.3});
  }

  bool on_page(const Box& box, int page) const {
    const Margins& margin = layout_.margin;
    const Eigen::AlignedBox2d inside(margin.low(), layout_.pages[page].size - margin.high());
    return std::ranges::all_of(box, [&](const Vec2& p) { return inside.contains(p); });
  }

  PageLayout& layout_;
  const std::vector<std::string>& seam_name_;
  const Font& font_;
  const LabelOptions& options_;
  PieceGrid paper_, written_;  // by page
  std::vector<Crowded> crowded_;
  LabelReport report_;
};

}  // namespace

void check(const LabelOptions& options) {
  if (!(options.smallest_pt >= 3 && options.smallest_pt <= options.size_pt && options.size_pt <= 24))
    throw InvalidOption(
        fmt::format("label sizes {:g} to {:g} pt must be in [3, 24] pt", options.smallest_pt, options.size_pt));
}

LabelReport add_labels(PageLayout& layout, const std::vector<std::string>& seam_name, const Font& font,
                       const LabelOptions& options, const Run& run) {
  check(options);
  return Labeller(layout, seam_name, font, options).write(run);
}

}  // namespace plico
