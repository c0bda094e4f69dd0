#include "plico/verify/closing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plico/geom/polygon.h"

namespace plico {
namespace {

// Where a panel is in space: the point `flat` of the sheet lies at `at`, and the panel is turned by `turn`.
struct Placement {
  Vec2 flat = Vec2::Zero();
  Vec3 at = Vec3::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();

  Vec3 operator()(const Vec2& p) const {
    const Vec2 d = p - flat;
    return at + turn * Vec3(d.x(), d.y(), 0);
  }
};

class Folder {
 public:
  Folder(const Unfolding& net, const Mesh& mesh, const std::vector<NetFold>& folds, double scale)
      : net_(net),
        mesh_(mesh),
        folds_(folds),
        scale_(scale),
        first_(net.sheet.faces.size() + 1, 0),
        folds_of_(2 * folds.size()),
        placed_(net.sheet.faces.size(), 0),
        placement_(net.sheet.faces.size()) {
    for (const NetFold& fold : folds) ++first_[fold.left], ++first_[fold.right];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    for (std::size_t i = folds.size(); i-- > 0;) {  // from the back, as the places are counted down
      folds_of_[--first_[folds[i].left]] = static_cast<int>(i);
      folds_of_[--first_[folds[i].right]] = static_cast<int>(i);
    }
  }

  Closing run() {
    // Largest panels first: the root of a part is the largest of it, so that a sliver never sets the direction.
    const int n = net_.sheet.num_faces();
    std::vector<double> area(static_cast<std::size_t>(n));
    for (int f = 0; f < n; ++f) area[f] = signed_area(polygon(net_.sheet, f));
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return area[f] > area[g]; });
    for (int root : order)
      if (!placed_[root]) fold_part(root);
    return closing_;
  }

 private:
  void fold_part(int root) {
    hang(root);
    std::vector<int> queue{root};
    placed_[root] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      compare(queue[i]);
      for (int at = first_[queue[i]]; at < first_[queue[i] + 1]; ++at) {
        const NetFold& fold = folds_[folds_of_[at]];
        const int child = fold.left == queue[i] ? fold.right : fold.left;
        if (placed_[child]) continue;
        turn_against(queue[i], child, fold);
        placed_[child] = 1;
        queue.push_back(child);
      }
    }
  }

  Vec2 flat(int panel, std::size_t i) const { return net_.sheet.vertices[net_.sheet.faces[panel][i]]; }
  Vec3 solid(int panel, std::size_t i) const {
    return scale_ * mesh_.point(VertexId(net_.mesh_vertex[net_.sheet.faces[panel][i]]));
  }

  // Lays the root on its mesh face: first corners together, the direction to the farthest corner and the normal too.
  void hang(int panel) {
    const std::size_t n = net_.sheet.faces[panel].size();
    std::size_t far = 1;
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i < n; ++i) {
      if ((flat(panel, i) - flat(panel, 0)).norm() > (flat(panel, far) - flat(panel, 0)).norm()) far = i;
      const Vec3 next = solid(panel, (i + 1) % n) - solid(panel, 0);
      normal += (solid(panel, i) - solid(panel, 0)).cross(next);
    }
    const Vec2 x2 = (flat(panel, far) - flat(panel, 0)).normalized();
    Eigen::Matrix3d on_sheet, in_space;
    on_sheet << x2.x(), -x2.y(), 0, x2.y(), x2.x(), 0, 0, 0, 1;
    const Vec3 x = (solid(panel, far) - solid(panel, 0)).normalized(), z = normal.normalized();
    in_space << x, z.cross(x), z;
    placement_[panel] = {flat(panel, 0), solid(panel, 0),
                         Eigen::Quaterniond(in_space * on_sheet.transpose()).normalized()};
  }

  void turn_against(int parent, int child, const NetFold& fold) {
    const Crease& crease = net_.sheet.edges[fold.edge];
    const Vec2 a = net_.sheet.vertices[crease.a], along = (net_.sheet.vertices[crease.b] - a).normalized();
    // A valley lifts the other panel toward the front: for the panel right of a -> b that is a left-handed turn.
    const double angle = child == fold.right ? -crease.fold_angle : crease.fold_angle;
    const Eigen::Quaterniond turn = quaternion(Vec3(along.x(), along.y(), 0), angle);
    placement_[child] = {a, placement_[parent](a), (placement_[parent].turn * turn).normalized()};
  }

  void compare(int panel) {
    for (std::size_t i = 0; i < net_.sheet.faces[panel].size(); ++i) {
      const double off = (placement_[panel](flat(panel, i)) - solid(panel, i)).norm();
      if (off <= closing_.worst || std::isnan(closing_.worst)) continue;  // a NaN is worse than anything
      closing_ = {off, panel};
    }
  }

  const Unfolding& net_;
  const Mesh& mesh_;
  const std::vector<NetFold>& folds_;
  double scale_;
  std::vector<int> first_, folds_of_;  // panel p has folds_of_[first_[p]] .. folds_of_[first_[p + 1]]
  std::vector<char> placed_;
  std::vector<Placement> placement_;
  Closing closing_;
};

}  // namespace

Closing fold_and_compare(const Unfolding& net, const Mesh& mesh, const std::vector<NetFold>& folds, double scale) {
  return Folder(net, mesh, folds, scale).run();
}

}  // namespace plico
