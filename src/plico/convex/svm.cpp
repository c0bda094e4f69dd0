#include "plico/convex/svm.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace plico {
namespace {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

// The soft margin with each hinge rounded off over `width`: twice differentiable almost everywhere, convex.
class SmoothedMargin {
 public:
  SmoothedMargin(const std::vector<Vec3>& below, const std::vector<Vec3>& above, double penalty) : penalty_(penalty) {
    for (const Vec3& p : below) signed_.emplace_back(-p.x(), -p.y(), -p.z(), -1);
    for (const Vec3& p : above) signed_.emplace_back(p.x(), p.y(), p.z(), 1);
  }

  double value(const Vec4& w, double width) const {
    double sum = w.head<3>().squaredNorm() / 2;
    for (const Vec4& z : signed_) {
      const double missing = 1 - z.dot(w);
      if (missing > width) sum += penalty_ * (missing - width / 2);
      if (missing > 0 && missing <= width) sum += penalty_ * missing * missing / (2 * width);
    }
    return sum;
  }

  void derivatives(const Vec4& w, double width, Vec4& gradient, Mat4& hessian) const {
    gradient << w.head<3>(), 0;
    hessian = Vec4(1, 1, 1, 1e-9).asDiagonal();  // the offset has no term of its own when no hinge bends
    for (const Vec4& z : signed_) {
      const double missing = 1 - z.dot(w);
      if (missing <= 0) continue;
      gradient -= penalty_ * std::min(1.0, missing / width) * z;
      if (missing <= width) hessian += penalty_ / width * z * z.transpose();
    }
  }

 private:
  std::vector<Vec4> signed_;  // y (x, 1)
  double penalty_;
};

// Newton with halved steps until the decrease is too small to count.
void minimize(const SmoothedMargin& margin, double width, Vec4& w) {
  double value = margin.value(w, width);
  for (int iteration = 0; iteration < 100; ++iteration) {
    Vec4 gradient;
    Mat4 hessian;
    margin.derivatives(w, width, gradient, hessian);
    const Vec4 step = -hessian.ldlt().solve(gradient);
    const double slope = gradient.dot(step);
    if (!(slope < -1e-9 * value)) return;
    double length = 1, next = margin.value(w + step, width);
    while (next > value + 0.1 * length * slope && length > 1e-9) {
      length /= 2;
      next = margin.value(w + length * step, width);
    }
    if (next >= value) return;
    w += length * step;
    value = next;
  }
}

}  // namespace

std::optional<Plane> svm_plane(const std::vector<Vec3>& below, const std::vector<Vec3>& above, double penalty) {
  const SmoothedMargin margin(below, above, penalty);
  Vec4 w = Vec4::Zero();
  for (double width = 1; width > 1e-6; width /= 4) minimize(margin, width, w);
  const double length = w.head<3>().norm();
  if (!(length > 1e-9)) return std::nullopt;
  return Plane{w.head<3>() / length, -w[3] / length};
}

}  // namespace plico
