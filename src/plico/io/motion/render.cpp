// Draws a linkage into a depth buffer at kSamples times the size and averages.
// A line lies in the surfaces that meet there, so depth alone cannot tell whether they hide it. Moving it towards the
// eye would, but then it also shines through what is thinner than that shift: near a corner of the outline, edges of
// the back. So each sample knows the surface seen there, and only surfaces that a line does not lie in can hide it.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/io/motion/panel_solid.h"
#include "plico/io/motion/piece_colors.h"
#include "plico/io/motion/png.h"

namespace plico {
namespace {

constexpr int kSamples = 3;
constexpr float kTie = 1e-6f;      // relative difference of depth below which two things are equally far: rounding
constexpr double kInPlane = 1e-9;  // distance from a surface's plane, of the panel's size, that counts as in it
using Colour = Eigen::Array3f;     // in [0, 1]

const Colour kFrontColour(0.945f, 0.700f, 0.290f), kBackColour(0.970f, 0.945f, 0.895f);
const Colour kSideColour(0.20f, 0.17f, 0.14f), kCreaseColour(0.45f, 0.35f, 0.22f);
const Colour kJointColour(0.62f, 0.36f, 0.28f);
const Colour kSky(0.985f, 0.985f, 0.98f), kGround(0.90f, 0.91f, 0.92f);

// A point on the screen: samples right and down, depth growing away from the eye, linear on the screen.
using ScreenPoint = Eigen::Vector3d;

// Numbers of the surfaces that a line lies in.
using Surfaces = std::vector<int>;

class View {
 public:
  View(const Camera& camera, const std::vector<Vec3>& content, int width, int height) {
    const double ca = plico::cos(camera.azimuth), sa = plico::sin(camera.azimuth);
    const double ce = plico::cos(camera.elevation), se = plico::sin(camera.elevation);
    backward_ = Vec3(sa * ce, -ca * ce, se);
    right_ = Vec3(ca, sa, 0);
    up_ = backward_.cross(right_);
    const double high = plico::tan(camera.field_of_view / 2) * 0.86;  // a margin around the content
    fit(content, high * width / height, high);
    scale_ = height / (2 * plico::tan(camera.field_of_view / 2));
    middle_ = Vec2(width / 2.0, height / 2.0);
  }

  ScreenPoint project(const Vec3& p) const {
    const Vec3 q = p - eye_;
    const double depth = -q.dot(backward_);
    return {middle_.x() + scale_ * q.dot(right_) / depth, middle_.y() - scale_ * q.dot(up_) / depth, -1 / depth};
  }
  const Vec3& backward() const { return backward_; }
  const Vec3& eye() const { return eye_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }

 private:
  // The nearest eye that sees all points within the slopes `wide` and `high`, looking at the middle of what it sees.
  void fit(const std::vector<Vec3>& points, double wide, double high) {
    double right = -1e300, left = -1e300, top = -1e300, bottom = -1e300;
    for (const Vec3& p : points) {
      const double x = p.dot(right_), y = p.dot(up_), z = p.dot(backward_);
      right = std::max(right, x + wide * z);
      left = std::max(left, -x + wide * z);
      top = std::max(top, y + high * z);
      bottom = std::max(bottom, -y + high * z);
    }
    const double distance = std::max({(right + left) / (2 * wide), (top + bottom) / (2 * high)});
    eye_ = right_ * (right - left) / 2 + up_ * (top - bottom) / 2 + backward_ * distance;
  }

  Vec3 backward_, right_, up_, eye_;
  Vec2 middle_;
  double scale_ = 1;
};

class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        colour_(std::size_t(width) * height, Colour::Zero()),
        alpha_(std::size_t(width) * height, 0),
        depth_(std::size_t(width) * height, std::numeric_limits<float>::infinity()),
        line_depth_(depth_),
        surface_(std::size_t(width) * height, -1) {}

  // Calls paint(pixel, depth) for the samples of a triangle, whichever way it turns.
  template <class Paint>
  void for_each_sample(const std::array<ScreenPoint, 3>& t, Paint paint) const {
    const double area = cross2(t[0], t[1], t[2].head<2>());
    if (area == 0 || !std::isfinite(area)) return;
    const auto [x0, x1] = std::minmax({t[0].x(), t[1].x(), t[2].x()});
    const auto [y0, y1] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
    const int left = std::max(0, int(std::floor(x0))), right = std::min(width_ - 1, int(std::ceil(x1)));
    const int top = std::max(0, int(std::floor(y0))), bottom = std::min(height_ - 1, int(std::ceil(y1)));
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const Vec2 at(x + 0.5, y + 0.5);
        const double a = cross2(t[1], t[2], at) / area, b = cross2(t[2], t[0], at) / area, c = 1 - a - b;
        if (a < 0 || b < 0 || c < 0) continue;
        paint(std::size_t(y) * width_ + x, float(a * t[0].z() + b * t[1].z() + c * t[2].z()));
      }
    }
  }

  void triangle(const std::array<ScreenPoint, 3>& t, const Colour& colour, int surface) {
    for_each_sample(t, [&](std::size_t i, float depth) {
      if (depth >= depth_[i]) return;
      depth_[i] = depth;
      surface_[i] = surface;
      set(i, colour);
    });
  }
  // A line `width` samples wide, where no surface hides it; drawn when all surfaces are. Of two lines that are equally
  // far, the later is seen.
  void line(const ScreenPoint& a, const ScreenPoint& b, double width, const Colour& colour, const Surfaces& within) {
    Vec2 side = perpendicular((b - a).head<2>());
    if (side.norm() == 0) return;
    side *= width / 2 / side.norm();
    const ScreenPoint s(side.x(), side.y(), 0);
    const auto paint = [&](std::size_t i, float depth) {
      if (hidden(i, depth, within) || depth > line_depth_[i] + kTie * std::abs(depth)) return;
      line_depth_[i] = depth;
      set(i, colour);
    };
    for_each_sample({a + s, a - s, b + s}, paint);
    for_each_sample({b + s, a - s, b - s}, paint);
  }

  void set_background(std::size_t i, const Colour& colour) {
    if (alpha_[i] == 0) set(i, colour);
  }
  int width() const { return width_; }
  int height() const { return height_; }

  Picture averaged() const {
    Picture picture{width_ / kSamples, height_ / kSamples, {}};
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) append_pixel(picture, x, y);
    return picture;
  }

 private:
  void set(std::size_t i, const Colour& colour) {
    colour_[i] = colour;
    alpha_[i] = 1;
  }
  // A surface that is as far as the line but not its own lies on it.
  bool hidden(std::size_t i, float depth, const Surfaces& within) const {
    return depth >= depth_[i] - kTie * std::abs(depth) && std::ranges::find(within, surface_[i]) == within.end();
  }
  static double cross2(const ScreenPoint& a, const ScreenPoint& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }
  void append_pixel(Picture& picture, int x, int y) const {
    Colour sum = Colour::Zero();
    float alpha = 0;
    for (int j = 0; j < kSamples; ++j)
      for (int i = 0; i < kSamples; ++i) {
        const std::size_t at = std::size_t(y * kSamples + j) * width_ + x * kSamples + i;
        sum += colour_[at] * alpha_[at];
        alpha += alpha_[at];
      }
    for (int k = 0; k < 3; ++k)
      picture.rgba.push_back(
          std::uint8_t(std::lround(255 * std::clamp(alpha > 0 ? sum[k] / alpha : 0.0f, 0.0f, 1.0f))));
    picture.rgba.push_back(std::uint8_t(std::lround(255 * alpha / (kSamples * kSamples))));
  }

  int width_, height_;
  std::vector<Colour> colour_;
  std::vector<float> alpha_, depth_, line_depth_;
  std::vector<int> surface_;  // seen at each sample, -1 for none
};

// Where the panels are, put where they are at home, all of it turned.
std::vector<Pose> poses_of(const Linkage& linkage, const Configuration& config, const PictureOptions& options) {
  std::vector<Pose> poses = folding_map(linkage, config);
  for (std::size_t p = 0; p < options.home.size(); ++p) poses[p] = options.home[p] * poses[p];
  Pose whole = Pose::Identity();
  whole.linear() = options.turn;
  if (options.turn != Eigen::Matrix3d::Identity())
    for (Pose& pose : poses) pose = whole * pose;
  return poses;
}

// Every point of every panel, plates included.
std::vector<Vec3> points_of(const Linkage& linkage, const std::vector<Pose>& poses) {
  std::vector<Vec3> points;
  for (int p = 0; p < linkage.num_panels(); ++p)
    for (const Vec3& v : linkage.panels[p])
      for (double side : {-0.5, 0.5}) points.push_back(poses[p] * (v + Vec3(0, 0, side * linkage.thickness)));
  return points;
}

// A key light from the upper left behind the eye, and soft light from above.
Colour lit(const Colour& colour, const Vec3& normal, const View& view) {
  const Vec3 key = (view.backward() + 0.55 * view.up() - 0.6 * view.right()).normalized();
  const double towards = 0.5 + 0.5 * normal.dot(key);  // wrapped around: no side is black
  const double light = 0.58 + 0.38 * towards * towards + 0.08 * (0.5 + 0.5 * normal.z());
  return (colour * float(light)).min(1.0f);
}

void draw_triangle(Canvas& canvas, const View& view, const std::vector<Vec3>& points, const std::array<int, 3>& corners,
                   const Colour& colour, int surface) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
  if (normal.dot(view.eye() - points[a]) <= 0) return;
  canvas.triangle({view.project(points[a]), view.project(points[b]), view.project(points[c])},
                  lit(colour, normal, view), surface);
}

// The surfaces of the panels are numbered panel by panel: front, back, and the wall below each side. Those of a sheet
// without thickness are one, the front.
class SurfaceNumbers {
 public:
  explicit SurfaceNumbers(const Linkage& linkage) : linkage_(linkage) {
    int next = 0;
    for (const auto& outline : linkage.panels) {
      first_.push_back(next);
      next += 2 + static_cast<int>(outline.size());
    }
  }
  int front(int panel) const { return first_[panel]; }
  int back(int panel) const { return first_[panel] + (linkage_.thickness > 0 ? 1 : 0); }
  int wall(int panel, int side) const { return first_[panel] + 2 + side; }

  // Adds the surfaces of a panel that hold the line from a to b, in the flat state.
  void add_holding(int panel, const Vec3& a, const Vec3& b, Surfaces& within) const {
    const std::vector<Vec3>& outline = linkage_.panels[panel];
    const int n = static_cast<int>(outline.size());
    double size = 0;
    for (const Vec3& p : outline) size = std::max(size, (p - outline.front()).norm());
    const auto in_plane = [&](const Vec3& normal, const Vec3& point) {
      return std::max(std::abs(normal.dot(a - point)), std::abs(normal.dot(b - point))) <= kInPlane * size;
    };
    const Vec3 half(0, 0, linkage_.thickness / 2);
    if (in_plane(Vec3::UnitZ(), half)) within.push_back(front(panel));
    if (linkage_.thickness == 0) return;
    if (in_plane(Vec3::UnitZ(), -half)) within.push_back(back(panel));
    for (int i = 0; i < n; ++i) {
      const Vec3 along = (outline[(i + 1) % n] - outline[i]).normalized();
      if (in_plane(Vec3(along.y(), -along.x(), 0), outline[i])) within.push_back(wall(panel, i));
    }
  }

 private:
  const Linkage& linkage_;
  std::vector<int> first_;
};

Colour front_colour(const std::vector<Color>& colors, int panel) {
  if (panel >= static_cast<int>(colors.size())) return kFrontColour;
  return Eigen::Array3d(colors[panel][0], colors[panel][1], colors[panel][2]).cast<float>();
}

void draw_panels(Canvas& canvas, const View& view, const Linkage& linkage, const std::vector<Pose>& poses,
                 const std::vector<Color>& colors) {
  const SurfaceNumbers numbers(linkage);
  for (int p = 0; p < linkage.num_panels(); ++p) {
    PanelSolid solid = panel_solid(linkage, p);
    for (Vec3& v : solid.points) v = poses[p] * v;
    const Colour front = front_colour(colors, p);
    for (const auto& t : solid.front) draw_triangle(canvas, view, solid.points, t, front, numbers.front(p));
    for (const auto& t : solid.back) draw_triangle(canvas, view, solid.points, t, kBackColour, numbers.back(p));
    for (std::size_t i = 0; i < solid.walls.size(); ++i)  // two triangles a side
      draw_triangle(canvas, view, solid.points, solid.walls[i], kBackColour * 0.85f,
                    numbers.wall(p, static_cast<int>(i / 2)));
  }
}

// The side of a panel that lies nearest to a hinge, in the flat state.
int side_at(const std::vector<Vec3>& outline, const Hinge& hinge) {
  const auto away = [&](int i) {
    return (outline[i] + outline[(i + 1) % outline.size()] - hinge.from - hinge.to).squaredNorm();
  };
  int nearest = 0;
  for (int i = 1; i < static_cast<int>(outline.size()); ++i)
    if (away(i) < away(nearest)) nearest = i;
  return nearest;
}

// What joins the trimmed panels of thick hinges: a strip between their mid-planes that gives way outwards a little, so
// that it is seen on the side of a pile.
void draw_joints(Canvas& canvas, const View& view, const Linkage& linkage, const std::vector<Pose>& poses) {
  int surface = 0;
  for (const auto& outline : linkage.panels) surface += 2 + static_cast<int>(outline.size());
  for (const Hinge& hinge : linkage.hinges) {
    if (hinge.roll == 0) continue;
    std::vector<Vec3> points;  // two of the left panel, two of the right one, two in between
    Vec3 inwards = Vec3::Zero();
    for (int p : {hinge.left, hinge.right}) {
      const std::vector<Vec3>& outline = linkage.panels[p];
      const int i = side_at(outline, hinge);
      const Vec3 a = poses[p] * outline[i], b = poses[p] * outline[(i + 1) % outline.size()];
      const Vec3 across = poses[p].linear() * Vec3::UnitZ().cross(hinge.to - hinge.from).normalized();
      inwards += p == hinge.left ? across : Vec3(-across);
      points.insert(points.end(), {a, b});
    }
    const Vec3 out = -0.3 * hinge.roll * inwards;
    points.push_back((points[0] + points[3]) / 2 + out);
    points.push_back((points[1] + points[2]) / 2 + out);
    for (const std::array<int, 3>& t : {std::array{0, 1, 5}, {0, 5, 4}, {4, 5, 2}, {4, 2, 3}})
      for (const std::array<int, 3>& corners : {t, std::array{t[0], t[2], t[1]}})
        draw_triangle(canvas, view, points, corners, kJointColour, surface);
    ++surface;
  }
}

// Sides in ink, creases lighter. A crease belongs to two panels and is drawn with both.
void draw_lines(Canvas& canvas, const View& view, const Linkage& linkage, const std::vector<Pose>& poses) {
  const double width = std::max(1.4 * kSamples, canvas.height() / 700.0);
  const SurfaceNumbers numbers(linkage);
  for (int p = 0; p < linkage.num_panels(); ++p) {
    const PanelSolid solid = panel_solid(linkage, p);
    const int n = static_cast<int>(linkage.panels[p].size());
    for (int i = 0; i < static_cast<int>(solid.points.size()); ++i) {
      const int j = i % n == n - 1 ? i - n + 1 : i + 1;
      Surfaces within;
      numbers.add_holding(p, solid.points[i], solid.points[j], within);
      canvas.line(view.project(poses[p] * solid.points[i]), view.project(poses[p] * solid.points[j]), width,
                  kSideColour, within);
    }
  }
  for (const Hinge& hinge : linkage.hinges) {
    if (hinge.roll > 0) continue;  // draw_joints()
    Surfaces within;
    for (int p : {hinge.left, hinge.right}) numbers.add_holding(p, hinge.from, hinge.to, within);
    canvas.line(view.project(poses[hinge.left] * hinge.from), view.project(poses[hinge.left] * hinge.to), width,
                kCreaseColour, within);
  }
}

// How dark the ground is under the panels: their outline from above, blurred three times by a box.
std::vector<float> soft_shadow(const Canvas& canvas, const View& view, const Linkage& linkage,
                               const std::vector<Pose>& poses, double ground) {
  const int w = canvas.width(), h = canvas.height();
  std::vector<float> shade(std::size_t(w) * h, 0), next(shade.size());
  for (int p = 0; p < linkage.num_panels(); ++p) {
    const PanelSolid solid = panel_solid(linkage, p);
    for (const auto& [a, b, c] : solid.front) {
      std::array<ScreenPoint, 3> t;
      int k = 0;
      for (int corner : {a, b, c}) {
        Vec3 v = poses[p] * solid.points[corner];
        v.z() = ground;
        t[k++] = view.project(v);
      }
      canvas.for_each_sample(t, [&](std::size_t i, float) { shade[i] = 1; });
    }
  }
  const int radius = std::max(1, h / 60);
  for (int pass = 0; pass < 3; ++pass) {
    for (const auto [count, length, step, stride] : {std::array{h, w, 1, w}, std::array{w, h, w, 1}}) {
      for (int line = 0; line < count; ++line) {
        const std::size_t base = std::size_t(line) * stride;
        float sum = 0;
        for (int i = -radius; i < length; ++i) {
          if (i + radius < length) sum += shade[base + std::size_t(i + radius) * step];
          if (i - radius - 1 >= 0) sum -= shade[base + std::size_t(i - radius - 1) * step];
          if (i >= 0) next[base + std::size_t(i) * step] = sum / float(2 * radius + 1);
        }
      }
      shade.swap(next);
    }
  }
  return shade;
}

void draw_background(Canvas& canvas, const std::vector<float>& shadow) {
  for (int y = 0; y < canvas.height(); ++y) {
    const float t = float(y) / float(canvas.height());
    const Colour paper = kSky + (kGround - kSky) * t;
    for (int x = 0; x < canvas.width(); ++x) {
      const std::size_t i = std::size_t(y) * canvas.width() + x;
      canvas.set_background(i, paper * (1 - 0.20f * shadow[i]));
    }
  }
}

}  // namespace

Picture render(const Linkage& linkage, const Configuration& config, const PictureOptions& options) {
  require_within_limits(linkage, config, "the picture", kLimitRounding);
  for (const auto& [name, value] : {std::pair("width", options.width), {"height", options.height}})
    if (value < 16 || value > 8192) throw InvalidOption(fmt::format("{} = {} must be in [16, 8192]", name, value));
  if (linkage.num_panels() == 0) throw InvalidInput("linkage/empty", "a linkage without panels cannot be drawn");
  if (!options.home.empty() && static_cast<int>(options.home.size()) != linkage.num_panels())
    throw InvalidInput("linkage/home",
                       fmt::format("{} motions for {} panels", options.home.size(), linkage.num_panels()));
  std::vector<Vec3> content = options.room;
  for (const Configuration& c : options.frame) {
    const std::vector<Vec3> points = points_of(linkage, poses_of(linkage, c, options));
    content.insert(content.end(), points.begin(), points.end());
  }
  const std::vector<Pose> poses = poses_of(linkage, config, options);
  const std::vector<Vec3> now = points_of(linkage, poses);
  content.insert(content.end(), now.begin(), now.end());

  double ground = content.front().z();
  for (const Vec3& p : content) ground = std::min(ground, p.z());
  // The shadow is part of the picture.
  if (!options.transparent)
    for (const Vec3& p : now) content.emplace_back(p.x(), p.y(), ground);

  Canvas canvas(options.width * kSamples, options.height * kSamples);
  const View view(options.camera, content, canvas.width(), canvas.height());
  draw_panels(canvas, view, linkage, poses, options.colors.empty() ? piece_colors(linkage) : options.colors);
  draw_joints(canvas, view, linkage, poses);
  draw_lines(canvas, view, linkage, poses);
  if (!options.transparent) {
    draw_background(canvas, soft_shadow(canvas, view, linkage, poses, ground));
  }
  return canvas.averaged();
}

}  // namespace plico
