#include "plico/motion/contacts.h"

#include <algorithm>
#include <limits>
#include <span>

namespace plico {
namespace {

constexpr double kParallelSides = 1e-12;  // squared sine: the product of such sides is no direction

struct Extent {
  double low, high;
};

Extent extent_along(std::span<const Vec3> corners, const Vec3& axis) {
  Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3& c : corners) {
    const double at = axis.dot(c);
    extent.low = std::min(extent.low, at);
    extent.high = std::max(extent.high, at);
  }
  return extent;
}

// A direction along which plate b lies ahead of plate a, and where they are nearest.
struct Parting {
  double apart = -std::numeric_limits<double>::infinity();
  Vec3 direction = Vec3::UnitZ();
  enum { PlaneOfA, PlaneOfB, Sides } kind = PlaneOfA;
  Vec3 place = Vec3::Zero();  // Sides: between the two
};

Vec3 side_of(std::span<const Vec3> corners, std::size_t i) { return corners[(i + 1) % corners.size()] - corners[i]; }

// Half way between the nearest points of two lines that are not parallel.
Vec3 between_lines(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 w = q - p;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), det = uu * vv - uv * uv;
  const double s = std::clamp((w.dot(u) * vv - w.dot(v) * uv) / det, 0.0, 1.0);
  const double t = std::clamp((w.dot(u) * uv - w.dot(v) * uu) / det, 0.0, 1.0);
  return 0.5 * (p + s * u + q + t * v);
}

class PartingSearch {
 public:
  PartingSearch(std::span<const Vec3> a, std::span<const Vec3> b) : a_(a), b_(b) {}

  Parting best(const Vec3& normal_a, const Vec3& normal_b) {
    for (const double sign : {1.0, -1.0}) {
      offer(sign * normal_a, Parting::PlaneOfA);
      offer(sign * normal_b, Parting::PlaneOfB);
    }
    for (std::size_t i = 0; i < a_.size(); ++i)
      for (std::size_t j = 0; j < b_.size(); ++j) {
        const Vec3 u = side_of(a_, i), v = side_of(b_, j), axis = u.cross(v);
        if (axis.squaredNorm() <= kParallelSides * u.squaredNorm() * v.squaredNorm()) continue;
        for (const double sign : {1.0, -1.0})
          if (offer(sign * axis.normalized(), Parting::Sides)) best_.place = between_lines(a_[i], u, b_[j], v);
      }
    return best_;
  }

 private:
  bool offer(const Vec3& direction, decltype(Parting::kind) kind) {
    const double apart = extent_along(b_, direction).low - extent_along(a_, direction).high;
    if (apart <= best_.apart) return false;
    best_.apart = apart;
    best_.direction = direction;
    best_.kind = kind;
    return true;
  }

  std::span<const Vec3> a_, b_;
  Parting best_;
};

class ContactSearch {
 public:
  ContactSearch(const Linkage& linkage, const Plates& plates, const Configuration& config)
      : linkage_(linkage), plates_(plates), poses_(folding_map(linkage, config)), depth_(linkage.panels.size(), 0) {
    for (int p : linkage.order)
      if (linkage.parent_panel[p] >= 0) depth_[p] = depth_[linkage.parent_panel[p]] + 1;
  }

  void add(const PanelPair& pair, double reach, std::vector<Contact>& all) const {
    for (int i = plates_.first_of_panel[pair.a]; i < plates_.first_of_panel[pair.a + 1]; ++i)
      for (int j = plates_.first_of_panel[pair.b]; j < plates_.first_of_panel[pair.b + 1]; ++j)
        add_plates(pair, i, j, reach, all);
  }

 private:
  std::vector<Vec3> placed(int plate) const {
    std::vector<Vec3> corners(plates_.corners.begin() + plates_.first[plate],
                              plates_.corners.begin() + plates_.first[plate + 1]);
    for (Vec3& c : corners) c = poses_[plates_.panel[plate]] * c;
    return corners;
  }

  void add_plates(const PanelPair& pair, int i, int j, double reach, std::vector<Contact>& all) const {
    const std::vector<Vec3> a = placed(i), b = placed(j);
    const Parting parting = PartingSearch(a, b).best(poses_[pair.a].linear().col(2), poses_[pair.b].linear().col(2));
    if (parting.apart > reach) return;
    const Vec3& n = parting.direction;
    if (parting.kind == Parting::Sides) {
      all.push_back({pair, parting.apart, slope(pair, n, parting.place)});
      return;
    }
    const bool a_is_plane = parting.kind == Parting::PlaneOfA;
    for (const Vec3& corner : a_is_plane ? b : a) {
      const double apart = a_is_plane ? n.dot(corner - a.front()) : n.dot(b.front() - corner);
      if (apart <= reach) all.push_back({pair, apart, slope(pair, n, corner)});
    }
  }

  // How fast panel b leaves panel a along `n` at `place`, by each hinge on the chain between them.
  Configuration slope(const PanelPair& pair, const Vec3& n, const Vec3& place) const {
    Configuration result = Configuration::Zero(linkage_.num_hinges());
    int a = pair.a, b = pair.b;
    while (a != b) {
      const bool up_from_b = depth_[b] >= depth_[a];
      int& panel = up_from_b ? b : a;
      if (linkage_.parent_panel[panel] < 0) break;
      const int h = linkage_.parent_hinge[panel], parent = linkage_.parent_panel[panel];
      const Hinge& hinge = linkage_.hinges[h];
      const Vec3 axis = poses_[parent].linear() * (hinge.to - hinge.from).normalized();
      const double speed = n.dot(axis.cross(place - poses_[parent] * hinge.from));
      result[h] = (up_from_b ? 1 : -1) * (panel == hinge.right ? -1 : 1) * speed;
      panel = parent;
    }
    return result;
  }

  const Linkage& linkage_;
  const Plates& plates_;
  std::vector<Pose> poses_;
  std::vector<int> depth_;  // of each panel below its root
};

}  // namespace

std::vector<Contact> contacts(const Linkage& linkage, const Plates& plates, const Configuration& config,
                              const std::vector<PanelPair>& pairs, double reach) {
  const ContactSearch search(linkage, plates, config);
  std::vector<Contact> all;
  for (const PanelPair& pair : pairs) search.add(pair, reach, all);
  return all;
}

}  // namespace plico
