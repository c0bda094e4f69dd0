#include "plico/fold/planar_faces.h"

#include <algorithm>
#include <numeric>

#include "plico/base/error.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

bool in_box(const Vec2& p, const Vec2& a, const Vec2& b) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}

bool on_segment(const Vec2& p, const Vec2& a, const Vec2& b) { return in_box(p, a, b) && orient2d(a, b, p) == 0; }

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)) return true;
  return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

// Do two edges meet anywhere but at a shared vertex?
bool edges_clash(const std::vector<Vec2>& at, const Crease& e, const Crease& f) {
  if (e.a != f.a && e.a != f.b && e.b != f.a && e.b != f.b) return segments_meet(at[e.a], at[e.b], at[f.a], at[f.b]);
  const int hub = e.a == f.a || e.a == f.b ? e.a : e.b, p = e.a == hub ? e.b : e.a, q = f.a == hub ? f.b : f.a;
  return p == q || on_segment(at[p], at[hub], at[q]) || on_segment(at[q], at[hub], at[p]);
}

// Calls `visit(e, f)` for every pair of edges that clash, e after f along x, until it returns true.
template <class Visit>
void sweep_clashes(const std::vector<Vec2>& at, const std::vector<Crease>& edges, Visit visit) {
  const auto low_x = [&](int e) { return std::min(at[edges[e].a].x(), at[edges[e].b].x()); };
  const auto high_x = [&](int e) { return std::max(at[edges[e].a].x(), at[edges[e].b].x()); };
  std::vector<int> order(edges.size()), active;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int e, int f) { return low_x(e) < low_x(f); });
  for (int e : order) {
    const Vec2 &a = at[edges[e].a], &b = at[edges[e].b];
    if (a == b) continue;
    std::erase_if(active, [&](int f) { return high_x(f) < low_x(e); });
    const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
    for (int f : active) {
      const Vec2 &c = at[edges[f].a], &d = at[edges[f].b];
      if (std::max(c.y(), d.y()) < low || high < std::min(c.y(), d.y())) continue;
      if (edges_clash(at, edges[e], edges[f]) && visit(e, f)) return;
    }
    active.push_back(e);
  }
}

void check_planar(const std::vector<Vec2>& at, const std::vector<Crease>& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (at[edges[e].a] == at[edges[e].b])
      throw InvalidInput("fold/edge-length", fmt::format("edge {} has no length", e), near(at[edges[e].a]));
  sweep_clashes(at, edges, [&](int e, int f) -> bool {
    throw InvalidInput("fold/edges-cross",
                       fmt::format("edges {} and {} meet away from a common vertex", std::min(e, f), std::max(e, f)),
                       near(meeting_point(at, edges[e], edges[f])), "split the edges where they meet");
  });
}

// Halfedge 2 e runs a -> b along edge e, halfedge 2 e + 1 runs back.
class Walker {
 public:
  Walker(const std::vector<Vec2>& at, const std::vector<Crease>& edges)
      : at_(at), edges_(edges), alive_(edges.size(), 1) {}

  std::vector<std::vector<int>> run() {
    do {
      link();
      walk();
    } while (drop_bridges());
    std::vector<std::vector<int>> loops;
    for (const std::vector<int>& cycle : cycles_) split_into_loops(cycle, loops);
    std::erase_if(loops, [&](const std::vector<int>& loop) { return !counter_clockwise(loop); });
    mark_panels(loops);
    std::vector<std::vector<int>> faces;
    for (const std::vector<int>& loop : loops) {
      if (is_hole(loop)) continue;
      std::vector<int>& face = faces.emplace_back();
      for (int h : loop) face.push_back(from(h));
    }
    return faces;
  }

 private:
  int from(int h) const { return h % 2 == 0 ? edges_[h / 2].a : edges_[h / 2].b; }
  int to(int h) const { return from(h ^ 1); }

  // Counter-clockwise order of the halfedges that leave one vertex, starting at +x; exact.
  bool turns_before(int g, int h) const {
    const Vec2 &v = at_[from(g)], &p = at_[to(g)], &q = at_[to(h)];
    const auto lower = [&](const Vec2& r) { return r.y() < v.y() || (r.y() == v.y() && r.x() < v.x()); };
    if (lower(p) != lower(q)) return lower(q);
    return orient2d(v, p, q) > 0;
  }

  void link() {
    std::vector<std::vector<int>> leaving(at_.size());
    for (int h = 0; h < 2 * static_cast<int>(edges_.size()); ++h)
      if (alive_[h / 2]) leaving[from(h)].push_back(h);
    next_.assign(2 * edges_.size(), -1);
    for (std::vector<int>& fan : leaving) {
      std::sort(fan.begin(), fan.end(), [&](int g, int h) { return turns_before(g, h); });
      // Arriving against fan[i], the leftmost way on is the one just clockwise of it.
      for (std::size_t i = 0; i < fan.size(); ++i) next_[fan[i] ^ 1] = fan[(i + fan.size() - 1) % fan.size()];
    }
  }

  void walk() {
    cycles_.clear();
    cycle_of_.assign(next_.size(), -1);
    for (int start = 0; start < static_cast<int>(next_.size()); ++start) {
      if (next_[start] < 0 || cycle_of_[start] >= 0) continue;
      const int id = static_cast<int>(cycles_.size());
      std::vector<int>& cycle = cycles_.emplace_back();
      for (int h = start; cycle_of_[h] < 0; h = next_[h]) {
        cycle_of_[h] = id;
        cycle.push_back(h);
      }
    }
  }

  bool drop_bridges() {
    bool dropped = false;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!alive_[e] || cycle_of_[2 * e] != cycle_of_[2 * e + 1]) continue;
      alive_[e] = 0;
      dropped = true;
    }
    return dropped;
  }

  // A cycle that comes back to a vertex is cut there.
  void split_into_loops(const std::vector<int>& cycle, std::vector<std::vector<int>>& loops) {
    last_at_.resize(at_.size(), -1);
    std::vector<int> stack;
    for (int h : cycle) {
      if (last_at_[from(h)] >= 0) {
        const auto first = stack.begin() + last_at_[from(h)];
        for (auto g = first; g != stack.end(); ++g) last_at_[from(*g)] = -1;
        loops.emplace_back(first, stack.end());
        stack.erase(first, stack.end());
      }
      last_at_[from(h)] = static_cast<int>(stack.size());
      stack.push_back(h);
    }
    for (int h : stack) last_at_[from(h)] = -1;
    loops.push_back(std::move(stack));
  }

  // The turn at the lowest leftmost corner of a simple loop tells its orientation.
  bool counter_clockwise(const std::vector<int>& loop) const {
    if (loop.size() < 3) return false;
    const auto less = [&](int g, int h) {
      const Vec2 &p = at_[from(g)], &q = at_[from(h)];
      return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    };
    const auto corner = std::min_element(loop.begin(), loop.end(), less);
    const int before = corner == loop.begin() ? loop.back() : *(corner - 1);
    return orient2d(at_[from(before)], at_[from(*corner)], at_[to(*corner)]) > 0;
  }

  bool all_boundary(const std::vector<int>& loop) const {
    return std::all_of(loop.begin(), loop.end(),
                       [&](int h) { return edges_[h / 2].assignment == Assignment::Boundary; });
  }

  void mark_panels(const std::vector<std::vector<int>>& loops) {
    panel_.assign(next_.size(), 0);
    for (const std::vector<int>& loop : loops)
      if (!all_boundary(loop))
        for (int h : loop) panel_[h] = 1;
  }

  bool is_hole(const std::vector<int>& loop) const {
    return all_boundary(loop) && std::any_of(loop.begin(), loop.end(), [&](int h) { return panel_[h ^ 1] != 0; });
  }

  const std::vector<Vec2>& at_;
  const std::vector<Crease>& edges_;
  std::vector<char> alive_;               // per edge
  std::vector<int> next_, cycle_of_;      // per halfedge
  std::vector<char> panel_;               // per halfedge: on a counter-clockwise loop with a crease
  std::vector<std::vector<int>> cycles_;  // halfedges
  std::vector<int> last_at_;              // per vertex: its place in the cycle being split
};

}  // namespace

std::vector<std::vector<int>> planar_faces(const std::vector<Vec2>& vertices, const std::vector<Crease>& edges) {
  check_planar(vertices, edges);
  return Walker(vertices, edges).run();
}

std::vector<std::pair<int, int>> clashing_edges(const std::vector<Vec2>& vertices, const std::vector<Crease>& edges) {
  std::vector<std::pair<int, int>> clashes;
  sweep_clashes(vertices, edges, [&](int e, int f) {
    clashes.emplace_back(std::min(e, f), std::max(e, f));
    return false;
  });
  std::sort(clashes.begin(), clashes.end());
  return clashes;
}

std::string near(const Vec2& p) { return fmt::format("near {:.6g} {:.6g}", p.x(), p.y()); }

Vec2 meeting_point(const std::vector<Vec2>& vertices, const Crease& e, const Crease& f) {
  const Vec2 &a = vertices[e.a], &b = vertices[e.b], &c = vertices[f.a], &d = vertices[f.b];
  if (f.a != e.a && f.a != e.b && on_segment(c, a, b)) return c;
  if (f.b != e.a && f.b != e.b && on_segment(d, a, b)) return d;
  if (on_segment(a, c, d) && e.a != f.a && e.a != f.b) return a;
  if (on_segment(b, c, d)) return b;
  const Vec2 u = b - a, v = d - c, w = c - a;
  return a + u * ((w.x() * v.y() - w.y() * v.x()) / (u.x() * v.y() - u.y() * v.x()));
}

}  // namespace plico
