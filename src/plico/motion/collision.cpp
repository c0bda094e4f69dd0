#include "plico/motion/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "plico/base/error.h"
#include "plico/motion/penetration.h"

namespace plico {
namespace {

double chosen(double given, double by_default, const char* what) {
  if (!(given >= 0) || !std::isfinite(given))
    throw InvalidOption(fmt::format("{} = {} must be a finite length, at least 0", what, given));
  return given > 0 ? given : by_default;
}

// Does the panel lie on one side of the hinge's line (+1: its left), up to rounding?
bool beside(const std::vector<Vec3>& outline, const Hinge& hinge, int side) {
  const Vec2 from = hinge.from.head<2>(), along = (hinge.to - hinge.from).head<2>();
  for (const Vec3& corner : outline) {
    const Vec2 to_corner = corner.head<2>() - from;
    if (side * cross(along, to_corner) < -1e-9 * along.norm() * (along.norm() + to_corner.norm())) return false;
  }
  return true;
}

}  // namespace

CollisionChecker::CollisionChecker(const Linkage& linkage, const CollisionOptions& options)
    : linkage_(linkage),
      clearance_(chosen(options.clearance, default_clearance(linkage), "clearance")),
      touch_(chosen(options.touch, 1e-3 * clearance_, "touch")),
      plates_(make_plates(linkage, clearance_)),
      part_(parts(linkage)),
      exempt_(linkage.panels.size()),
      corners_(plates_.corners.size()),
      normals_(plates_.size()),
      boxes_(plates_.size()),
      sorted_(plates_.size()),
      order_(plates_.size()) {
  find_exempt_pairs();
  std::iota(order_.begin(), order_.end(), 0);
}

void CollisionChecker::find_exempt_pairs() {
  if (plates_.are_thick) return;
  for (const Hinge& hinge : linkage_.hinges) {
    if (!beside(linkage_.panels[hinge.left], hinge, 1) || !beside(linkage_.panels[hinge.right], hinge, -1)) continue;
    exempt_[hinge.left].push_back(hinge.right);
    exempt_[hinge.right].push_back(hinge.left);
  }
}

void CollisionChecker::place(const Configuration& config) {
  folding_map(linkage_, config, poses_);
  for (int i = 0; i < plates_.size(); ++i) {
    const Pose& pose = poses_[plates_.panel[i]];
    Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int c = plates_.first[i]; c < plates_.first[i + 1]; ++c) {
      corners_[c].noalias() = pose.linear() * plates_.corners[c];
      corners_[c] += pose.translation();
      low = low.min(corners_[c].array());
      high = high.max(corners_[c].array());
    }
    normals_[i] = pose.linear().col(2);
    for (int k = 0; k < 3; ++k) boxes_[i].low[k] = low[k], boxes_[i].high[k] = high[k];
  }
}

// Sweeps along the axis on which the boxes spread most. Between neighbouring states of a motion the order hardly
// changes, so it is repaired by insertion.
void CollisionChecker::sort_boxes() {
  double sum[3] = {}, squares[3] = {};
  for (const Box& box : boxes_)
    for (int k = 0; k < 3; ++k) sum[k] += box.low[k], squares[k] += box.low[k] * box.low[k];
  const double n = std::max<double>(1, boxes_.size());
  const auto variance = [&](int k) { return squares[k] / n - (sum[k] / n) * (sum[k] / n); };
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (variance(k) > variance(axis)) axis = k;
  const auto before = [&](int a, int b) {
    return boxes_[a].low[axis] < boxes_[b].low[axis] || (boxes_[a].low[axis] == boxes_[b].low[axis] && a < b);
  };
  int turned = 0;
  for (std::size_t i = 1; i < order_.size(); ++i) turned += before(order_[i], order_[i - 1]);
  if (axis != axis_ || turned > static_cast<int>(order_.size()) / 4) {
    std::sort(order_.begin(), order_.end(), before);
  } else {
    for (std::size_t i = 1; i < order_.size(); ++i) {
      const int moved = order_[i];
      std::size_t to = i;
      for (; to > 0 && before(moved, order_[to - 1]); --to) order_[to] = order_[to - 1];
      order_[to] = moved;
    }
  }
  axis_ = axis;
  for (std::size_t i = 0; i < order_.size(); ++i) sorted_[i] = boxes_[order_[i]];
}

bool CollisionChecker::may_collide(int plate_a, int plate_b) const {
  const int a = plates_.panel[plate_a], b = plates_.panel[plate_b];
  return a != b && part_[a] == part_[b] && std::find(exempt_[a].begin(), exempt_[a].end(), b) == exempt_[a].end();
}

bool CollisionChecker::penetrating(int plate_a, int plate_b) {
  const auto placed = [&](int i) {
    return PlacedPlate{&corners_[plates_.first[i]], plates_.num_sides(i), normals_[i], plates_.are_thick};
  };
  return penetrate(placed(plate_a), placed(plate_b), touch_);
}

template <class Visit>
bool CollisionChecker::sweep(Visit visit) {
  sort_boxes();
  const int u = axis_, v = (axis_ + 1) % 3, w = (axis_ + 2) % 3;
  const std::size_t n = sorted_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Box box = sorted_[i];
    for (std::size_t j = i + 1; j < n && sorted_[j].low[u] <= box.high[u]; ++j) {
      const Box& other = sorted_[j];
      // Without branches: which of the four fails is a coin toss.
      const bool meet = (other.low[v] <= box.high[v]) & (box.low[v] <= other.high[v]) & (other.low[w] <= box.high[w]) &
                        (box.low[w] <= other.high[w]);
      if (meet && visit(order_[i], order_[j])) return true;
    }
  }
  return false;
}

bool CollisionChecker::over_folded(const Configuration& config, std::vector<PanelPair>* all) const {
  bool any = false;
  for (int h = 0; h < linkage_.num_hinges(); ++h) {
    if (std::abs(config[h]) <= kPi + 1e-9) continue;
    any = true;
    const auto [a, b] = std::minmax(linkage_.hinges[h].left, linkage_.hinges[h].right);
    if (all) all->push_back({a, b});
  }
  return any;
}

bool CollisionChecker::collides(const Configuration& config) {
  if (over_folded(config, nullptr)) return true;
  place(config);
  if (last_a_ >= 0 && penetrating(last_a_, last_b_)) return true;
  return sweep([&](int a, int b) {
    if (!may_collide(a, b) || !penetrating(a, b)) return false;
    last_a_ = a;
    last_b_ = b;
    return true;
  });
}

std::vector<PanelPair> CollisionChecker::collisions(const Configuration& config) {
  std::vector<PanelPair> pairs;
  over_folded(config, &pairs);
  place(config);
  sweep([&](int a, int b) {
    if (may_collide(a, b) && penetrating(a, b)) {
      const auto [low, high] = std::minmax(plates_.panel[a], plates_.panel[b]);
      pairs.push_back({low, high});
    }
    return false;
  });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace plico
