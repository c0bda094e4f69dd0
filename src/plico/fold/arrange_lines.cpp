#include "plico/fold/arrange_lines.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "plico/base/error.h"
#include "plico/fold/merge_distance.h"
#include "plico/fold/planar_faces.h"
#include "plico/geom/box_tree.h"
#include "plico/geom/predicates.h"

namespace plico {
namespace {

constexpr std::size_t kMostLines = 2'000'000;
constexpr std::int64_t kMostPairs = 100'000'000;  // a second or two; real drawings have a few a line
constexpr int kMostRounds = 40;
constexpr std::size_t kMostLinesTried = 20'000;         // with more than one distance
constexpr double kLeastMerge = 1e-9, kMostMerge = 0.1;  // of the drawing's longer side

// Points no two of which are closer than `distance`, found again through square cells of that size.
class Points {
 public:
  Points(const Vec2& origin, double distance) : origin_(origin), distance_(distance) {}

  const Vec2& operator[](int i) const { return points_[i]; }
  int size() const { return static_cast<int>(points_.size()); }

  // The nearest point within the distance; -1 for none. Ties go to the older.
  int find(const Vec2& p) const {
    int best = -1;
    double best_gap = distance_;
    const auto [cx, cy] = cell(p);
    for (std::int64_t x = cx - 1; x <= cx + 1; ++x) {
      for (std::int64_t y = cy - 1; y <= cy + 1; ++y) {
        const auto at = cells_.find(key(x, y));
        if (at == cells_.end()) continue;
        for (int i : at->second) {
          const double gap = (points_[i] - p).norm();
          if (gap < best_gap || (gap == best_gap && i < best)) best = i, best_gap = gap;
        }
      }
    }
    return best;
  }

  int add(const Vec2& p) {
    const auto [x, y] = cell(p);
    cells_[key(x, y)].push_back(size());
    points_.push_back(p);
    return size() - 1;
  }

 private:
  std::pair<std::int64_t, std::int64_t> cell(const Vec2& p) const {
    return {std::llround((p.x() - origin_.x()) / distance_), std::llround((p.y() - origin_.y()) / distance_)};
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
  }

  Vec2 origin_;
  double distance_;
  std::vector<Vec2> points_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

struct Piece {
  int a, b;   // points
  int drawn;  // the line it is a piece of
};

// How much a line says: when two lie on each other the higher is kept.
int rank(Assignment a) {
  switch (a) {
    case Assignment::Boundary:
      return 4;
    case Assignment::Cut:
      return 3;
    case Assignment::Mountain:
    case Assignment::Valley:
      return 2;
    case Assignment::Flat:
    case Assignment::Join:
      return 1;
    case Assignment::Unassigned:
      break;
  }
  return 0;
}

double extent(const std::vector<DrawnLine>& lines, Vec2& low) {
  if (lines.empty()) throw InvalidInput("pattern/empty", "the drawing has no lines");
  if (lines.size() > kMostLines)
    throw InvalidInput("pattern/size", fmt::format("{} lines, at most {} are read", lines.size(), kMostLines));
  Eigen::AlignedBox2d box;
  for (const DrawnLine& line : lines) box.extend(line.a).extend(line.b);
  low = box.min();
  const double longest = box.sizes().maxCoeff();
  if (!(longest > 0)) throw InvalidInput("pattern/empty", "all lines lie in one point", near(low));
  const double farthest = std::max(low.cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (longest < 1e-6 * farthest)
    throw InvalidInput("pattern/far",
                       fmt::format("the drawing is {:.3g} wide but {:.3g} away from the origin, too far "
                                   "for the digits of a double",
                                   longest, farthest),
                       near(low), "move the drawing to the origin");
  return longest;
}

class Arranger {
 public:
  Arranger(const std::vector<DrawnLine>& lines, const Vec2& low, double distance)
      : lines_(lines), points_(low, distance) {
    out_.distance = distance;
  }

  Arrangement run() {
    join_ends();
    for (int round = 0; split(); ++round)
      if (round == kMostRounds)
        throw InvalidInput("pattern/tangled", "lines lie so close together that splitting them comes to no end",
                           near(points_[pieces_[0].a]), "join line ends over a smaller distance");
    lay_out_pages();
    return std::move(out_);
  }

 private:
  int point_at(const Vec2& p) {
    const int found = points_.find(p);
    return found >= 0 ? found : points_.add(p);
  }

  void join_ends() {
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
      const DrawnLine& line = lines_[i];
      const int a = point_at(line.a), b = point_at(line.b);
      out_.joined_ends += (points_[a] != line.a) + (points_[b] != line.b);
      if (a == b)
        ++out_.dropped_dots;
      else
        pieces_.push_back({a, b, i});
    }
    drop_duplicates();
  }

  bool touches(int point, const Piece& piece) const {
    if (point == piece.a || point == piece.b) return false;
    const Vec2 &p = points_[point], &a = points_[piece.a], &b = points_[piece.b];
    const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
    return t > 0 && t < 1 && (a + t * (b - a) - p).norm() <= out_.distance;
  }

  // Where the insides of two pieces cross.
  std::optional<Vec2> crossing(const Piece& s, const Piece& t) const {
    const Vec2 &a = points_[s.a], &b = points_[s.b], &c = points_[t.a], &d = points_[t.b];
    if (orient2d(a, b, c) * orient2d(a, b, d) >= 0 || orient2d(c, d, a) * orient2d(c, d, b) >= 0) return {};
    const double area = cross(b - a, d - c);
    if (area == 0) return {};
    return a + std::clamp(cross(c - a, d - c) / area, 0.0, 1.0) * (b - a);
  }

  // Notes in cuts_ where two pieces meet.
  void meet(int i, int j) {
    const Piece s = pieces_[i], t = pieces_[j];
    bool tee = false;
    for (int p : {s.a, s.b})
      if (touches(p, t)) tee = true, cuts_[j].push_back(p), ++out_.tees;
    for (int p : {t.a, t.b})
      if (touches(p, s)) tee = true, cuts_[i].push_back(p), ++out_.tees;
    if (tee || s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return;
    const std::optional<Vec2> at = crossing(s, t);
    if (!at) return;
    const int before = points_.size(), p = point_at(*at);
    out_.crossings += p == before;
    for (int k : {i, j})
      if (p != pieces_[k].a && p != pieces_[k].b) cuts_[k].push_back(p);
  }

  // One round of splitting; false when no two pieces meet any more.
  bool split() {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Piece& piece : pieces_) {
      Eigen::AlignedBox2d box(points_[piece.a]);
      box.extend(points_[piece.b]);
      const Vec2 low = box.min().array() - out_.distance, high = box.max().array() + out_.distance;
      boxes.emplace_back(Vec3(low.x(), low.y(), 0), Vec3(high.x(), high.y(), 0));
    }
    cuts_.assign(pieces_.size(), {});
    BoxTree(boxes).overlapping_pairs([&](int i, int j) {
      if (++pairs_ > kMostPairs)
        throw InvalidInput("pattern/tangled", fmt::format("more than {} pairs of lines lie side by side", kMostPairs),
                           near(points_[pieces_[i].a]));
      meet(i, j);
      return true;
    });
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < pieces_.size(); ++i) cut(pieces_[i], cuts_[i], pieces);
    const bool changed = pieces.size() != pieces_.size();
    pieces_ = std::move(pieces);
    drop_duplicates();
    return changed;
  }

  void cut(const Piece& piece, std::vector<int>& at, std::vector<Piece>& pieces) const {
    const Vec2 direction = points_[piece.b] - points_[piece.a];
    const auto along = [&](int p) { return (points_[p] - points_[piece.a]).dot(direction); };
    std::sort(at.begin(), at.end(), [&](int p, int q) { return std::pair(along(p), p) < std::pair(along(q), q); });
    at.erase(std::unique(at.begin(), at.end()), at.end());
    at.push_back(piece.b);
    for (int from = piece.a; int to : at) {
      pieces.push_back({from, to, piece.drawn});
      from = to;
    }
  }

  // Keeps one of the pieces between the same two points: the one that says most, the first drawn among equals.
  void drop_duplicates() {
    const auto ends = [&](int i) { return std::minmax(pieces_[i].a, pieces_[i].b); };
    std::vector<int> order(pieces_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      const std::pair<int, int> p = ends(i), q = ends(j);
      if (p != q) return p < q;
      const int r = rank(lines_[pieces_[i].drawn].assignment), s = rank(lines_[pieces_[j].drawn].assignment);
      return r != s ? r > s : i < j;
    });
    std::vector<char> kept(pieces_.size(), 1);
    for (std::size_t k = 1, winner = 0; k < order.size(); ++k) {
      if (ends(order[k]) != ends(order[winner])) {
        winner = k;
        continue;
      }
      kept[order[k]] = 0;
      count_duplicate(lines_[pieces_[order[winner]].drawn], lines_[pieces_[order[k]].drawn]);
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (kept[i]) pieces_[next++] = pieces_[i];
    pieces_.resize(next);
  }

  void count_duplicate(const DrawnLine& winner, const DrawnLine& loser) {
    ++out_.duplicates;
    if (winner.assignment == loser.assignment && winner.fold_angle == loser.fold_angle) return;
    if (out_.conflicts++ == 0) out_.conflict_at = loser.place;
  }

  void lay_out_pages() {
    std::vector<int> number(points_.size(), -1);
    CreasePattern& sheet = out_.sheet;
    const auto vertex = [&](int p) {
      if (number[p] < 0) {
        number[p] = sheet.num_vertices();
        sheet.vertices.push_back(points_[p]);
      }
      return number[p];
    };
    for (const Piece& piece : pieces_) {
      const int a = vertex(piece.a), b = vertex(piece.b);
      const DrawnLine& line = lines_[piece.drawn];
      sheet.edges.push_back({a, b, line.assignment, line.fold_angle});
      out_.drawn.push_back(piece.drawn);
    }
    sheet.faces = planar_faces(sheet.vertices, sheet.edges);
    if (sheet.faces.empty())
      throw InvalidInput("pattern/no-panel", "the lines enclose no panel", {}, "draw the border of the sheet");
    const std::vector<EdgeSides> sides = edge_sides(sheet);
    for (int e = 0; e < sheet.num_edges(); ++e) {
      Crease& edge = sheet.edges[e];
      const int beside = (sides[e].left >= 0) + (sides[e].right >= 0);
      out_.loose += beside == 0;
      if (beside != 1 || edge.assignment == Assignment::Boundary) continue;
      ++out_.rims;
      edge.assignment = Assignment::Boundary;
      edge.fold_angle = 0;
    }
  }

  const std::vector<DrawnLine>& lines_;
  Points points_;
  std::vector<Piece> pieces_;
  std::vector<std::vector<int>> cuts_;  // of each piece, the points to split it at
  std::int64_t pairs_ = 0;
  Arrangement out_;
};

double asked_distance(double distance, double longest) {
  if (distance >= kLeastMerge * longest && distance <= kMostMerge * longest) return distance;
  throw InvalidOption(fmt::format("merge = {:g} must be in [{:.3g}, {:.3g}], from {:g} to {:g} of the drawing",
                                  distance, kLeastMerge * longest, kMostMerge * longest, kLeastMerge, kMostMerge));
}

// What a person would not have drawn: creases that end in the middle of a panel, or were lost.
int flaws(const Arrangement& a) {
  std::vector<int> degree(a.sheet.vertices.size(), 0);
  for (const Crease& e : a.sheet.edges) ++degree[e.a], ++degree[e.b];
  return a.loose + a.dropped_dots + a.conflicts + static_cast<int>(std::count(degree.begin(), degree.end(), 1));
}

std::optional<Arrangement> try_distance(const std::vector<DrawnLine>& lines, const Vec2& low, double distance) {
  try {
    return Arranger(lines, low, distance).run();
  } catch (const InvalidInput&) {
    return {};
  }
}

}  // namespace

Arrangement arrange_lines(const std::vector<DrawnLine>& lines, const ArrangeOptions& options) {
  if (!(options.merge >= kLeastMerge && options.merge <= kMostMerge))
    throw InvalidOption(fmt::format("merge = {} must be in [{:g}, {:g}]", options.merge, kLeastMerge, kMostMerge));
  Vec2 low;
  const double longest = extent(lines, low);
  if (options.distance > 0) return Arranger(lines, low, asked_distance(options.distance, longest)).run();
  const double usual = options.merge * longest;
  if (!options.found) return Arranger(lines, low, usual).run();
  std::optional<Arrangement> best;
  for (double distance : merge_distances(lines, longest, options.merge)) {
    std::optional<Arrangement> arranged = try_distance(lines, low, distance);
    if (arranged && (!best || flaws(*arranged) < flaws(*best))) best = std::move(arranged);
    if (best && (flaws(*best) == 0 || lines.size() > kMostLinesTried)) break;
  }
  if (!best) return Arranger(lines, low, usual).run();  // which says what is wrong
  best->customary = best->distance == usual;
  return std::move(*best);
}

std::vector<std::string> notes(const Arrangement& a, const std::string& place) {
  std::vector<std::string> result;
  const auto say = [&](int count, const std::string& one, const std::string& many) {
    if (count > 0) result.push_back(count == 1 ? "1 " + one : fmt::format("{} {}", count, many));
  };
  const std::string distance =
      fmt::format("{:.3g}{}", a.distance, a.customary ? "" : " (found from the drawing; --merge sets another)");
  say(a.joined_ends, "line end was moved onto another within " + distance,
      "line ends were moved onto others within " + distance);
  say(a.dropped_dots, "line no longer than " + distance + " was left out",
      "lines no longer than " + distance + " were left out");
  say(a.crossings, "point where lines cross became a vertex", "points where lines cross became vertices");
  say(a.tees, "line was split where another ends on it", "times a line was split where another ends on it");
  say(a.duplicates - a.conflicts, "line drawn twice was kept once", "lines drawn again were left out");
  const std::string first = fmt::format(" (first at {} {})", place, a.conflict_at);
  say(a.conflicts, "line lies on one of another kind and was left out" + first,
      "lines lie on others of another kind and were left out" + first);
  say(a.rims, "crease on the rim of the sheet became border", "creases on the rim of the sheet became border");
  say(a.loose, "line lies beside no two panels and folds nothing", "lines lie beside no two panels and fold nothing");
  return result;
}

}  // namespace plico
