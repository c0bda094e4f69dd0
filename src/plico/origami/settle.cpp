#include "plico/origami/settle.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "plico/base/error.h"
#include "plico/origami/approach.h"
#include "plico/origami/drawing_symmetry.h"
#include "plico/origami/loop_walk.h"
#include "plico/origami/straight_lines.h"

namespace plico {
namespace {

constexpr double kDamping = 1e-11;
constexpr double kTurnCost = 0.1;    // of a radian, against a move by the mean edge, squared
constexpr int kRefinements = 3;      // each takes away what damping left of directions that open the sheet by little
constexpr double kFixed = 1e-6;      // radians: goals this near to 0 and pi are meant so
constexpr double kMostMove = 0.2;    // of the mean edge, and
constexpr double kMostTurn = 0.2;    // radians, in one step
constexpr double kMostOpen = 0.1;    // radians: a state on the way that opens more is none
constexpr double kLeastOpen = 1e-7;  // radians: a state is looked for with loops open by this at least
constexpr double kOpening = 10;      // times what the goal is open by
constexpr double kPlacesPerOpening = 60;        // mean edges that a place may be off by, a radian of the goal's opening
constexpr double kLeastInexact = 1e-6;          // of the shortest edge
constexpr int kMostDecimals = 5;                // that drawings are looked at for
constexpr double kOnGrid = 1e-4;                // of the grid
constexpr double kMostGoalTurn = radians(0.5);  // of a crease whose goal is neither 0 nor 180 degrees
constexpr double kLeftFlat = 0.05;              // of the way

double mean_edge(const CreasePattern& sheet) {
  double sum = 0;
  for (const Crease& e : sheet.edges) sum += (sheet.vertices[e.b] - sheet.vertices[e.a]).norm();
  return sum / std::max(1, sheet.num_edges());
}

// One unknown per coordinate of a vertex, in mean edges, then one per crease and state, the goal last.
class SettleEquations {
 public:
  SettleEquations(const CreasePattern& sheet, std::vector<Configuration> states, double off)
      : sheet_(sheet),
        loops_(real_vertices(sheet)),
        lines_(straight_lines(sheet, off)),
        states_(std::move(states)),
        unit_(mean_edge(sheet)),
        scale_(diagonal(sheet)),
        first_angle_(2 * sheet.num_vertices()) {
    const std::vector<int> hinge = hinge_of_edge(sheet);
    for (int e = 0; e < sheet.num_edges(); ++e)
      if (hinge[e] >= 0) {
        crease_[std::minmax(sheet.edges[e].a, sheet.edges[e].b)] = hinge[e];
        edge_of_.push_back(e);
      }
    for (const std::vector<int>& line : lines_) rows_ += static_cast<int>(line.size()) - 2;
    for (const RealVertex& loop : loops_) rows_ += loop.num_equations() * static_cast<int>(states_.size());
    columns_ = first_angle_ + num_creases() * static_cast<int>(states_.size());
    cost_ = Eigen::VectorXd::Constant(columns_, kTurnCost);
    cost_.head(first_angle_).setOnes();
    held_.assign(columns_, 0);
    hold_goal();
  }

  const CreasePattern& sheet() const { return sheet_; }
  const std::vector<Configuration>& states() const { return states_; }
  int num_lines() const { return static_cast<int>(lines_.size()); }

  // Least in the moves among the steps that close everything to first order.
  Eigen::VectorXd step() {
    entries_.clear();
    residual_ = Eigen::VectorXd::Zero(rows_);
    int row = 0;
    for (int s = 0; s < static_cast<int>(states_.size()); ++s)
      for (const RealVertex& loop : loops_) row = write_loop(loop, s, row);
    for (const std::vector<int>& line : lines_) row = write_line(line, row);
    Eigen::SparseMatrix<double> jacobian(rows_, columns_);
    jacobian.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::SparseMatrix<double> damping(columns_, columns_), normal(jacobian.transpose() * jacobian);
    damping.reserve(Eigen::VectorXi::Constant(columns_, 1));
    for (int c = 0; c < columns_; ++c) damping.insert(c, c) = kDamping * cost_[c];
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal + damping);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(columns_);
    for (int i = 0; i < kRefinements; ++i)
      result -= solver.solve(jacobian.transpose() * (jacobian * result + residual_));
    if (!result.allFinite()) return Eigen::VectorXd::Zero(columns_);
    const double move = result.head(first_angle_).lpNorm<Eigen::Infinity>();
    const double turn = result.tail(columns_ - first_angle_).lpNorm<Eigen::Infinity>();
    return result / std::max({1.0, move / kMostMove, turn / kMostTurn});
  }

  void take(const Eigen::VectorXd& step) {
    for (int v = 0; v < sheet_.num_vertices(); ++v) sheet_.vertices[v] += unit_ * step.segment<2>(2 * v);
    for (std::size_t s = 0; s < states_.size(); ++s)
      states_[s] += step.segment(first_angle_ + static_cast<int>(s) * num_creases(), num_creases());
    place_loops();
  }

  // Rounding must not grow into asymmetry along directions that cost nothing.
  void symmetrize(const std::vector<DrawingSymmetry>& group) {
    if (group.size() < 2) return;
    sheet_.vertices = symmetrized(sheet_.vertices, group);
    std::vector<Configuration> sums(states_.size(), Configuration::Zero(num_creases()));
    for (const DrawingSymmetry& symmetry : group)
      for (int h = 0; h < num_creases(); ++h) {
        const Crease& edge = sheet_.edges[edge_of_[h]];
        const int image = crease_.at(std::minmax(symmetry.vertex[edge.a], symmetry.vertex[edge.b]));
        for (std::size_t s = 0; s < states_.size(); ++s) sums[s][image] += states_[s][h];
      }
    for (std::size_t s = 0; s < states_.size(); ++s) states_[s] = sums[s] / static_cast<double>(group.size());
    place_loops();
  }

  double open(const Configuration& state) const { return closure(loops_, state).worst; }
  double worst() const {
    double worst = bend();
    for (const Configuration& state : states_) worst = std::max(worst, open(state));
    return worst;
  }

 private:
  int num_creases() const { return static_cast<int>(edge_of_.size()); }

  void hold_goal() {
    const int last = columns_ - num_creases();
    for (int h = 0; h < num_creases(); ++h) {
      const double size = std::abs(states_.back()[h]);
      held_[last + h] = size < kFixed || size > kPi - kFixed ? 1 : 0;
    }
  }

  void place_loops() {
    for (RealVertex& loop : loops_) {
      const Vec2 first = loop.is_hole() ? ends(loop, 0).from : Vec2(Vec2::Zero());
      for (std::size_t k = 0; k < loop.hinges.size(); ++k) {
        const Ends at = ends(loop, k);
        loop.directions[k] = at.along.normalized();
        if (loop.is_hole()) loop.points[k] = (at.from - first) / scale_;
      }
    }
  }

  // The edge of the k-th crease of a loop, away from the vertex or hole.
  struct Ends {
    int a, b;
    Vec2 from, along;
  };
  Ends ends(const RealVertex& loop, std::size_t k) const {
    const Crease& edge = sheet_.edges[edge_of_[loop.hinges[k]]];
    const Vec2 along = sheet_.vertices[edge.b] - sheet_.vertices[edge.a];
    if (along.dot(loop.directions[k]) >= 0) return {edge.a, edge.b, sheet_.vertices[edge.a], along};
    return {edge.b, edge.a, sheet_.vertices[edge.b], -along};
  }

  void add(int row, int column, double value) {
    if (value != 0 && !held_[column]) entries_.emplace_back(row, column, value);
  }

  // A crease whose line turns in the sheet by a small angle and shifts turns what comes after it, and turns it back
  // after itself: the motions of the paper before and after it, seen in space, differ.
  int write_loop(const RealVertex& loop, int state, int row) {
    const std::size_t creases = loop.hinges.size();
    std::vector<Vec3> axis, point;
    std::vector<Walk> before;
    const Walk end = walk_around(loop, states_[state], [&](std::size_t, const Vec3& a, const Vec3& p) {
      axis.push_back(a);
      point.push_back(p);
    });
    Walk walk;
    for (std::size_t k = 0; k < creases; ++k) {
      before.push_back(walk);
      const Eigen::Quaterniond turn = quaternion(axis[k], states_[state][loop.hinges[k]]);
      walk.turn = turn * walk.turn;
      if (loop.is_hole()) walk.shift = point[k] + turn * (walk.shift - point[k]);
    }
    before.push_back(walk);
    write_residual(loop, end, &residual_[row]);
    for (std::size_t k = 0; k < creases; ++k) {
      const int angle = first_angle_ + state * num_creases() + loop.hinges[k];
      const Vec3 shift = axis[k].cross(end.shift - point[k]);
      for (int i = 0; i < 3; ++i) {
        add(row + i, angle, axis[k][i]);
        if (loop.is_hole()) add(row + 3 + i, angle, shift[i]);
      }
      write_moves(loop, k, before[k], before[k + 1], end.shift, row);
    }
    return row + loop.num_equations();
  }

  void write_moves(const RealVertex& loop, std::size_t k, const Walk& before, const Walk& after, const Vec3& end,
                   int row) {
    const Ends at = ends(loop, k);
    const Vec2 across = Vec2(-at.along.y(), at.along.x()) / at.along.squaredNorm();
    for (int i = 0; i < 2; ++i)
      for (const bool far : {false, true}) {
        const double turn = unit_ * (far ? 1 : -1) * across[i];
        Vec3 shift = Vec3::Zero();
        if (!far) shift[i] = unit_ / scale_;
        const int column = 2 * (far ? at.b : at.a) + i;
        const Vec3 z = before.turn * Vec3(0, 0, turn) - after.turn * Vec3(0, 0, turn);
        for (int r = 0; r < 3; ++r) add(row + r, column, z[r]);
        if (!loop.is_hole()) continue;
        const Vec3 point(loop.points[k].x(), loop.points[k].y(), 0);
        const auto velocity = [&](const Walk& walk) -> Vec3 {
          const Vec3 here = walk.turn.conjugate() * (end - walk.shift);
          return walk.turn * (Vec3(0, 0, turn).cross(here - point) + shift);
        };
        const Vec3 moved = velocity(before) - velocity(after);
        for (int r = 0; r < 3; ++r) add(row + 3 + r, column, moved[r]);
      }
  }

  // Distances from the line through both ends, in mean edges.
  int write_line(const std::vector<int>& line, int row) {
    const int a = line.front(), b = line.back();
    const Vec2 along = sheet_.vertices[b] - sheet_.vertices[a];
    const Vec2 across = Vec2(-along.y(), along.x()).normalized();
    for (std::size_t k = 1; k + 1 < line.size(); ++k, ++row) {
      const Vec2 at = sheet_.vertices[line[k]] - sheet_.vertices[a];
      const double share = at.dot(along) / along.squaredNorm();
      residual_[row] = at.dot(across) / unit_;
      for (int i = 0; i < 2; ++i) {
        add(row, 2 * line[k] + i, across[i]);
        add(row, 2 * a + i, (share - 1) * across[i]);
        add(row, 2 * b + i, -share * across[i]);
      }
    }
    return row;
  }

  double bend() const {
    double worst = 0;
    for (const std::vector<int>& line : lines_) {
      const Vec2& a = sheet_.vertices[line.front()];
      const Vec2 along = (sheet_.vertices[line.back()] - a).normalized();
      for (int v : line) worst = std::max(worst, std::abs(cross(along, Vec2(sheet_.vertices[v] - a))) / unit_);
    }
    return worst;
  }

  CreasePattern sheet_;
  std::vector<RealVertex> loops_;
  std::vector<std::vector<int>> lines_;
  std::vector<Configuration> states_;
  double unit_, scale_;
  int first_angle_, rows_ = 0, columns_ = 0;
  std::vector<int> edge_of_;                   // of each hinge
  std::map<std::pair<int, int>, int> crease_;  // between two vertices
  Eigen::VectorXd cost_, residual_;
  std::vector<char> held_;
  std::vector<Eigen::Triplet<double>> entries_;
};

void check(const SettleOptions& o) {
  require(o.states >= 0, "states", o.states, "at least 0");
  require(o.drawn > 0, "drawn", o.drawn, "above 0");
  require(o.most_move > 0, "most move", o.most_move, "above 0");
  require(o.tolerance > 0, "tolerance", o.tolerance, "above 0");
}

// States at equal shares of the way, with loops open by little; fewer when the sheet does not leave flat.
std::vector<Configuration> states_on_the_way(const CreasePattern& sheet, int count, double open, const Run& run) {
  std::vector<Configuration> states;
  if (count == 0) return states;
  ApproachOptions approach;
  approach.check_collisions = false;
  approach.tolerance = std::clamp(kOpening * open, kLeastOpen, kMostOpen);
  approach.damping = std::max(1e-9, approach.tolerance / 100);
  approach.max_waypoints = 150;
  const ContinuationResult found = approach_goal(sheet, {}, approach, run);
  if (found.progress < kLeftFlat) return states;
  const Linkage linkage = make_linkage(sheet);
  for (int i = 1; i <= count; ++i) {
    const double share = std::min(found.progress, 0.98) * i / (count + 1);
    const auto off = [&](const Waypoint& w) { return std::abs(share_of_way(linkage, w.config) - share); };
    const auto nearest = std::min_element(found.path.waypoints.begin() + 1, found.path.waypoints.end(),
                                          [&](const Waypoint& a, const Waypoint& b) { return off(a) < off(b); });
    states.push_back(nearest->config);
  }
  return states;
}

// Units that symmetric places may be apart where all coordinates were rounded to the same few decimals; 0 where not.
double rounding_apart(const CreasePattern& sheet) {
  double grid = 1;
  for (int decimals = 1; decimals <= kMostDecimals; ++decimals) {
    grid /= 10;
    const auto is_on_grid = [=](double x) { return std::abs(x / grid - std::round(x / grid)) < kOnGrid; };
    if (std::all_of(sheet.vertices.begin(), sheet.vertices.end(),
                    [&](const Vec2& p) { return is_on_grid(p.x()) && is_on_grid(p.y()); }))
      return 1.5 * grid;  // a half in x and in y, of both
  }
  return 0;
}

// Units that places are off by, as the goal and the decimals tell: what is off by more than a few of these was drawn
// so. A goal may nearly close by chance.
double inexactness(const CreasePattern& sheet, double open, const SettleOptions& options) {
  const double least = std::max(kLeastInexact * shortest_edge(sheet),
                                std::min(rounding_apart(sheet), options.drawn * shortest_edge(sheet)));
  return std::clamp(kPlacesPerOpening * open * mean_edge(sheet), least,
                    std::max(least, options.drawn * shortest_edge(sheet)));
}

double largest_move(const CreasePattern& from, const CreasePattern& to) {
  double largest = 0;
  for (int v = 0; v < from.num_vertices(); ++v) largest = std::max(largest, (to.vertices[v] - from.vertices[v]).norm());
  return largest;
}

// To the tolerance and on while it gets better, for what comes after closes to less than states do.
void close(SettleEquations& equations, const std::vector<DrawingSymmetry>& group, const SettleOptions& options,
           const Run& run, Settled& result) {
  const CreasePattern drawn = equations.sheet();
  equations.symmetrize(group);
  const double most = options.most_move * shortest_edge(drawn);
  const Configuration target = equations.states().back();
  double worst = equations.worst();
  while (worst > 0 && result.steps < options.max_steps && !run.over()) {
    SettleEquations next = equations;
    next.take(next.step());
    next.symmetrize(group);
    ++result.steps;
    const double next_worst = next.worst();
    if (worst <= options.tolerance && next_worst > worst / 2) break;
    if (largest_move(drawn, next.sheet()) > most) break;
    if ((next.states().back() - target).cwiseAbs().maxCoeff() > kMostGoalTurn) break;
    equations = std::move(next);
    worst = next_worst;
  }
}

void measure(const CreasePattern& given, Settled& result) {
  for (int v = 0; v < given.num_vertices(); ++v) {
    const double move = (result.sheet.vertices[v] - given.vertices[v]).norm();
    if (move <= result.move) continue;
    result.move = move;
    result.vertex = v;
  }
  const double shortest = shortest_edge(given);
  result.move_share = shortest > 0 ? result.move / shortest : 0;
}

void write_goal(CreasePattern& sheet, const Configuration& goal) {
  const std::vector<int> hinge = hinge_of_edge(sheet);
  for (int e = 0; e < sheet.num_edges(); ++e)
    if (hinge[e] >= 0) sheet.edges[e].fold_angle = std::clamp(goal[hinge[e]], -kPi, kPi);
}

}  // namespace

double shortest_edge(const CreasePattern& sheet) {
  double shortest = sheet.edges.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (const Crease& e : sheet.edges) shortest = std::min(shortest, (sheet.vertices[e.b] - sheet.vertices[e.a]).norm());
  return shortest;
}

Settled settle(const CreasePattern& sheet, const SettleOptions& options, const Run& run) {
  check(options);
  Settled result;
  const Configuration target = goal(make_linkage(sheet));
  result.open_before = closure(real_vertices(sheet), target).worst;
  const double off = inexactness(sheet, result.open_before, options);
  CreasePattern drawn = sheet;
  std::vector<DrawingSymmetry> group;
  if (options.keep_symmetry && off > 0) {
    group = drawing_symmetries(sheet, off);
    result.symmetries = static_cast<int>(group.size());
    drawn.vertices = symmetrized(drawn.vertices, group);
  }
  result.states = states_on_the_way(drawn, options.states, result.open_before, run);
  std::vector<Configuration> states = result.states;
  states.push_back(target);
  SettleEquations equations(drawn, std::move(states), off);
  close(equations, group, options, run, result);
  result.lines = equations.num_lines();
  result.closed = equations.worst() <= options.tolerance;
  result.sheet = result.closed ? equations.sheet() : sheet;
  result.states = equations.states();
  if (result.closed) write_goal(result.sheet, result.states.back());
  result.open = closure(real_vertices(result.sheet), goal(make_linkage(result.sheet))).worst;
  result.states.pop_back();
  measure(sheet, result);
  return result;
}

}  // namespace plico
