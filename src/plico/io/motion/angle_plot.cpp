#include "plico/io/motion/angle_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plico/base/error.h"
#include "plico/io/text/xml_text.h"

namespace plico {
namespace {

constexpr double kWidth = 720, kHeight = 420;
constexpr double kLeft = 62, kRight = 500, kTop = 44, kBottom = 364;  // of the axes; the legend stands to the right
constexpr std::array<const char*, 8> kColors = {"#0b6fb8", "#d1495b", "#2e8b57", "#e09f1f",
                                                "#7b4fa6", "#00a6a6", "#8c564b", "#5a6b7b"};

struct Curve {
  int hinge = 0;  // the first of the group
  int mountains = 0, valleys = 0;
  int size() const { return mountains + valleys; }
};

double size_at(const FoldingPath& path, std::size_t waypoint, int hinge) {
  return std::abs(path.waypoints[waypoint].config[hinge]);
}

bool same_size(const FoldingPath& path, int a, int b, double equal) {
  for (std::size_t w = path.waypoints.size(); w-- > 0;)  // ends differ most
    if (std::abs(size_at(path, w, a) - size_at(path, w, b)) > equal) return false;
  return true;
}

// The sign where the angle is largest: a crease may pass through flat.
bool is_valley(const FoldingPath& path, int hinge) {
  double extreme = 0;
  for (const Waypoint& w : path.waypoints)
    if (std::abs(w.config[hinge]) > std::abs(extreme)) extreme = w.config[hinge];
  return extreme > 0;
}

double largest(const FoldingPath& path, int hinge) {
  double most = 0;
  for (std::size_t w = 0; w < path.waypoints.size(); ++w) most = std::max(most, size_at(path, w, hinge));
  return most;
}

// Groups of creases that move alike, the largest first; `still` counts those that never move.
std::vector<Curve> group(const FoldingPath& path, double equal, int& still) {
  std::vector<Curve> curves;
  for (int h = 0; h < path.waypoints.front().config.size(); ++h) {
    if (largest(path, h) <= equal) {
      ++still;
      continue;
    }
    auto curve =
        std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return same_size(path, c.hinge, h, equal); });
    if (curve == curves.end()) curve = curves.insert(curve, {h, 0, 0});
    ++(is_valley(path, h) ? curve->valleys : curve->mountains);
  }
  std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) { return a.size() > b.size(); });
  return curves;
}

class Figure {
 public:
  Figure(const FoldingPath& path, const AnglePlotOptions& options) : path_(path), options_(options) {
    curves_ = group(path, options.equal, still_);
    double most = 0;
    for (const Curve& curve : curves_) most = std::max(most, degrees(largest(path, curve.hinge)));
    step_ = most > 90 ? 30 : most > 45 ? 15 : most > 15 ? 5 : most > 3 ? 1 : 0.5;
    top_ = std::max(step_, step_ * std::ceil(most / step_ - 1e-9));
  }

  std::string draw() {
    svg_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"Helvetica,Arial,sans-serif\" font-size=\"12\" fill=\"#333\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        kWidth, kHeight);
    if (!options_.title.empty())
      svg_ += fmt::format("<text x=\"{}\" y=\"26\" font-size=\"15\" font-weight=\"bold\">{}</text>\n", kLeft,
                          xml_text(options_.title));
    axes();
    for (std::size_t i = curves_.size(); i-- > 0;) curve(curves_[i], color(i), i < colored() ? 2.2 : 0.8);
    legend();
    return svg_ + "</svg>\n";
  }

 private:
  std::size_t colored() const { return std::min(curves_.size(), static_cast<std::size_t>(options_.curves_in_color)); }
  const char* color(std::size_t i) const { return i < colored() ? kColors[i] : "#b8bec4"; }
  static double x(double time) { return kLeft + time * (kRight - kLeft); }
  double y(double angle_deg) const { return kBottom - angle_deg / top_ * (kBottom - kTop); }

  void axes() {
    svg_ += "<g stroke=\"#e3e6e8\" stroke-width=\"1\">\n";
    for (double a = 0; a <= top_ + 1e-9; a += step_)
      svg_ += fmt::format("<path d=\"M{:.2f} {:.2f}H{:.2f}\"/>\n", kLeft, y(a), kRight);
    for (int i = 0; i <= 5; ++i)
      svg_ += fmt::format("<path d=\"M{:.2f} {:.2f}V{:.2f}\"/>\n", x(i / 5.0), kTop, kBottom);
    svg_ += "</g>\n<g text-anchor=\"end\">\n";
    for (double a = 0; a <= top_ + 1e-9; a += step_)
      svg_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{:g}</text>\n", kLeft - 8, y(a) + 4, a);
    svg_ += "</g>\n<g text-anchor=\"middle\">\n";
    for (int i = 0; i <= 5; ++i)
      svg_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{:g}</text>\n", x(i / 5.0), kBottom + 18, i / 5.0);
    svg_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">time, from flat to folded</text>\n", (kLeft + kRight) / 2,
                        kBottom + 40);
    svg_ += fmt::format("<text transform=\"translate(20 {:.2f}) rotate(-90)\">size of the fold angle, degrees</text>\n",
                        (kTop + kBottom) / 2);
    svg_ += fmt::format(
        "</g>\n<path d=\"M{0:.2f} {1:.2f}V{2:.2f}H{3:.2f}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.2\"/>\n",
        kLeft, kTop, kBottom, kRight);
  }

  void curve(const Curve& curve, const char* color, double width) {
    svg_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" points=\"",
                        color, width);
    for (std::size_t w = 0; w < path_.waypoints.size(); ++w)
      svg_ += fmt::format("{}{:.2f},{:.2f}", w ? " " : "", x(path_.waypoints[w].time),
                          y(degrees(size_at(path_, w, curve.hinge))));
    svg_ += "\"/>\n";
  }

  static std::string kinds(const Curve& curve) {
    const auto count = [](int n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
    if (curve.mountains == 0) return count(curve.valleys, "valley");
    if (curve.valleys == 0) return count(curve.mountains, "mountain");
    return count(curve.mountains, "mountain") + ", " + count(curve.valleys, "valley");
  }

  void legend() {
    double at = kTop + 8;
    const auto line = [&](const char* stroke, double width, const std::string& text) {
      if (stroke)
        svg_ += fmt::format("<path d=\"M{:.2f} {:.2f}h22\" stroke=\"{}\" stroke-width=\"{}\"/>\n", kRight + 22, at - 4,
                            stroke, width);
      svg_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", kRight + 52, at, text);
      at += 20;
    };
    for (std::size_t i = 0; i < colored(); ++i) line(color(i), 2.2, kinds(curves_[i]));
    if (curves_.size() > colored()) {
      int creases = 0;
      for (std::size_t i = colored(); i < curves_.size(); ++i) creases += curves_[i].size();
      line(color(colored()), 0.8,
           fmt::format("{} more, {} curve{}", creases, curves_.size() - colored(),
                       curves_.size() - colored() == 1 ? "" : "s"));
    }
    if (still_ > 0) line(nullptr, 0, fmt::format("{} stay{} flat", still_, still_ == 1 ? "s" : ""));
  }

  const FoldingPath& path_;
  const AnglePlotOptions& options_;
  std::vector<Curve> curves_;
  int still_ = 0;
  double step_ = 30, top_ = 180;
  std::string svg_;
};

}  // namespace

std::string write_angle_plot(const FoldingPath& path, const AnglePlotOptions& options) {
  if (path.waypoints.empty()) throw InvalidInput("plot/empty", "a motion without waypoints has nothing to plot");
  if (!(options.equal > 0)) throw InvalidOption(fmt::format("equal = {} must be above 0", options.equal));
  if (options.curves_in_color < 1 || options.curves_in_color > static_cast<int>(kColors.size()))
    throw InvalidOption(
        fmt::format("curves in color = {} must be in [1, {}]", options.curves_in_color, kColors.size()));
  return Figure(path, options).draw();
}

}  // namespace plico
