#include "plico/io/pattern/svg_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "plico/base/libm.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

constexpr std::string_view kPathCommands = "MmLlHhVvZzCcSsQqTtAa";

SvgStroke straight_stroke(const Vec2& a, const Vec2& b) { return {a, b}; }
SvgStroke cubic_stroke(const Vec2& a, const Vec2& c, const Vec2& d, const Vec2& b) { return {a, b, true, c, d}; }

SvgStroke quadratic_stroke(const Vec2& a, const Vec2& control, const Vec2& b) {
  return cubic_stroke(a, a + 2.0 / 3 * (control - a), b + 2.0 / 3 * (control - b), b);
}

// The part of the unit circle between two angles, at most 90 degrees, as one cubic.
SvgStroke circle_stroke(double from, double to) {
  const double handle = 4.0 / 3 * plico::tan((to - from) / 4);
  const Vec2 a(plico::cos(from), plico::sin(from)), b(plico::cos(to), plico::sin(to));
  return cubic_stroke(a, a + handle * Vec2(-a.y(), a.x()), b - handle * Vec2(-b.y(), b.x()), b);
}

struct Arc {
  double rx, ry, turn;  // radii, and the angle of the x-axis in radians
  bool large, sweep;
};

// From an arc's ends to its centre, SVG 1.1 appendix F.6. Radii that are too small for the ends are enlarged.
void add_arc(const Vec2& from, Arc arc, const Vec2& to, std::vector<SvgStroke>& strokes) {
  if (from == to) return;
  if (arc.rx == 0 || arc.ry == 0) {
    strokes.push_back(straight_stroke(from, to));
    return;
  }
  arc.rx = std::abs(arc.rx), arc.ry = std::abs(arc.ry);
  const Eigen::Matrix2d turned = rotation(arc.turn);
  const Vec2 middle = (from + to) / 2, half = turned.transpose() * ((from - to) / 2);
  Vec2 unit(half.x() / arc.rx, half.y() / arc.ry);  // half the chord where the ellipse is a unit circle
  const double reach = unit.norm(), grown = std::max(1.0, reach);
  unit /= grown;
  const double inner = std::sqrt(std::max(0.0, 1 - unit.squaredNorm()));
  const double side = arc.large == arc.sweep ? -1 : 1;
  const Vec2 centre = unit.norm() > 0 ? Vec2(side * inner * Vec2(unit.y(), -unit.x()) / unit.norm()) : Vec2(0, 0);
  const Vec2 start = unit - centre, end = -unit - centre;
  const double first = plico::atan2(start.y(), start.x());
  double angle = plico::atan2(end.y(), end.x()) - first;
  if (arc.sweep && angle < 0) angle += 2 * kPi;
  if (!arc.sweep && angle > 0) angle -= 2 * kPi;

  if (!std::isfinite(angle)) {  // radii so small or large that nothing is left of the arc
    strokes.push_back(straight_stroke(from, to));
    return;
  }
  const auto placed = [&](const Vec2& p) {
    const Vec2 q = p + centre;
    return Vec2(turned * Vec2(grown * arc.rx * q.x(), grown * arc.ry * q.y()) + middle);
  };
  const int pieces = std::clamp(static_cast<int>(std::ceil(std::abs(angle) / (kPi / 2) - 1e-9)), 1, 4);
  for (int i = 0; i < pieces; ++i) {
    // Ends that meet others are taken as they were drawn.
    SvgStroke piece = circle_stroke(first + angle * i / pieces, first + angle * (i + 1) / pieces);
    piece = {i == 0 ? from : strokes.back().b, i + 1 == pieces ? to : placed(piece.b), true, placed(piece.c),
             placed(piece.d)};
    strokes.push_back(piece);
  }
}

class PathParser {
 public:
  explicit PathParser(std::string_view text) : text_(text) {}

  SvgPath run() {
    for (skip_separators(); path_.error.empty() && at_ < text_.size(); skip_separators()) {
      const bool letter = kPathCommands.find(text_[at_]) != std::string_view::npos;
      if (letter) {
        command_ = text_[at_++];
        first_ = true;
      } else if (command_ == 0 || is_close()) {
        fail(fmt::format("has {}, where a command must stand,", quoted_word(text_.substr(at_, 1))));
        break;
      }
      step();
      first_ = false;
    }
    return std::move(path_);
  }

 private:
  bool is_close() const { return command_ == 'Z' || command_ == 'z'; }
  bool relative() const { return command_ >= 'a'; }
  char kind() const { return static_cast<char>(relative() ? command_ - 'a' + 'A' : command_); }

  void fail(const std::string& what) {
    if (path_.error.empty()) path_.error = fmt::format("the path {} at byte {}", what, at_);
  }

  void skip_separators() { at_ = std::min(text_.find_first_not_of(" \t\r\n\f,", at_), text_.size()); }

  double number() {
    skip_separators();
    const bool plus = at_ < text_.size() && text_[at_] == '+';
    double value = 0;
    const char *const begin = text_.data() + at_ + (plus ? 1 : 0), *const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || !std::isfinite(value)) {
      fail(fmt::format("lacks a number after {}", command_));
      return 0;
    }
    at_ = static_cast<std::size_t>(stop - text_.data());
    return value;
  }

  // Flags may stand without anything between them.
  bool one_or_zero() {
    skip_separators();
    if (at_ >= text_.size() || (text_[at_] != '0' && text_[at_] != '1')) {
      fail("lacks a flag of an arc, 0 or 1,");
      return false;
    }
    return text_[at_++] == '1';
  }

  Vec2 point() {
    const double x = number(), y = number();
    return Vec2(x, y) + (relative() ? here_ : Vec2(0, 0));
  }

  void go(const Vec2& to) {
    if (path_.error.empty()) path_.strokes.push_back(straight_stroke(here_, to));
    here_ = to;
    cubic_.reset(), quadratic_.reset();
  }

  void cubic(const Vec2& c, const Vec2& d, const Vec2& to) {
    if (path_.error.empty()) path_.strokes.push_back(cubic_stroke(here_, c, d, to));
    here_ = to;
    cubic_ = d, quadratic_.reset();
  }

  void quadratic(const Vec2& control, const Vec2& to) {
    if (path_.error.empty()) path_.strokes.push_back(quadratic_stroke(here_, control, to));
    here_ = to;
    quadratic_ = control, cubic_.reset();
  }

  // The control point that makes the next curve go on smoothly; where we are when the last was no such curve.
  Vec2 mirrored(const std::optional<Vec2>& control) const { return control ? Vec2(2 * here_ - *control) : here_; }

  void move() {
    const Vec2 to = point();
    if (!first_) return go(to);
    here_ = start_ = to;
    cubic_.reset(), quadratic_.reset();
  }

  void close() {
    if (here_ != start_) go(start_);
    cubic_.reset(), quadratic_.reset();
  }

  void arc() {
    const double rx = number(), ry = number(), turn = radians(number());
    const bool large = one_or_zero(), sweep = one_or_zero();
    const Vec2 to = point();
    if (path_.error.empty()) add_arc(here_, {rx, ry, turn, large, sweep}, to, path_.strokes);
    here_ = to;
    cubic_.reset(), quadratic_.reset();
  }

  void curve() {
    const Vec2 c = kind() == 'C' ? point() : mirrored(cubic_), d = point(), to = point();
    cubic(c, d, to);
  }

  void parabola() {
    const Vec2 control = kind() == 'Q' ? point() : mirrored(quadratic_), to = point();
    quadratic(control, to);
  }

  void step() {
    switch (kind()) {
      case 'M':
        return move();
      case 'L':
        return go(point());
      case 'H':
        return go(Vec2(number() + (relative() ? here_.x() : 0), here_.y()));
      case 'V':
        return go(Vec2(here_.x(), number() + (relative() ? here_.y() : 0)));
      case 'C':
      case 'S':
        return curve();
      case 'Q':
      case 'T':
        return parabola();
      case 'A':
        return arc();
      default:
        return close();
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  char command_ = 0;
  bool first_ = true;  // the arguments are the first after their letter
  Vec2 here_{0, 0}, start_{0, 0};
  std::optional<Vec2> cubic_, quadratic_;  // the last control point of the last curve of that kind
  SvgPath path_;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0;
  return (a + t * (b - a) - p).norm();
}

}  // namespace

SvgPath parse_path(std::string_view d) { return PathParser(d).run(); }

std::vector<SvgStroke> ellipse_strokes(const Vec2& centre, double rx, double ry) {
  const std::array<Vec2, 4> at{Vec2(centre.x() + rx, centre.y()), Vec2(centre.x(), centre.y() + ry),
                               Vec2(centre.x() - rx, centre.y()), Vec2(centre.x(), centre.y() - ry)};
  std::vector<SvgStroke> strokes;
  for (std::size_t i = 0; i < 4; ++i) add_arc(at[i], {rx, ry, 0, false, true}, at[(i + 1) % 4], strokes);
  return strokes;
}

std::vector<SvgStroke> rectangle_strokes(const Vec2& corner, const Vec2& size, double rx, double ry) {
  const double x = corner.x(), y = corner.y(), w = size.x(), h = size.y();
  if (rx <= 0 || ry <= 0)
    return {straight_stroke({x, y}, {x + w, y}), straight_stroke({x + w, y}, {x + w, y + h}),
            straight_stroke({x + w, y + h}, {x, y + h}), straight_stroke({x, y + h}, {x, y})};
  rx = std::min(rx, w / 2), ry = std::min(ry, h / 2);
  const std::array<Vec2, 8> at{Vec2(x + rx, y),         Vec2(x + w - rx, y),     Vec2(x + w, y + ry),
                               Vec2(x + w, y + h - ry), Vec2(x + w - rx, y + h), Vec2(x + rx, y + h),
                               Vec2(x, y + h - ry),     Vec2(x, y + ry)};
  std::vector<SvgStroke> strokes;
  for (std::size_t i = 0; i < 8; i += 2) {
    if (at[i] != at[i + 1]) strokes.push_back(straight_stroke(at[i], at[i + 1]));
    add_arc(at[i + 1], {rx, ry, 0, false, true}, at[(i + 2) % 8], strokes);
  }
  return strokes;
}

std::vector<Vec2> flatten(const SvgStroke& stroke, double tolerance) {
  if (!stroke.curved) return {stroke.a, stroke.b};
  // A control point pulls the curve by at most 3/4 of its distance.
  const double pull =
      std::max(distance_to_segment(stroke.c, stroke.a, stroke.b), distance_to_segment(stroke.d, stroke.a, stroke.b));
  int pieces = 1;
  if (0.75 * pull > tolerance) {
    const double bend =
        std::max((stroke.a - 2 * stroke.c + stroke.d).norm(), (stroke.c - 2 * stroke.d + stroke.b).norm());
    pieces = std::max(2, static_cast<int>(std::ceil(std::sqrt(0.75 * bend / tolerance))));
  }
  std::vector<Vec2> points{stroke.a};
  for (int i = 1; i < pieces; ++i) {
    const double t = static_cast<double>(i) / pieces, s = 1 - t;
    points.emplace_back(s * s * s * stroke.a + 3 * s * s * t * stroke.c + 3 * s * t * t * stroke.d +
                        t * t * t * stroke.b);
  }
  points.push_back(stroke.b);
  return points;
}

}  // namespace plico
