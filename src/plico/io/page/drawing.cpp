#include "plico/io/page/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "plico/base/error.h"
#include "plico/fabricate/place.h"
#include "plico/font/font.h"
#include "plico/geom/polygon.h"
#include "plico/io/page/color_layer.h"

namespace plico {
namespace {

constexpr Color rgb(int hex) { return {(hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0}; }

// The pens of a style; numbers are indices into Drawing::pens.
enum PenIndex {
  kCut,
  kMountain,
  kValley,
  kFlat,
  kMark,
  kLeader,
  kTabFill,
  kText,
  kFaint,
  kElsewhere,  // this and what follows only where they are used
  kHere,
  kHair,
  kLight
};

std::vector<Pen> pens(DrawStyle style) {
  const std::vector<double> dash_dot{2.2, 0.7, 0.25, 0.7}, dash{1.6, 1.0}, dots{0.3, 0.9};
  switch (style) {
    case DrawStyle::Paper:
      return {{rgb(0x000000), 0.25},        {rgb(0xb3361e), 0.18, dash_dot},
              {rgb(0x1d5fa8), 0.18, dash},  {rgb(0x9a9a9a), 0.12, dots},
              {rgb(0x222222), 0.25},        {rgb(0x777777), 0.12},
              {rgb(0xececec), 0, {}, true}, {rgb(0x333333), 0.1},
              {rgb(0x777777), 0.12}};
    case DrawStyle::Origami:
      return {{rgb(0x000000), 0.3},         {rgb(0xe00000), 0.3, dash_dot}, {rgb(0x0000e0), 0.3, dash},
              {rgb(0xaaaaaa), 0.15, dots},  {rgb(0x222222), 0.25},          {rgb(0x777777), 0.12},
              {rgb(0xf4f4f4), 0, {}, true}, {rgb(0x333333), 0.1},           {rgb(0x777777), 0.12}};
    case DrawStyle::Laser:
      return {{rgb(0xff0000), 0.025},       {rgb(0x0000ff), 0.025, dash_dot}, {rgb(0x00a0ff), 0.025, dash},
              {rgb(0x00c000), 0.025, dots}, {rgb(0x000000), 0.025},           {rgb(0x000000), 0.025},
              {rgb(0xffffff), 0},           {rgb(0x000000), 0.025},           {rgb(0x000000), 0.025}};
    case DrawStyle::Bw:
      break;
  }
  return {{rgb(0x000000), 0.3},        {rgb(0x000000), 0.18, dash_dot},
          {rgb(0x555555), 0.18, dash}, {rgb(0x888888), 0.12, dots},
          {rgb(0x000000), 0.25},       {rgb(0x555555), 0.1},
          {rgb(0xffffff), 0},          {rgb(0x000000), 0.1},
          {rgb(0x555555), 0.12}};
}

// Of pages with a picture of the model; a laser would burn it.
std::vector<Pen> picture_pens(DrawStyle style) {
  if (style == DrawStyle::Bw)
    return {{rgb(0xeeeeee), 0, {}, true}, {rgb(0x888888), 0, {}, true}, {rgb(0x333333), 0.04, {}, false, true}};
  return {{rgb(0xe4e4e4), 0, {}, true}, {rgb(0xf0b429), 0, {}, true}, {rgb(0x888888), 0.04, {}, false, true}};
}

PenIndex pen_of(Assignment fold) {
  return fold == Assignment::Mountain ? kMountain : fold == Assignment::Valley ? kValley : kFlat;
}

Layer layer_of(Assignment fold) {
  return fold == Assignment::Mountain ? Layer::Mountain : fold == Assignment::Valley ? Layer::Valley : Layer::Mark;
}

// On paint that is so dark, letters are white.
constexpr double kDark = 0.4;
double brightness(const Color& color) { return 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2]; }

bool shows_colors(const DrawOptions& options) {
  return options.color && options.style != DrawStyle::Laser && options.style != DrawStyle::Bw &&
         options.side != PaperSide::Inside;
}

// Draws one page.
class Drafter {
 public:
  Drafter(const PageLayout& layout, int page, const DrawOptions& options, const PanelPaint& paint, const Font& font)
      : layout_(layout), page_(layout.pages[page]), number_(page), options_(options), font_(font) {
    drawing_.size = page_.size;
    drawing_.title = options.title;
    drawing_.pens = pens(options.style);
    if (options.perforation.cut > 0) drawing_.pens[kMountain].dash = drawing_.pens[kValley].dash = {};
    if (paint.empty() || !shows_colors(options)) return;
    add_colors(layout, page, paint, drawing_.pens[kTabFill].color, drawing_);
    need_picture_pens();
    drawing_.pens.push_back({rgb(0xffffff), 0.1});  // kLight
  }

  Drawing run() {
    for (const PlacedPart& part : layout_.parts)
      if (part.page == number_) draw_part(part);
    if (options_.shadow_tabs) draw_shadows();
    if (page_.key_form != KeyForm::None) draw_key();
    if (page_.inset && options_.style != DrawStyle::Laser) draw_inset(*page_.inset);
    put_in_order();
    return std::move(drawing_);
  }

 private:
  void line(Layer layer, PenIndex pen, const Vec2& a, const Vec2& b) {
    drawing_.strokes.push_back({layer, {a, b}, false, pen});
  }

  // What lies inside is smaller: a machine that goes on cuts it while the paper around it still holds.
  void put_in_order() {
    std::ranges::stable_sort(drawing_.strokes, {}, [](const Stroke& stroke) {
      return stroke.layer == Layer::Cut ? std::abs(signed_area(stroke.points)) : -1;
    });
  }

  void fold_line(Assignment fold, const Vec2& a, const Vec2& b) {
    const auto [cut, gap] = options_.perforation;
    const Layer layer = layer_of(fold);
    const double length = (b - a).norm();
    if (!(cut > 0) || layer == Layer::Mark) return line(layer, pen_of(fold), a, b);
    const int cuts = static_cast<int>(std::floor(length / (cut + gap)));
    const Vec2 along = (b - a).normalized();
    const double rest = length - cuts * (cut + gap) + gap;  // of paper, at both ends together
    for (int i = 0; i < cuts; ++i) {
      const Vec2 from = a + (rest / 2 + i * (cut + gap)) * along;
      line(layer, pen_of(fold), from, from + cut * along);
    }
  }

  void need_picture_pens() {
    if (drawing_.pens.size() > kElsewhere) return;
    for (Pen& pen : picture_pens(options_.style)) drawing_.pens.push_back(std::move(pen));
  }

  void draw_part(const PlacedPart& part) {
    if (drawing_.pens[kTabFill].fill && !drawing_.is_painted())
      for (const Tab& tab : part.tabs)
        drawing_.strokes.push_back({Layer::Mark, {tab.corners.begin(), tab.corners.end()}, true, kTabFill});
    for (const FoldLine& fold : part.folds)
      if (fold.assignment != Assignment::Flat || options_.flat_creases) fold_line(fold.assignment, fold.a, fold.b);
    for (const Tab& tab : part.tabs) {
      const Assignment fold = tab.fold_angle > 0 ? Assignment::Valley : Assignment::Mountain;
      fold_line(fold, tab.corners[0], tab.corners[1]);
    }
    for (const Mark& mark : part.marks) drawing_.strokes.push_back({Layer::Mark, mark.points, mark.closed, kMark});
    for (const Label& label : part.labels) {
      if (!label.leader.empty()) drawing_.strokes.push_back({Layer::Mark, label.leader, false, kLeader});
      write_centered(label.text, label.center, label.angle, label.size, kText);
    }
    for (const auto& outline : part.outlines) drawing_.strokes.push_back({Layer::Cut, outline, true, kCut, part.name});
  }

  // A point at `t` from the start of a tab's edge lies at `t` from the end of its mate, which runs the other way.
  void draw_shadows() {
    struct Place {
      const PlacedPanel* panel = nullptr;
      int side = 0, page = -1;
      Vec2 from() const { return panel->corners[side]; }
      Vec2 to() const { return panel->corners[(side + 1) % panel->corners.size()]; }
    };
    std::map<int, Place> place;
    for (const PlacedPart& part : layout_.parts)
      for (const PlacedPanel& panel : part.panels)
        for (int i = 0; i < static_cast<int>(panel.edges.size()); ++i) place[panel.edges[i]] = {&panel, i, part.page};
    for (const PlacedPart& part : layout_.parts) {
      for (const Tab& tab : part.tabs) {
        const auto at = place.find(tab.edge), under = place.find(tab.mate);
        if (at == place.end() || under == place.end() || under->second.page != number_) continue;
        const Vec2 along = (at->second.to() - at->second.from()).normalized();
        const Vec2 back = (under->second.from() - under->second.to()).normalized();
        Stroke shadow{Layer::Mark, {}, false, kFaint};
        for (int i : {0, 3, 2, 1}) {
          const Vec2 p = tab.corners[i] - at->second.from();
          shadow.points.push_back(under->second.to() + p.dot(along) * back +
                                  p.dot(perpendicular(along)) * perpendicular(back));
        }
        drawing_.strokes.push_back(std::move(shadow));
      }
    }
  }

  void write_centered(const std::string& text, const Vec2& center, double angle, double size, PenIndex pen) {
    const Vec2 back(-font_.width(text, size) / 2, -Font::cap_height(size) / 2);
    if (drawing_.is_painted() && brightness(color_under(drawing_, center)) < kDark) pen = kLight;
    drawing_.texts.push_back({text, center + rotation(angle) * back, angle, size, pen});
  }

  // Places of the key are in its own frame: origin at the lower left, x along the ruler.
  Vec2 in_key(double x, double y) const {
    if (page_.key_upright) return page_.key_at + Vec2(x, y);
    return page_.key_at + Vec2(key_size(page_.key_form, page_.ruler).y() - y, x);
  }
  void key_line(PenIndex pen, Layer layer, double x0, double y0, double x1, double y1) {
    line(layer, pen, in_key(x0, y0), in_key(x1, y1));
  }
  void key_text(const std::string& text, double x, double y, double pt) {
    drawing_.texts.push_back({text, in_key(x, y), page_.key_upright ? 0 : kPi / 2, pt * kMillimetresPerPoint, kText});
  }

  void draw_key() {
    if (options_.ruler) draw_ruler();
    if (page_.key_form == KeyForm::Row) draw_legend(page_.ruler + 11, 5.6, page_.ruler + 11, 1.2, 64);
    if (page_.key_form == KeyForm::Stack) draw_legend(1, 17.5, 1, 11.5, page_.ruler);
  }

  // The inside of the paper is drawn mirrored, but the model is not.
  void draw_inset(const Inset& inset) {
    need_picture_pens();
    const bool mirrored = options_.side != PaperSide::Outside;
    const double middle = inset.at.x() + inset.size.x() / 2;
    for (const Inset::Panel& panel : inset.panels) {
      std::vector<Vec2> corners = panel.corners;
      if (mirrored)
        for (Vec2& p : corners) p.x() = 2 * middle - p.x();
      drawing_.strokes.push_back({Layer::Mark, corners, true, panel.here ? kHere : kElsewhere});
      drawing_.strokes.push_back({Layer::Mark, std::move(corners), true, kHair});
    }
    const double line = (inset.size.y() - inset.size.x()) / static_cast<double>(inset.lines.size());
    for (std::size_t i = 0; i < inset.lines.size(); ++i) {
      const Vec2 at = inset.at + Vec2(0, line * (static_cast<double>(inset.lines.size() - i) - 0.75));
      drawing_.texts.push_back({inset.lines[i], at, 0, 6 * kMillimetresPerPoint, kText});
    }
  }

  void draw_ruler() {
    const double x = 1, y = 4.2;
    key_line(kFaint, Layer::Mark, x, y, x + page_.ruler, y);
    for (int mm = 0; mm <= static_cast<int>(page_.ruler); mm += 5)
      key_line(kFaint, Layer::Mark, x + mm, y, x + mm, y + (mm % 50 == 0 ? 2.6 : mm % 10 == 0 ? 1.8 : 1.0));
    const std::string end = fmt::format("{:g} mm", page_.ruler), hint = "print at 100 %";
    const double pt = 6, size = pt * kMillimetresPerPoint;
    key_text("0", x, 1.2, pt);
    key_text(end, x + page_.ruler - font_.width(end, size), 1.2, pt);
    if (page_.ruler >= 50) key_text(hint, x + (page_.ruler - font_.width(hint, size)) / 2, 1.2, pt);
  }

  void draw_legend(double x, double y, double title_x, double title_y, double room) {
    const double pt = 6, size = pt * kMillimetresPerPoint;
    // A laser goes by colour, so a legend must not use the colours of cuts and scores.
    const bool in_words = options_.style == DrawStyle::Laser;
    const std::tuple<const char*, const char*, PenIndex> rows[] = {{"cut", "red: cut", kCut},
                                                                   {"mountain fold", "blue: mountain", kMountain},
                                                                   {"valley fold", "light blue: valley", kValley}};
    for (const auto& [text, words, pen] : rows) {
      if (!in_words) key_line(pen, Layer::Mark, x, y + 0.8, x + 7, y + 0.8);
      key_text(in_words ? words : text, in_words ? x : x + 8, y, pt);
      x += in_words ? font_.width(words, size) + 4 : 8 + font_.width(text, size) + 4;
    }
    draw_title(title_x, title_y, room);
  }

  // Whole: in one line, made smaller where needed, or the name above the numbers. Only a name longer than that is cut.
  void draw_title(double x, double y, double room) {
    const std::string& name = options_.title;
    const std::string line = name.empty() ? page_facts() : fmt::format("{} · {}", name, page_facts());
    const double pt = size_that_fits(line, room, 5);
    if (width_of(line, pt) <= room) return key_text(line, x, y, pt);
    const double name_pt = size_that_fits(name, room, 3.5);
    std::string shown = name;
    while (width_of(shown == name ? name : shown + "…", name_pt) > room && !shown.empty()) {
      while ((shown.back() & 0xC0) == 0x80) shown.pop_back();  // the rest of a letter of several bytes
      shown.pop_back();
    }
    key_text(shown == name ? name : shown + "…", x, y + 1.8, name_pt);
    key_text(page_facts(), x, y - 0.5, size_that_fits(page_facts(), room, 3.5));
  }

  double width_of(const std::string& text, double pt) const { return font_.width(text, pt * kMillimetresPerPoint); }

  // 6 points, or less where it is too wide, but not under `smallest`.
  double size_that_fits(const std::string& text, double room, double smallest) const {
    const double width = width_of(text, 6);
    return width <= room ? 6 : std::max(smallest, std::floor(60 * room / width) / 10);
  }

  std::string page_facts() const {
    const Vec3& s = layout_.folded_size;
    return fmt::format("{:.0f} × {:.0f} × {:.0f} mm · page {} of {}{}", s.x(), s.y(), s.z(), number_ + 1,
                       layout_.pages.size(), layout_.has_taped_seams ? " · ° tape" : "");
  }

  const PageLayout& layout_;
  const Page& page_;
  const int number_;
  const DrawOptions& options_;
  const Font& font_;
  Drawing drawing_;
};

// As the other side of the paper shows it: left is right and mountains are valleys, but letters stay letters. Colours
// stay outside.
Drawing seen_from_inside(Drawing drawing, const Font& font) {
  const double width = drawing.size.x();
  drawing.fills.clear();
  drawing.picture = {};
  const auto flipped = [&](const Vec2& p) { return Vec2(width - p.x(), p.y()); };
  for (Stroke& stroke : drawing.strokes) {
    for (Vec2& p : stroke.points) p = flipped(p);
    if (stroke.layer == Layer::Mountain || stroke.layer == Layer::Valley) {
      stroke.layer = stroke.layer == Layer::Mountain ? Layer::Valley : Layer::Mountain;
      stroke.pen = stroke.pen == kMountain ? kValley : kMountain;
    }
  }
  for (Text& text : drawing.texts) {
    if (text.pen == kLight) text.pen = kText;
    const bool upright =
        text.angle > kPi / 2 - 1e-9;  // of a key that stands on its side: stays readable from the right
    text.start = flipped(text.start + rotation(text.angle) * Vec2(font.width(text.text, text.size), 0));
    text.angle = upright ? -kPi / 2 : -text.angle;
  }
  return drawing;
}

void set_texts(Drawing& drawing, TextForm form, const Font& font) {
  if (form == TextForm::Text) return;
  for (const Text& text : drawing.texts) {
    if (form == TextForm::None) break;
    const Eigen::Matrix2d turn = rotation(text.angle);
    for (std::vector<Vec2> outline : font.outlines(text.text, text.size)) {
      for (Vec2& p : outline) p = text.start + turn * p;
      drawing.strokes.push_back({Layer::Text, std::move(outline), true, text.pen});
    }
  }
  drawing.texts.clear();
}

void keep_layers(Drawing& drawing, std::initializer_list<Layer> layers) {
  const auto is_kept = [&](Layer layer) { return std::ranges::find(layers, layer) != layers.end(); };
  std::erase_if(drawing.strokes, [&](const Stroke& stroke) { return !is_kept(stroke.layer); });
  if (!is_kept(Layer::Text)) drawing.texts.clear();
}

void add_sides(Drawing outside, const DrawOptions& options, const Font& font, std::vector<Drawing>& drawings) {
  if (options.side != PaperSide::Outside) {
    Drawing inside = seen_from_inside(outside, font);
    if (options.side == PaperSide::Both) {
      keep_layers(outside, {Layer::Cut, Layer::Mountain, Layer::Valley});
      keep_layers(inside, {Layer::Mark, Layer::Text, Layer::Mountain, Layer::Valley});
      drawings.push_back(std::move(outside));
    }
    outside = std::move(inside);
  }
  set_texts(outside, options.text, font);
  drawings.push_back(std::move(outside));
}

}  // namespace

std::string_view name(Layer layer) {
  constexpr std::string_view kNames[] = {"CUT", "MOUNTAIN", "VALLEY", "MARK", "TEXT"};
  return kNames[static_cast<int>(layer)];
}

void check(const DrawOptions& options) {
  const auto [cut, gap] = options.perforation;
  if (!(cut == 0 || (cut >= 0.2 && cut <= 50)))
    throw InvalidOption(fmt::format("perforation: cuts of {:g} mm must be in [0.2, 50] mm", cut));
  if (cut > 0 && !(gap >= 0.2 && gap <= 50))
    throw InvalidOption(fmt::format("perforation: gaps of {:g} mm must be in [0.2, 50] mm", gap));
}

std::vector<Drawing> draw(const PageLayout& layout, const DrawOptions& options, const PanelPaint& paint) {
  check(options);
  const Font font;
  std::vector<Drawing> drawings;
  for (int page = 0; page < static_cast<int>(layout.pages.size()); ++page)
    add_sides(Drafter(layout, page, options, paint, font).run(), options, font, drawings);
  return drawings;
}

std::string decimal(double x) {
  std::string text = fmt::format("{:.7f}", x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace plico
