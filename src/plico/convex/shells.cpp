#include "plico/convex/shells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plico/base/error.h"
#include "plico/convex/contact.h"

namespace plico {
namespace {

constexpr double kProtectedWeight = 4;
constexpr double kInward = 1e-12;   // of the diagonal: how far a shell is moved in from its planes
constexpr double kTouching = 1e-9;  // of the diagonal: points closer than this are one
constexpr double kContact = 1e-7;   // of the diagonal: faces closer than this touch, as faces that are almost flat do

// Two hulls whose boxes meet, and what keeps them apart.
struct HullPair {
  int first = 0, second = 0;
  Plane plane;
  bool cut = false;
  double overlap = 0;
  int seen = -1;  // the change after which the plane was last looked at
};

// Hulls, the planes between them, and what the planes leave.
class ShellSearch {
 public:
  ShellSearch(std::vector<ConvexPolyhedron> hulls, std::vector<double> weights, const ShellOptions& options,
              const Run& run)
      : hulls_(std::move(hulls)), weights_(std::move(weights)), options_(options), run_(run) {
    Eigen::AlignedBox3d box;
    for (const ConvexPolyhedron& hull : hulls_) {
      box.extend(bounding_box(hull.points));
      volumes_.push_back(volume(hull));
    }
    diagonal_ = hulls_.empty() ? 0 : box.diagonal().norm();
    pairs_of_.resize(hulls_.size());
    changed_.assign(hulls_.size(), 0);
  }

  void run() {
    find_pairs();
    parallel_for(run_, static_cast<int>(pairs_.size()), [&](int p) { separate(p); });
    std::stable_sort(pairs_.begin(), pairs_.end(),
                     [](const HullPair& a, const HullPair& b) { return a.overlap > b.overlap; });
    for (int p = 0; p < static_cast<int>(pairs_.size()); ++p) {
      pairs_of_[pairs_[p].first].push_back(p);
      pairs_of_[pairs_[p].second].push_back(p);
    }
    for (int i = 0; i < static_cast<int>(hulls_.size()); ++i) bodies_.push_back(trimmed(i, -1));
    if (options_.method == CutMethod::Full) descend();
  }

  // Moved in from its planes until every point is strictly on its side, exactly.
  ConvexPolyhedron finished(int i) const {
    for (double inward = kInward * diagonal_;; inward *= 4) {
      ConvexPolyhedron body = hulls_[i];
      for (int p : pairs_of_[i]) {
        Plane plane = facing(p, i);
        plane.offset -= inward;
        body = clip(body, plane, p);
        if (body.empty()) return {};
      }
      body = without_flat_points(convex_hull(without_twins(body.points)));
      if (body.empty() || is_strictly_inside(body, i)) return body;
    }
  }

  const std::vector<HullPair>& pairs() const { return pairs_; }
  double diagonal() const { return diagonal_; }
  int sweeps() const { return sweeps_; }
  Ending ending() const { return ending_; }

 private:
  void find_pairs() {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const ConvexPolyhedron& hull : hulls_) boxes.push_back(bounding_box(hull.points));
    const Vec3 margin = Vec3::Constant(kTouching * diagonal_);
    for (int i = 0; i < static_cast<int>(hulls_.size()); ++i)
      for (int j = i + 1; j < static_cast<int>(hulls_.size()); ++j)
        if (Eigen::AlignedBox3d(boxes[i].min() - margin, boxes[i].max() + margin).intersects(boxes[j]))
          pairs_.push_back({i, j, {}});
  }

  // The first plane of a pair, as if it were alone. When time is up the cheapest method will do.
  void separate(int p) {
    HullPair& pair = pairs_[p];
    const ConvexPolyhedron &a = hulls_[pair.first], &b = hulls_[pair.second];
    const ConvexPolyhedron shared = intersection(a, b, 0);
    pair.overlap = shared.empty() ? 0 : volume(shared);
    if (!(pair.overlap > 1e-12 * std::min(volumes_[pair.first], volumes_[pair.second]))) {
      if (const std::optional<Plane> plane = separating_plane(a, b, kTouching * diagonal_)) {
        pair.plane = *plane;
        return;
      }
    }
    pair.cut = true;
    Rng rng = Rng(options_.seed).stream(p);
    if (options_.method == CutMethod::Full && !run_.over())
      pair.plane = full_cut(cut_pair(pair, a, b), {floor(pair.first), floor(pair.second)});
    else
      pair.plane = cut_plane(cut_pair(pair, a, b),
                             options_.method == CutMethod::Full ? CutMethod::Lsf : options_.method, rng, options_.svm);
  }

  CutPair cut_pair(const HullPair& pair, const ConvexPolyhedron& a, const ConvexPolyhedron& b) const {
    return {a, b, weights_[pair.first], weights_[pair.second]};
  }
  double floor(int i) const { return options_.least_kept * volumes_[i]; }

  // The plane of pair p with the hull i below it.
  Plane facing(int p, int i) const { return pairs_[p].first == i ? pairs_[p].plane : pairs_[p].plane.flipped(); }

  // The hull cut by the planes of all its pairs but one.
  ConvexPolyhedron trimmed(int i, int but) const {
    ConvexPolyhedron body = hulls_[i];
    for (int p : pairs_of_[i])
      if (p != but && pairs_[p].cut) body = clip(body, facing(p, i), p);
    return body;
  }

  // Block-coordinate descent: every pair again, each seen trimmed by all other planes, until no plane moves.
  void descend() {
    for (sweeps_ = 0; sweeps_ < options_.max_sweeps; ++sweeps_) {
      bool moved = false;
      for (int p = 0; p < static_cast<int>(pairs_.size()); ++p) {
        if (run_.over()) {
          ending_ = run_.ending();
          return;
        }
        const HullPair& pair = pairs_[p];
        if (pair.cut && std::max(changed_[pair.first], changed_[pair.second]) > pair.seen) moved |= improve(p);
      }
      run_.report("cut planes", sweeps_ + 1, options_.max_sweeps);
      if (!moved) return;
    }
  }

  // Weighted volume gained, less what the floors miss counted heavily: floors come first.
  double worth(const HullPair& pair, const ConvexPolyhedron& a, const ConvexPolyhedron& b) const {
    const double first = volume(a), second = volume(b);
    const double missing = std::max(0.0, floor(pair.first) - first) + std::max(0.0, floor(pair.second) - second);
    return weights_[pair.first] * first + weights_[pair.second] * second - 1e6 * missing;
  }

  bool improve(int p) {
    HullPair& pair = pairs_[p];
    const ConvexPolyhedron a = trimmed(pair.first, p), b = trimmed(pair.second, p);
    pair.seen = changes_;
    if (a.empty() || b.empty()) return false;
    const Plane plane = better_plane(pair, a, b);
    ConvexPolyhedron first = clip(a, plane, p), second = clip(b, plane.flipped(), p);
    const double gained = worth(pair, first, second) - worth(pair, bodies_[pair.first], bodies_[pair.second]);
    if (!(gained > 1e-7 * (volumes_[pair.first] + volumes_[pair.second]))) return false;
    pair.plane = plane;
    bodies_[pair.first] = std::move(first);
    bodies_[pair.second] = std::move(second);
    ++changes_;
    changed_[pair.first] = changed_[pair.second] = pair.seen = changes_;
    return true;
  }

  Plane better_plane(const HullPair& pair, const ConvexPolyhedron& a, const ConvexPolyhedron& b) const {
    const ConvexPolyhedron shared = intersection(a, b, 0);
    if (shared.empty() || volume(shared) <= 1e-12 * std::min(volumes_[pair.first], volumes_[pair.second])) {
      const std::optional<Plane> plane = separating_plane(a, b, kTouching * diagonal_);
      return plane ? *plane : pair.plane;
    }
    const CutPair both = cut_pair(pair, a, b);
    const Plane fresh = full_cut(both, {floor(pair.first), floor(pair.second)});
    const Plane kept = polished_cut(both, pair.plane);
    const auto worth_of = [&](const Plane& plane) {
      return worth(pair, clip(a, plane, 0), clip(b, plane.flipped(), 0));
    };
    return worth_of(kept) >= worth_of(fresh) ? kept : fresh;
  }

  // The points without those that lie within kTouching of one before them.
  std::vector<Vec3> without_twins(std::vector<Vec3> points) const {
    const double tolerance = kTouching * diagonal_;
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    std::vector<Vec3> kept;
    for (const Vec3& p : points) {
      bool twin = false;
      for (auto it = kept.rbegin(); it != kept.rend() && p.x() - it->x() <= tolerance && !twin; ++it)
        twin = (p - *it).norm() <= tolerance;
      if (!twin) kept.push_back(p);
    }
    return kept;
  }

  // The hull without points that lie between two neighbours: where a plane cuts the diagonal of a flat face. Never two
  // neighbours at once, which would take a corner that two close points share; so a few rounds.
  ConvexPolyhedron without_flat_points(ConvexPolyhedron hull) const {
    for (int round = 0; round < 8 && !hull.empty(); ++round) {
      std::vector<std::vector<int>> neighbours(hull.points.size());
      for (const ConvexPolyhedron::Facet& facet : hull.facets)
        for (std::size_t i = 0; i < facet.corners.size(); ++i)
          neighbours[facet.corners[i]].push_back(facet.corners[(i + 1) % facet.corners.size()]);
      std::vector<char> gone(hull.points.size(), 0);
      std::vector<Vec3> kept;
      for (std::size_t v = 0; v < hull.points.size(); ++v) {
        const auto is_gone = [&](int neighbour) { return gone[neighbour] != 0; };
        gone[v] = std::none_of(neighbours[v].begin(), neighbours[v].end(), is_gone) &&
                  lies_between(hull.points[v], neighbours[v], hull.points);
        if (!gone[v]) kept.push_back(hull.points[v]);
      }
      if (kept.size() == hull.points.size()) break;
      hull = convex_hull(kept);
    }
    return hull;
  }

  bool lies_between(const Vec3& p, const std::vector<int>& neighbours, const std::vector<Vec3>& points) const {
    for (int a : neighbours)
      for (int b : neighbours) {
        const Vec3 to_a = points[a] - p, along = points[b] - points[a];
        if (a < b && to_a.dot(points[b] - p) < 0 && to_a.cross(along).norm() <= kTouching * diagonal_ * along.norm())
          return true;
      }
    return false;
  }

  bool is_strictly_inside(const ConvexPolyhedron& body, int i) const {
    for (int p : pairs_of_[i])
      for (const Vec3& point : body.points)
        if (side_of_plane(facing(p, i), point) >= 0) return false;
    return true;
  }

  std::vector<ConvexPolyhedron> hulls_;
  std::vector<double> weights_;
  const ShellOptions& options_;
  const Run& run_;
  double diagonal_ = 0;
  std::vector<double> volumes_;
  std::vector<HullPair> pairs_;
  std::vector<std::vector<int>> pairs_of_;  // of each hull
  std::vector<ConvexPolyhedron> bodies_;    // hulls trimmed by all planes
  std::vector<int> changed_;                // of each hull: the last change of one of its planes
  int changes_ = 0;
  int sweeps_ = 0;
  Ending ending_ = Ending::Found;
};

std::vector<ConvexPolyhedron> checked_hulls(const std::vector<ShapePart>& parts) {
  if (parts.empty()) throw InvalidInput("shell/no-parts", "the shape has no part");
  if (static_cast<int>(parts.size()) > kMaxParts)
    throw InvalidInput("shell/too-many-parts", fmt::format("{} parts, must be at most {}", parts.size(), kMaxParts), {},
                       "join parts into groups");
  std::vector<ConvexPolyhedron> hulls;
  for (const ShapePart& part : parts) {
    for (const Vec3& p : part.points)
      if (!(p.array().abs() <= kMaxCoordinate).all())
        throw InvalidInput(
            "shell/not-a-number",
            fmt::format("a coordinate is {} {} {}, must be finite and at most 1e30", p.x(), p.y(), p.z()),
            fmt::format("part {}", part.name));
    hulls.push_back(convex_hull(part.points));
    const Vec3 size = bounding_box(part.points).diagonal();
    if (hulls.back().empty() || !(volume(hulls.back()) > 1e-12 * size.norm() * size.norm() * size.norm()))
      throw InvalidInput(
          "shell/flat-part",
          fmt::format("part {} has no volume: its {} points lie in one plane", part.name, part.points.size()),
          fmt::format("part {}", part.name), "take it out of the file");
  }
  return hulls;
}

std::vector<double> part_weights(const std::vector<ShapePart>& parts, const ShellOptions& options) {
  std::vector<double> weights(parts.size(), 1);
  for (const std::string& wanted : options.protect) {
    bool found = false;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].name == wanted) weights[i] = kProtectedWeight, found = true;
    if (!found) throw InvalidOption(fmt::format("protect = {}: there is no part of that name", wanted));
  }
  return weights;
}

// The larger part that holds most of a small one, or -1 when none holds `share` of it.
int host_of(int small, const std::vector<ConvexPolyhedron>& hulls, const std::vector<double>& volumes, double share) {
  int host = -1;
  const Eigen::AlignedBox3d box = bounding_box(hulls[small].points);
  double most = share * volumes[small];
  for (int i = 0; i < static_cast<int>(hulls.size()); ++i) {
    const bool larger = volumes[i] > volumes[small] || (volumes[i] == volumes[small] && i < small);
    if (!larger || !bounding_box(hulls[i].points).intersects(box)) continue;
    const ConvexPolyhedron shared = intersection(hulls[small], hulls[i], 0);
    if (shared.empty() || volume(shared) < most) continue;
    host = i;
    most = volume(shared);
  }
  return host;
}

// Takes nested parts out, smallest first, so that a chain of them ends in its outermost part.
void settle_nested(std::vector<ConvexPolyhedron>& hulls, const ShellOptions& options, Shells& result) {
  if (options.nested == NestedPolicy::Keep) return;
  std::vector<double> volumes;
  for (const ConvexPolyhedron& hull : hulls) volumes.push_back(volume(hull));
  std::vector<int> order(hulls.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return volumes[a] != volumes[b] ? volumes[a] < volumes[b] : a > b; });
  for (int part : order) {
    const int host = host_of(part, hulls, volumes, options.nested_share);
    if (host < 0) continue;
    result.nested.push_back(part);
    result.hosts.push_back(host);
    if (options.nested != NestedPolicy::Merge) continue;
    std::vector<Vec3> points = hulls[host].points;
    points.insert(points.end(), hulls[part].points.begin(), hulls[part].points.end());
    hulls[host] = convex_hull(points);
  }
}

void collect_shells(const ShellSearch& search, const std::vector<int>& part_of,
                    const std::vector<ConvexPolyhedron>& hulls, Shells& result) {
  std::vector<int> number(part_of.size(), -1);
  for (int i = 0; i < static_cast<int>(part_of.size()); ++i) {
    ConvexPolyhedron body = search.finished(i);
    if (body.empty()) {
      result.lost.push_back(part_of[i]);
      continue;
    }
    number[i] = static_cast<int>(result.shells.size());
    const double kept = volume(body);
    result.shells.push_back({part_of[i], std::move(body), volume(hulls[part_of[i]]), kept});
    result.shell_volume += kept;
  }
  for (const HullPair& pair : search.pairs()) {
    const int first = number[pair.first], second = number[pair.second];
    if (first < 0 || second < 0) continue;
    result.contacts.push_back({first, second, pair.plane, pair.cut,
                               contact_polygon(result.shells[first].body, result.shells[second].body, pair.plane,
                                               kContact * search.diagonal())});
  }
}

}  // namespace

std::string_view name(NestedPolicy policy) {
  switch (policy) {
    case NestedPolicy::Drop:
      return "drop";
    case NestedPolicy::Merge:
      return "merge";
    case NestedPolicy::Keep:
      break;
  }
  return "keep";
}

void check(const ShellOptions& options) {
  require(options.nested_share > 0 && options.nested_share <= 1, "nested-share", options.nested_share, "in (0, 1]");
  require(options.least_kept >= 0 && options.least_kept < 1, "least-kept", options.least_kept, "in [0, 1)");
  require(options.max_sweeps >= 0, "max-sweeps", options.max_sweeps, "at least 0");
  require(options.svm.samples >= 10, "svm-samples", options.svm.samples, "at least 10");
  require(options.svm.penalty > 0, "svm-penalty", options.svm.penalty, "positive");
}

double Shells::least_kept() const {
  double least = lost.empty() ? 1 : 0;
  for (const Shell& shell : shells) least = std::min(least, shell.kept_volume / shell.hull_volume);
  return least;
}

Shells disjoint_shells(const std::vector<ShapePart>& parts, const ShellOptions& options, const Run& run) {
  check(options);
  const std::vector<double> all_weights = part_weights(parts, options);
  std::vector<ConvexPolyhedron> hulls = checked_hulls(parts);
  Shells result;
  settle_nested(hulls, options, result);
  result.union_volume = union_volume(hulls);
  std::vector<int> part_of;
  std::vector<ConvexPolyhedron> cut_hulls;
  std::vector<double> weights;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    if (std::count(result.nested.begin(), result.nested.end(), i)) continue;
    part_of.push_back(i);
    cut_hulls.push_back(hulls[i]);
    weights.push_back(all_weights[i]);
  }
  ShellSearch search(std::move(cut_hulls), std::move(weights), options, run);
  search.run();
  result.ending = search.ending();
  result.sweeps = search.sweeps();
  collect_shells(search, part_of, hulls, result);
  return result;
}

}  // namespace plico
