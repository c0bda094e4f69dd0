#include "plico/convex/remesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "plico/base/error.h"
#include "plico/convex/contact.h"
#include "plico/convex/remesh_steps.h"

namespace plico {
namespace {

constexpr double kFlat = 1e-9;    // of the diagonal: points nearer than this lie on a plane, as for disjoint_shells()
constexpr double kMargin = 1e-8;  // of the diagonal: so that new triangles are not exactly in line with neighbours
constexpr double kTouch = 1e-7;   // of the diagonal: facets nearer than this touch
constexpr double kReach = 0.25;   // of a shell's diagonal: how far its box may grow

double diagonal_of(const Shells& shells) {
  Eigen::AlignedBox3d box;
  for (const Shell& shell : shells.shells) box.extend(bounding_box(shell.body.points));
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Eigen::AlignedBox3d grown_box(const ConvexPolyhedron& body) {
  const Eigen::AlignedBox3d box = bounding_box(body.points);
  const Vec3 reach = Vec3::Constant(kReach * box.diagonal().norm());
  return {box.min() - reach, box.max() + reach};
}

bool is_strictly_below(const std::vector<Vec3>& points, const std::vector<Plane>& planes) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) { return side_of_plane(plane, p) < 0; });
  });
}

// Across the widest gap of their boxes.
Plane plane_between_boxes(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  Plane best;
  double widest = -INFINITY;
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {1.0, -1.0}) {
      const double low = sign > 0 ? a.max()[axis] : -a.min()[axis], high = sign > 0 ? b.min()[axis] : -b.max()[axis];
      if (high - low <= widest) continue;
      widest = high - low;
      best = {sign * Vec3::Unit(axis), (low + high) / 2};
    }
  return best;
}

// Of two shells whose boxes are apart: the first strictly below, the second strictly above. In the middle of the gap
// between their facets if there is one.
Plane plane_between(const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
  const auto plane = separating_plane(a, b, 0);
  if (plane && is_strictly_below(a.points, {*plane}) && is_strictly_below(b.points, {plane->flipped()})) return *plane;
  return plane_between_boxes(bounding_box(a.points), bounding_box(b.points));
}

// Shells that were far apart may come close when they grow: a plane for each of these pairs, too.
void add_planes(Shells& shells) {
  std::map<std::pair<int, int>, bool> known;
  for (const ShellContact& contact : shells.contacts) known[std::minmax(contact.first, contact.second)] = true;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Shell& shell : shells.shells) boxes.push_back(grown_box(shell.body));
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j)
      if (boxes[i].intersects(boxes[j]) && !known.contains({i, j}))
        shells.contacts.push_back({i, j, plane_between(shells.shells[i].body, shells.shells[j].body), false, {}});
}

ShellRoom room_of(const Shells& shells, int s, double diagonal) {
  ShellRoom room;
  const ConvexPolyhedron& body = shells.shells[s].body;
  room.box = grown_box(body);
  room.tolerance = kFlat * diagonal;
  room.margin = kMargin * diagonal;
  for (const ShellContact& contact : shells.contacts) {
    if (contact.first != s && contact.second != s) continue;
    room.planes.push_back(contact.first == s ? contact.plane : contact.plane.flipped());
    const Plane& plane = room.planes.back();
    room.contact.push_back(std::count_if(body.points.begin(), body.points.end(), [&](const Vec3& p) {
                             return std::abs(plane.height(p)) <= room.tolerance;
                           }) >= 3);
  }
  return room;
}

void add(const ConvexPolyhedron& body, FatSum& sum) {
  for (const ConvexPolyhedron::Facet& facet : body.facets)
    for (std::size_t i = 2; i < facet.corners.size(); ++i)
      sum.add(body.points[facet.corners[0]], body.points[facet.corners[i - 1]], body.points[facet.corners[i]]);
}

double fatness_of_all(const Shells& shells) {
  FatSum sum;
  for (const Shell& shell : shells.shells) add(shell.body, sum);
  return sum.share();
}

RemeshedShell unchanged(const ConvexPolyhedron& body) {
  const int triangles = static_cast<int>(body.facets.size());
  const double all = volume(body), fat = fatness(body);
  return {triangles, triangles, all, all, fat, fat, 0};
}

// Slivers go first, for half of the volume that is left; then vertices move.
void regularize(ShellSurface& surface, const std::vector<Vec3>& inside, int rounds, RemeshBudget& budget,
                const Run& run) {
  RemeshBudget half{budget.volume / 2, 0};
  budget.volume -= half.volume;
  shrink_edges(surface, 4, true, half, run);
  budget = {budget.volume + half.volume, budget.solves + half.solves};
  for (int round = 0; round < rounds && !run.over(); ++round)
    if (!fatten_once(surface, inside, budget)) break;
}

// One shell. Returns whether it has as few triangles as asked for.
bool remesh_one(Shell& shell, const ShellRoom& room, const RemeshOptions& options, const Run& run,
                RemeshedShell& change) {
  // A shell that grew on the wrong side of a plane would be no shell: left as it is. Does not happen with exact planes.
  if (!is_strictly_below(shell.body.points, room.planes)) return options.faces == 0;
  ShellSurface surface(shell.body, room);
  // A little less than allowed: what is spent is added up with rounding.
  RemeshBudget budget{options.max_growth * change.volume_before * (1 - 1e-9), 0};
  if (options.faces > 0) shrink_edges(surface, options.faces, false, budget, run);
  if (options.regularize > 0) regularize(surface, shell.body.points, options.regularize, budget, run);
  ConvexPolyhedron body = convex_hull(surface.points());
  if (!body.empty() && volume(body) <= change.volume_before * (1 + options.max_growth)) shell.body = std::move(body);
  change.volume = volume(shell.body);
  change.triangles = static_cast<int>(shell.body.facets.size());
  change.fatness = fatness(shell.body);
  change.solves = budget.solves;
  return options.faces == 0 || change.triangles <= options.faces;
}

}  // namespace

void check(const RemeshOptions& options) {
  require(options.faces == 0 || options.faces >= 4, "faces", options.faces, "0 or at least 4");
  require(options.regularize >= 0, "regularize", options.regularize, "at least 0");
  require(options.max_growth > 0 && options.max_growth <= 1000, "max-growth", options.max_growth, "in (0, 1000]");
}

Remeshing remesh(const Shells& shells, const RemeshOptions& options, const Run& run) {
  check(options);
  Remeshing result;
  result.shells = shells;
  const double diagonal = diagonal_of(shells);
  add_planes(result.shells);
  const int count = static_cast<int>(shells.shells.size());
  for (const Shell& shell : shells.shells) result.changes.push_back(unchanged(shell.body));
  std::vector<char> reached(count, 0);
  const Shells& before = result.shells;
  std::vector<Shell> after = before.shells;
  parallel_for(run, count, [&](int s) {
    reached[s] = remesh_one(after[s], room_of(before, s, diagonal), options, run, result.changes[s]) ? 1 : 0;
  });
  result.shells.shells = std::move(after);
  result.fatness_before = fatness_of_all(shells);
  result.fatness = fatness_of_all(result.shells);
  for (ShellContact& contact : result.shells.contacts)
    contact.polygon = contact_polygon(result.shells.shells[contact.first].body,
                                      result.shells.shells[contact.second].body, contact.plane, kTouch * diagonal);
  if (std::count(reached.begin(), reached.end(), 0) > 0) result.ending = Ending::Exhausted;
  if (run.over()) result.ending = run.ending();
  return result;
}

double fatness(const ConvexPolyhedron& body) {
  FatSum sum;
  add(body, sum);
  return sum.share();
}

}  // namespace plico
