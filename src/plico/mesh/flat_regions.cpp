#include "plico/mesh/flat_regions.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "plico/mesh/check.h"
#include "plico/mesh/measures.h"
#include "plico/mesh/repair.h"

namespace plico {
namespace {

class RegionFinder {
 public:
  RegionFinder(const Mesh& mesh, double planarity)
      : mesh_(mesh), planarity_(planarity), region_(mesh.num_faces(), -1) {}

  FlatRegions find() {
    grow_all();
    for (std::size_t r = 0; r < members_.size(); ++r)
      if (members_[r].size() > 1 && outline(static_cast<int>(r)).empty()) break_up(static_cast<int>(r));
    number_by_first_face();
    return result();
  }

 private:
  // From the largest face on, so that the plane is known as well as can be.
  void grow_all() {
    std::vector<int> order(mesh_.num_faces());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> size(order.size());
    for (FaceId f : mesh_.faces()) size[f] = area(mesh_, f);
    std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return size[f] > size[g]; });
    for (int f : order)
      if (region_[f] < 0) grow(FaceId(f));
  }

  void grow(FaceId seed) {
    const int r = static_cast<int>(members_.size());
    const Vec3 up = normal(mesh_, seed), on = mesh_.point(mesh_.from(*mesh_.halfedges(seed).begin()));
    Eigen::AlignedBox3d box;
    for (int v : mesh_.corners(seed)) box.extend(mesh_.point(VertexId(v)));
    std::vector<FaceId> members{seed};
    region_[seed] = r;
    for (std::size_t i = 0; i < members.size(); ++i)
      for (HalfedgeId h : mesh_.halfedges(members[i])) {
        if (!mesh_.twin(h).valid()) continue;
        const FaceId next = mesh_.face(mesh_.twin(h));
        if (region_[next] >= 0 || normal(mesh_, next).dot(up) <= 0) continue;
        Eigen::AlignedBox3d larger = box;
        for (int v : mesh_.corners(next)) larger.extend(mesh_.point(VertexId(v)));
        if (!lies_in_plane(next, up, on, larger.diagonal().norm())) continue;
        box = larger;
        region_[next] = r;
        members.push_back(next);
      }
    members_.push_back(std::move(members));
  }

  bool lies_in_plane(FaceId f, const Vec3& up, const Vec3& on, double size) const {
    const auto corners = mesh_.corners(f);
    return std::all_of(corners.begin(), corners.end(),
                       [&](int v) { return std::abs(up.dot(mesh_.point(VertexId(v)) - on)) <= planarity_ * size; });
  }

  bool is_border(HalfedgeId h) const {
    return !mesh_.twin(h).valid() || region_[mesh_.face(mesh_.twin(h))] != region_[mesh_.face(h)];
  }

  // The corners around a region, counter-clockwise; none when they are not one loop that meets each vertex once.
  std::vector<int> outline(int r) const {
    std::map<int, int> next;  // vertices
    std::size_t sides = 0;
    for (FaceId f : members_[r])
      for (HalfedgeId h : mesh_.halfedges(f))
        if (is_border(h)) next[mesh_.from(h)] = mesh_.to(h), ++sides;
    if (next.size() != sides) return {};
    std::vector<int> loop;
    for (int v = next.begin()->first; loop.empty() || v != loop.front(); v = next.at(v)) {
      if (loop.size() == sides) return {};
      loop.push_back(v);
    }
    return loop.size() == sides ? loop : std::vector<int>{};
  }

  void break_up(int r) {
    for (std::size_t i = 1; i < members_[r].size(); ++i) {
      region_[members_[r][i]] = static_cast<int>(members_.size());
      members_.push_back({members_[r][i]});
    }
    members_[r].resize(1);
  }

  void number_by_first_face() {
    std::vector<int> number(members_.size(), -1);
    int count = 0;
    for (int& r : region_) {
      if (number[r] < 0) number[r] = count++;
      r = number[r];
    }
    std::vector<std::vector<FaceId>> members(members_.size());
    for (FaceId f : mesh_.faces()) members[region_[f]].push_back(f);
    members_ = std::move(members);
  }

  // Vertices that some outline turns at, or where more than two regions meet, stay.
  std::vector<char> corners_that_stay(const std::vector<std::vector<int>>& outlines) const {
    std::vector<int> regions_at(mesh_.num_vertices(), 0);
    std::vector<char> stays(mesh_.num_vertices(), 0);
    for (const std::vector<int>& loop : outlines) {
      Eigen::AlignedBox3d box;
      for (int v : loop) box.extend(mesh_.point(VertexId(v)));
      const double off = planarity_ * box.diagonal().norm();
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i) {
        const int v = loop[i];
        ++regions_at[v];
        const Vec3 before = mesh_.point(VertexId(loop[(i + n - 1) % n])),
                   after = mesh_.point(VertexId(loop[(i + 1) % n]));
        const Vec3 in = mesh_.point(VertexId(v)) - before, along = after - before;
        const bool straight = along.cross(in).norm() <= off * along.norm() && along.dot(in) > 0;
        if (!straight) stays[v] = 1;
      }
    }
    for (std::size_t v = 0; v < stays.size(); ++v) stays[v] = stays[v] || regions_at[v] > 2;
    return stays;
  }

  FlatRegions result() const {
    std::vector<std::vector<int>> outlines;
    for (std::size_t r = 0; r < members_.size() && !members_[r].empty(); ++r)
      outlines.push_back(outline(static_cast<int>(r)));
    const std::vector<char> stays = corners_that_stay(outlines);
    FlatRegions regions{{}, region_, 0};
    std::vector<int> number(mesh_.num_vertices(), -1);
    for (std::size_t r = 0; r < outlines.size(); ++r) {
      std::vector<int> face;
      for (int v : outlines[r]) {
        if (!stays[v]) continue;
        if (number[v] < 0) {
          number[v] = regions.soup.num_points();
          regions.soup.points.push_back(mesh_.point(VertexId(v)));
        }
        face.push_back(number[v]);
      }
      regions.soup.add_face(face);
      regions.num_merged += members_[r].size() > 1;
    }
    return regions;
  }

  const Mesh& mesh_;
  double planarity_;
  std::vector<int> region_;                   // of each face
  std::vector<std::vector<FaceId>> members_;  // of each region
};

}  // namespace

FlatRegions flat_regions(const Mesh& mesh, double planarity) { return RegionFinder(mesh, planarity).find(); }

Mesh with_flat_regions_whole(Mesh mesh) {
  FlatRegions regions = flat_regions(mesh);
  const CheckOptions strict{.planarity = kFlatPolygon, .self_intersections = false};
  if (regions.num_merged == 0 || !check_mesh(regions.soup, strict).usable()) return mesh;
  return Mesh(std::move(regions.soup));
}

}  // namespace plico
