// What is printed and cut: parts with their tabs, labels and marks, placed on pages. Everything is in millimetres; a
// page has its origin at the lower left corner and y upwards, so a sheet seen from the front is never mirrored.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "plico/base/vec.h"
#include "plico/fold/crease_pattern.h"

namespace plico {

// A panel as placed. Side i runs from corner i to the next one, along sheet edge edges[i].
struct PlacedPanel {
  std::vector<Vec2> corners;  // counter-clockwise
  std::vector<int> edges;
  int panel = -1;  // of the net
};

// A glue flap: base from a to b on its edge, in the direction that its panel has it (counter-clockwise), tip outside.
// `mate` is the edge under whose panel it is glued.
struct Tab {
  int edge = -1, mate = -1;
  std::array<Vec2, 4> corners;  // a, b, tip beside b, tip beside a: clockwise
  double fold_angle = 0;        // of the seam, radians, valley > 0 > mountain
};

struct FoldLine {
  int edge = -1;
  Vec2 a, b;
  Assignment assignment = Assignment::Mountain;  // Mountain, Valley or Flat
  double fold_angle = 0;                         // radians
};

struct Label {
  std::string text;
  Vec2 center;
  double angle = 0;            // of the baseline, radians
  double size = 0;             // em, millimetres
  std::vector<Vec2> leader{};  // a line from the edge to the label, empty when the label stands at its edge
};

struct Mark {
  std::vector<Vec2> points;
  bool closed = false;
};

// One connected part on its page. A rigid motion of the net: nothing is mirrored.
struct PlacedPart {
  int part = -1;
  std::string name;   // "A", "B", ... as in the labels
  std::string title;  // a name to read, "head"; may be empty
  int page = 0;
  int step = 0;                             // when it is glued to the others, from 1; 0 when there are none
  std::vector<std::vector<Vec2>> outlines;  // closed, with the tabs; the outer one is counter-clockwise
  std::vector<PlacedPanel> panels;
  std::vector<Tab> tabs;
  std::vector<FoldLine> folds;  // flat ones included
  std::vector<Label> labels;
  std::vector<Mark> marks;
};

// Kept free along the edges of a page, millimetres.
struct Margins {
  double left = 10, bottom = 10, right = 10, top = 10;

  Margins() = default;
  Margins(double all) : left(all), bottom(all), right(all), top(all) {}  // NOLINT: a number is a margin all around
  Margins(double l, double b, double r, double t) : left(l), bottom(b), right(r), top(t) {}
  Vec2 low() const { return {left, bottom}; }
  Vec2 high() const { return {right, top}; }
};

// How the block with the legend and the ruler is arranged.
enum class KeyForm { Row, Stack, RulerOnly, None };

// A small picture of the finished model, and lines of text below it.
struct Inset {
  struct Panel {
    std::vector<Vec2> corners;
    bool here = false;  // of a part on this page
  };
  Vec2 at = Vec2::Zero(), size = Vec2::Zero();  // lower left corner, and all that it takes
  std::vector<Panel> panels;                    // later ones lie over earlier ones
  std::vector<std::string> lines;
};

struct Page {
  Vec2 size = Vec2::Zero();
  KeyForm key_form = KeyForm::None;
  Vec2 key_at = Vec2::Zero();  // lower left corner of the block
  bool key_upright = true;     // false: turned left by 90 degrees
  double ruler = 100;          // millimetres
  std::optional<Inset> inset = {};
};

struct PageLayout {
  std::vector<Page> pages;
  std::vector<PlacedPart> parts;
  double scale = 1;                 // millimetres per unit of the net
  Vec3 folded_size = Vec3::Zero();  // of the finished model, millimetres
  Margins margin = 0;               // kept free around each page
  bool has_taped_seams = false;     // some seams have no tab; their ids end in a degree sign
};

}  // namespace plico
