// Curves as an SVG figure, for what the dissertation shows as one.
#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace plico::bench {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

// Both axes begin at 0 and end a little after the largest value.
class Plot {
 public:
  Plot(std::string title, std::string x_name, std::string y_name)
      : title_(std::move(title)), x_name_(std::move(x_name)), y_name_(std::move(y_name)) {}

  void add(Curve curve) { curves_.push_back(std::move(curve)); }

  // Nothing is written when `path` is empty.
  void write(const std::string& path) const {
    if (path.empty()) return;
    std::ofstream out(path);
    out << fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        kLeft + kWide + kRight, kTop + kHigh + kBottom);
    out << text(kLeft, 20, "start", title_) << text(kLeft + kWide / 2.0, kTop + kHigh + 38, "middle", x_name_)
        << text(kLeft - 40, kTop - 8, "start", y_name_);
    write_axes(out);
    for (std::size_t i = 0; i < curves_.size(); ++i) write_curve(out, i);
    out << "</svg>\n";
  }

 private:
  static constexpr int kLeft = 60, kTop = 50, kWide = 480, kHigh = 300, kRight = 190, kBottom = 50, kTicks = 5;
  static constexpr const char* kColours[] = {"#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad",
                                             "#d68910", "#16808a", "#7f4f24", "#555555"};

  static std::string text(double x, double y, const char* anchor, const std::string& words) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
  }

  // The least of 1, 2, 5 times a power of ten that is no less than the largest value.
  double end_of(bool of_x) const {
    double largest = 1e-9;
    for (const Curve& curve : curves_)
      for (const auto& [x, y] : curve.points) largest = std::max(largest, of_x ? x : y);
    const double power = std::pow(10, std::floor(std::log10(largest)));
    for (double times : {1.0, 1.5, 2.0, 3.0, 5.0, 8.0})
      if (times * power >= largest) return times * power;
    return 10 * power;
  }

  double x_at(double x) const { return kLeft + kWide * x / end_of(true); }
  double y_at(double y) const { return kTop + kHigh * (1 - y / end_of(false)); }

  void write_axes(std::ostream& out) const {
    for (int i = 0; i <= kTicks; ++i) {
      const double x = end_of(true) * i / kTicks, y = end_of(false) * i / kTicks;
      out << fmt::format("<path d=\"M{0:.1f} {1}V{2}M{3} {4:.1f}H{5}\" stroke=\"#dddddd\" fill=\"none\"/>\n", x_at(x),
                         kTop, kTop + kHigh, kLeft, y_at(y), kLeft + kWide);
      out << text(x_at(x), kTop + kHigh + 18, "middle", fmt::format("{:.3g}", x))
          << text(kLeft - 8, y_at(y) + 4, "end", fmt::format("{:.3g}", y));
    }
  }

  void write_curve(std::ostream& out, std::size_t i) const {
    const std::string colour = kColours[i % std::size(kColours)];
    std::string line;
    for (const auto& [x, y] : curves_[i].points) line += fmt::format("{:.1f},{:.1f} ", x_at(x), y_at(y));
    out << fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", line, colour);
    const double y = kTop + 16 + 18.0 * static_cast<double>(i);
    out << fmt::format("<path d=\"M{} {:.1f}h20\" stroke=\"{}\" stroke-width=\"2\"/>\n", kLeft + kWide + 15, y, colour)
        << text(kLeft + kWide + 40, y + 4, "start", curves_[i].name);
  }

  std::string title_, x_name_, y_name_;
  std::vector<Curve> curves_;
};

}  // namespace plico::bench
