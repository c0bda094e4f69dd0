#include "plico/segment/patch_cut.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/mesh/measures.h"
#include "plico/segment/min_cut.h"
#include "plico/segment/ridges.h"

namespace plico {
namespace {

constexpr double kDeepValley = 0.03;  // the least factor of an angle
constexpr double kRidge = 0.3;        // what a radian of a ridge adds to it
constexpr double kDentBand = 0.2;     // how far from the deepest vertex faces are free, as a share of the reach

double angle_factor(double fold_angle, const SeamWeight& weight) {
  if (weight.valley_fall <= 0) return 1;
  if (fold_angle < 0) return 1 - kRidge * fold_angle;
  return std::max(kDeepValley, plico::pow(std::numbers::e, -fold_angle / weight.valley_fall));
}

double seam_cost(const Mesh& mesh, EdgeId e, const PatchVertices& patch, double deepest, const SeamWeight& weight) {
  const double cost = length(mesh, e) * (weight.valley_fall > 0 ? angle_factor(fold_angle(mesh, e), weight) : 1);
  if (weight.deep <= 0 || deepest <= 0) return cost;
  const HalfedgeId h = mesh.halfedge(e);
  const double depth = (patch.depth[patch.at(mesh.from(h))] + patch.depth[patch.at(mesh.to(h))]) / 2;
  return cost * (1 - weight.deep * depth / deepest);
}

// The position of the face beyond a side, or -1 when that is none of `faces`.
int neighbour(const Mesh& mesh, const std::vector<int>& faces, HalfedgeId h) {
  const HalfedgeId twin = mesh.twin(h);
  if (!twin.valid()) return -1;
  const int face = mesh.face(twin);
  const auto at = std::lower_bound(faces.begin(), faces.end(), face);
  return at != faces.end() && *at == face ? static_cast<int>(at - faces.begin()) : -1;
}

// Gives the faces that have all their corners on a ridge, or any where there is no such face.
void give_ridge(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch, const RidgePair& ridges,
                Side side, std::vector<Side>& given) {
  const char ridge = side == Side::First ? 1 : 2;
  const auto on_ridge = [&](int v) { return ridges.side_of_vertex[patch.at(v)] == ridge; };
  const auto give = [&](auto&& belongs) {
    bool any = false;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (given[i] != Side::Free || !belongs(mesh.corners(FaceId(faces[i])))) continue;
      given[i] = side;
      any = true;
    }
    return any;
  };
  if (!give([&](auto corners) { return std::all_of(corners.begin(), corners.end(), on_ridge); }))
    give([&](auto corners) { return std::any_of(corners.begin(), corners.end(), on_ridge); });
}

std::vector<Side> ridge_sides(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                              double least_saddle) {
  std::vector<Side> given(faces.size(), Side::Free);
  if (const std::optional<RidgePair> ridges = deepest_ridges(mesh, faces, patch, least_saddle)) {
    give_ridge(mesh, faces, patch, *ridges, Side::First, given);
    give_ridge(mesh, faces, patch, *ridges, Side::Second, given);
  }
  return given;
}

template <class Points>
int longest_side(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  Vec3::Index longest = 0;
  box.sizes().maxCoeff(&longest);
  return static_cast<int>(longest);
}

std::vector<Side> dent_sides(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch) {
  std::vector<Vec3> points;
  for (int v : patch.vertex) points.push_back(mesh.point(VertexId(v)));
  const int axis = longest_side(points);
  const auto deepest = std::max_element(patch.depth.begin(), patch.depth.end()) - patch.depth.begin();
  const double middle = points[deepest][axis];
  double reach = 0;
  for (const Vec3& p : points) reach = std::max(reach, std::abs(p[axis] - middle));
  std::vector<Side> given(faces.size(), Side::Free);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    double low = reach, high = -reach;
    for (int v : mesh.corners(FaceId(faces[i]))) {
      const double away = mesh.point(VertexId(v))[axis] - middle;
      low = std::min(low, away);
      high = std::max(high, away);
    }
    if (high < -kDentBand * reach) given[i] = Side::First;
    if (low > kDentBand * reach) given[i] = Side::Second;
  }
  return given;
}

std::vector<Side> halves(const Mesh& mesh, const std::vector<int>& faces) {
  std::vector<Vec3> centers;
  for (int f : faces) centers.push_back(center(mesh, FaceId(f)));
  const int axis = longest_side(centers);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < faces.size(); ++i) order.emplace_back(centers[i][axis], i);
  std::sort(order.begin(), order.end());
  std::vector<Side> side(faces.size(), Side::First);
  for (std::size_t i = order.size() / 2; i < order.size(); ++i) side[order[i].second] = Side::Second;
  return side;
}

}  // namespace

bool both_given(const std::vector<Side>& side) {
  const auto has = [&](Side s) { return std::find(side.begin(), side.end(), s) != side.end(); };
  return has(Side::First) && has(Side::Second);
}

std::vector<Side> cut_patch(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                            std::vector<Side> given, const SeamWeight& weight) {
  constexpr int kFirst = 0, kSecond = 1;  // two nodes stand for all faces that are given
  PLICO_ASSERT(given.size() == faces.size());
  const double deepest = patch.deepest();
  std::vector<int> node(faces.size());
  int nodes = 2;
  for (std::size_t i = 0; i < faces.size(); ++i)
    node[i] = given[i] == Side::Free ? nodes++ : given[i] == Side::First ? kFirst : kSecond;
  MinCut cut(nodes);
  cut.make_source(kFirst);
  cut.make_sink(kSecond);
  for (int i = 0; i < static_cast<int>(faces.size()); ++i)
    for (HalfedgeId h : mesh.halfedges(FaceId(faces[i]))) {
      const int j = neighbour(mesh, faces, h);
      if (j <= i || node[i] == node[j]) continue;
      cut.add_edge(node[i], node[j], seam_cost(mesh, mesh.edge(h), patch, deepest, weight));
    }
  cut.solve();
  for (std::size_t i = 0; i < faces.size(); ++i) given[i] = cut.on_source_side(node[i]) ? Side::First : Side::Second;
  return given;
}

std::vector<Side> part_at_fault(const Mesh& mesh, const std::vector<int>& faces, const PatchVertices& patch,
                                double least_saddle, const SeamWeight& weight) {
  std::vector<Side> given = ridge_sides(mesh, faces, patch, least_saddle);
  if (!both_given(given)) given = dent_sides(mesh, faces, patch);
  if (!both_given(given)) return halves(mesh, faces);
  return cut_patch(mesh, faces, patch, std::move(given), weight);
}

std::vector<std::vector<int>> connected_sides(const Mesh& mesh, const std::vector<int>& faces,
                                              const std::vector<Side>& side) {
  std::vector<std::vector<int>> pieces;
  std::vector<char> seen(faces.size(), 0);
  for (std::size_t first = 0; first < faces.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = 1;
    std::vector<int> piece{static_cast<int>(first)};
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (HalfedgeId h : mesh.halfedges(FaceId(faces[piece[i]]))) {
        const int j = neighbour(mesh, faces, h);
        if (j < 0 || seen[j] || side[j] != side[first]) continue;
        seen[j] = 1;
        piece.push_back(j);
      }
    for (int& i : piece) i = faces[i];
    std::sort(piece.begin(), piece.end());
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace plico
