// A layout as strokes and texts in layers: what SVG, PDF and DXF all draw, so that they cannot disagree.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "plico/fold/page_layout.h"
#include "plico/fold/panel_paint.h"

namespace plico {

// The layers of every printed file.
enum class Layer { Cut, Mountain, Valley, Mark, Text };
constexpr std::array<Layer, 5> kLayers{Layer::Cut, Layer::Mountain, Layer::Valley, Layer::Mark, Layer::Text};
// Marks with the fill of tabs lie at the bottom, cuts on top; a machine that follows the file cuts last.
constexpr std::array<Layer, 5> kDrawOrder{Layer::Mark, Layer::Text, Layer::Valley, Layer::Mountain, Layer::Cut};
inline constexpr std::string_view kColorLayer = "COLOR";  // below them, in files of painted models only
std::string_view name(Layer layer);                       // "CUT", "MOUNTAIN", "VALLEY", "MARK", "TEXT"

struct Pen {
  std::array<double, 3> color{0, 0, 0};  // red, green, blue in [0, 1]
  double width = 0.2;                    // millimetres; 0 draws no line
  std::vector<double> dash{};            // millimetres on, off, on, off, ...; empty is solid
  bool fill = false;                     // filled with `color` instead
  bool to_look_at = false;               // of a picture: left out of DXF files, which are there to cut
};

struct Stroke {
  Layer layer = Layer::Cut;
  std::vector<Vec2> points;
  bool closed = false;
  int pen = 0;            // of the drawing's pens
  std::string part = {};  // name of the part whose outline this is, else empty
};

struct Text {
  std::string text;
  Vec2 start;        // of the baseline
  double angle = 0;  // of the baseline, radians
  double size = 0;   // em, millimetres
  int pen = 0;       // its color
};

// A polygon of one colour, below all strokes.
struct ColorFill {
  std::vector<Vec2> points;
  Color color = kWhite;
};

// A picture on a page, below all strokes; white paper where it has no pixels.
struct PagePicture {
  Picture picture;
  Vec2 low = Vec2::Zero(), size = Vec2::Zero();  // its lower left corner, and how large, millimetres
};

// One page; origin at the lower left corner, y upwards, millimetres.
struct Drawing {
  Vec2 size = Vec2::Zero();
  std::string title;
  std::vector<Pen> pens;
  std::vector<Stroke> strokes;
  std::vector<Text> texts;       // all in layer Text
  std::vector<ColorFill> fills;  // the looks of the model: these, later ones on top, or a picture
  PagePicture picture;
  bool is_painted() const { return !fills.empty() || picture.picture.width > 0; }
};

// Paper: for scissors. Origami: mountain red, valley blue. Laser: red cuts, blue and cyan scores, black marks.
// Bw: for black printers.
enum class DrawStyle { Paper, Origami, Laser, Bw };

// Letters as text of a font, as lines along their outlines for machines that have no font, or none.
enum class TextForm { Text, Outlines, None };

// Folds as rows of cuts with paper left between them, real gaps, for machines that cut solid lines only. Every row
// begins and ends with at least half a gap of paper.
struct Perforation {
  double cut = 0, gap = 0;  // millimetres; cut = 0: folds stay lines
};

// Which side of the paper is printed. The outside is what one sees of the model; on the inside all is mirrored and
// mountains are valleys. Both: two drawings a page, folds and cuts on the outside, ids and marks on the inside, in
// register when printed duplex along the long edge.
enum class PaperSide { Outside, Inside, Both };

struct DrawOptions {
  DrawStyle style = DrawStyle::Paper;
  bool flat_creases = false;  // show folds that stay flat
  std::string title = {};     // of the model, shown beside the legend
  TextForm text = TextForm::Text;
  Perforation perforation = {};
  bool ruler = true;
  PaperSide side = PaperSide::Outside;
  bool color = true;         // the looks of the model on the outside; never in styles Laser and Bw
  bool shadow_tabs = false;  // where each tab lands, as thin lines on the panel it is glued under
};
void check(const DrawOptions& options);  // throws InvalidOption naming field, value and range

// One drawing a page. Every part is one closed stroke in layer Cut (more when it has holes), tabs included; what lies
// inside another outline is cut before it. `paint` is that of the net that was laid out; text on dark panels is white.
// Throws InvalidOption.
std::vector<Drawing> draw(const PageLayout& layout, const DrawOptions& options = {}, const PanelPaint& paint = {});

// Coordinates in files: rounded to 1e-7, without trailing zeros; the same text for the same double.
std::string decimal(double x);

}  // namespace plico
