#include "plico/origami/straight_lines.h"

#include <algorithm>
#include <cmath>

namespace plico {
namespace {

class Lines {
 public:
  Lines(const CreasePattern& sheet, double off) : sheet_(sheet), off_(off), spokes_(sheet.vertices.size()) {
    for (int e = 0; e < sheet.num_edges(); ++e) {
      spokes_[sheet.edges[e].a].push_back(e);
      spokes_[sheet.edges[e].b].push_back(e);
    }
  }

  std::vector<std::vector<int>> run() const {
    std::vector<std::vector<int>> lines;
    std::vector<char> used(sheet_.edges.size(), 0);
    for (int e = 0; e < sheet_.num_edges(); ++e) {
      if (used[e]) continue;
      std::vector<int> line = follow(e, sheet_.edges[e].a, used);
      std::reverse(line.begin(), line.end());
      const std::vector<int> rest = follow(e, sheet_.edges[e].b, used);
      line.insert(line.end(), rest.begin(), rest.end());
      if (line.front() == line.back()) line.pop_back();
      if (line.size() > 2) lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  bool is_border(int e) const {
    return sheet_.edges[e].assignment == Assignment::Boundary || sheet_.edges[e].assignment == Assignment::Cut;
  }
  int other(int e, int v) const { return sheet_.edges[e].a == v ? sheet_.edges[e].b : sheet_.edges[e].a; }

  // Vertices from `v` on, along e and what continues it.
  std::vector<int> follow(int e, int v, std::vector<char>& used) const {
    std::vector<int> line;
    for (int at = e; at >= 0;) {
      used[at] = 1;
      line.push_back(v);
      const int next = continuation(at, v);
      if (next < 0 || continuation(next, v) != at || used[next]) break;
      v = other(next, v);
      at = next;
    }
    return line;
  }

  // The edge that goes on straightest beyond v, -1 when none is straight.
  int continuation(int e, int v) const {
    const Vec2& p = sheet_.vertices[v];
    const Vec2 back = sheet_.vertices[other(e, v)] - p;
    int best = -1;
    double best_turn = 0;
    for (int f : spokes_[v]) {
      if (f == e || is_border(f) != is_border(e)) continue;
      const Vec2 ahead = sheet_.vertices[other(f, v)] - p;
      const double area = std::abs(cross(back, ahead)), turn = area / (back.norm() * ahead.norm());
      if (back.dot(ahead) >= 0 || area > off_ * (ahead - back).norm() || (best >= 0 && turn >= best_turn)) continue;
      best = f;
      best_turn = turn;
    }
    return best;
  }

  const CreasePattern& sheet_;
  double off_;
  std::vector<std::vector<int>> spokes_;
};

}  // namespace

std::vector<std::vector<int>> straight_lines(const CreasePattern& sheet, double off) { return Lines(sheet, off).run(); }

}  // namespace plico
