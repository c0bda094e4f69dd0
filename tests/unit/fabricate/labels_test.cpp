#include "plico/fabricate/labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fabricate_samples.h"
#include "plico/fabricate/fabricate.h"
#include "plico/verify/overlap.h"

namespace plico {
namespace {

using Polygon = std::vector<Vec2>;

// What the letters cover, judged by the font alone.
Polygon box_of(const Label& label) {
  const Vec2 along(std::cos(label.angle), std::sin(label.angle));
  const Vec2 u = Font().width(label.text, label.size) / 2 * along;
  const Vec2 v = Font::cap_height(label.size) / 2 * Vec2(-along.y(), along.x());
  return {label.center - u - v, label.center + u - v, label.center + u + v, label.center - u + v};
}

bool lies_in(const Polygon& box, const Polygon& area) {
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Vec2 &a = area[i], &b = area[(i + 1) % area.size()];
    for (const Vec2& p : box)
      if ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() < -1e-9) return false;
  }
  return true;
}

bool lies_in_panel_or_tab(const Polygon& box, const PlacedPart& part) {
  const auto in_panel = [&](const PlacedPanel& panel) { return lies_in(box, panel.corners); };
  const auto in_tab = [&](const Tab& tab) {
    return lies_in(box, {tab.corners[1], tab.corners[0], tab.corners[3], tab.corners[2]});
  };
  return std::ranges::any_of(part.panels, in_panel) || std::ranges::any_of(part.tabs, in_tab);
}

void add_face(CreasePattern& sheet, const Polygon& polygon) {
  sheet.faces.emplace_back();
  for (const Vec2& p : polygon) {
    sheet.faces.back().push_back(sheet.num_vertices());
    sheet.vertices.push_back(p);
  }
}

std::vector<LayoutResult> crowded_sheets() {
  std::vector<LayoutResult> sheets;
  for (double longest : {25.0, 60.0}) {
    const Mesh mesh = samples::torus(8, 5);
    LayoutOptions options;
    options.size.longest = longest;
    options.split = true;
    options.weak_folds = WeakFolds::Cut;
    sheets.push_back(lay_out_pages(samples::net_of(mesh), folded_shape(mesh), options));
  }
  return sheets;
}

TEST(Labels, NoneLiesOverAnother) {
  for (const LayoutResult& sheet : crowded_sheets()) {
    for (int page = 0; page < sheet.report.pages; ++page) {
      CreasePattern letters;
      for (const PlacedPart& part : sheet.layout.parts)
        for (const Label& label : part.labels)
          if (part.page == page) add_face(letters, box_of(label));
      EXPECT_EQ(find_overlaps(letters).count, 0);
    }
  }
}

TEST(Labels, LieInTheirPanelOrTabOrBesideThePartsWithALeader) {
  for (const LayoutResult& sheet : crowded_sheets()) {
    for (const PlacedPart& part : sheet.layout.parts) {
      for (const Label& label : part.labels) {
        const Polygon box = box_of(label);
        if (label.leader.empty()) {
          EXPECT_TRUE(lies_in_panel_or_tab(box, part)) << label.text;
          continue;
        }
        CreasePattern both;
        add_face(both, box);
        for (const PlacedPart& other : sheet.layout.parts)
          for (const PlacedPanel& panel : other.panels)
            if (other.page == part.page) add_face(both, panel.corners);
        EXPECT_EQ(find_overlaps(both).count, 0) << label.text;
      }
    }
  }
}

// A panel in the middle of a page: its sides are long enough for an id of 4 points, but not for one that is easily
// read.
PageLayout lone_panel(double margin) {
  constexpr double kSide = 2.4;
  const Vec2 at(margin, margin), right(kSide, 0), up(0, kSide);
  PlacedPart part;
  part.panels.push_back({{at, at + right, at + right + up, at + up}, {0, 1, 2, 3}, 0});
  PageLayout layout;
  layout.pages.push_back({.size = Vec2::Constant(2 * margin + kSide)});
  layout.parts.push_back(part);
  return layout;
}

TEST(Labels, StandBesideThePartRatherThanBeTooSmall) {
  const std::vector<std::string> ids{"12", "34", "56", "78"};
  PageLayout roomy = lone_panel(20);
  const LabelReport beside = add_labels(roomy, ids, Font(), {});
  EXPECT_EQ(beside.leaders, 4);
  EXPECT_EQ(beside.omitted, 0);
  ASSERT_EQ(roomy.parts[0].labels.size(), 4U);
  for (const Label& label : roomy.parts[0].labels) {
    EXPECT_GE(label.size, 5 * kMillimetresPerPoint) << label.text;
    EXPECT_FALSE(label.leader.empty()) << label.text;
  }

  PageLayout tight = lone_panel(0.5);  // no paper is left beside the sides: small is better than nothing
  const LabelReport inside = add_labels(tight, ids, Font(), {});
  EXPECT_EQ(inside.leaders, 0);
  ASSERT_GT(inside.placed, 0);
  for (const Label& label : tight.parts[0].labels) EXPECT_LT(label.size, 5 * kMillimetresPerPoint) << label.text;
}

TEST(Labels, AreNotWrittenOnceTheRunIsOver) {
  LayoutResult sheet = crowded_sheets().back();
  for (PlacedPart& part : sheet.layout.parts) part.labels.clear();
  const LabelReport report =
      add_labels(sheet.layout, sheet.report.edge_ids, Font(), {.part_names = false}, {.deadline = Run::Clock::now()});
  EXPECT_EQ(report.placed + report.leaders + report.omitted, 0);
}

TEST(Labels, NameEveryPartInItOrBesideIt) {
  int named = 0;
  for (const LayoutResult& sheet : crowded_sheets()) {
    if (sheet.layout.parts.size() == 1) continue;  // needs no name
    for (const PlacedPart& part : sheet.layout.parts) {
      const auto names_it = [&](const Label& label) {
        return label.text == part.name || label.text.starts_with(part.name + ",");
      };
      EXPECT_EQ(std::ranges::count_if(part.labels, names_it), 1) << part.name;
      ++named;
    }
  }
  EXPECT_GT(named, 5);
}

}  // namespace
}  // namespace plico
