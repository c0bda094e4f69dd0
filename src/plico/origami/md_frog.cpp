#include "plico/origami/md_frog.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

#include "plico/base/error.h"
#include "plico/origami/layers.h"

namespace plico {
namespace {

// Rejected steps after which a nonlinear connection is given up, round after round: most that hold need no random step,
// and most that do not would cost many.
constexpr std::array<long, 3> kPatience = {2, 20, 300};

// Euclidean, radians: waypoints that are not farther apart let the motion between them be proven.
constexpr double kResolution = 0.1;

constexpr std::size_t kMostNodes = 5000;  // states with their layers: each brings an arc to every state

constexpr double kEstimate = 1e6;  // estimates that differ by less than 1 / kEstimate are equal

// Of each pair of panels that lie on each other: +1 or -1, as one lies on the other, or 0 when no connection told.
using Sides = std::vector<signed char>;

using Edge = std::pair<int, int>;  // from the state closer to flat along the path

void check(const MdFrogOptions& o) {
  require(o.max_states >= 0, "max states", o.max_states, "at least 0");
  require(o.max_connections >= 0, "max connections", o.max_connections, "at least 0");
  require(o.max_refuted >= 0, "max refuted", o.max_refuted, "at least 0");
  require(o.alternatives >= 1, "alternatives", o.alternatives, "at least 1");
  require(o.linear_samples >= 1, "linear samples", o.linear_samples, "at least 1");
}

class Roadmap {
 public:
  Roadmap(const Linkage& linkage, const MdFrogOptions& options, const Run& run)
      : options_(options),
        run_(run),
        linkage_(linkage),
        vertices_(linkage.loops),
        projector_(vertices_, linkage_.num_hinges()),
        checker_(linkage_, options.frog.collision),
        layers_(linkage_, checker_.clearance()),
        frog_(linkage, options.frog) {
    add(flat(linkage_));
    projection_.tolerance = options.frog.tolerance;
    projection_.low = lower_limits(linkage_);
    projection_.high = upper_limits(linkage_);
    stops_.push_back(0);
    for (const Configuration& state : options.intermediate) add_stop(state, "a state to pass");
    add_stop(goal(linkage_), "the goal");
    for (int stop : stops_) must_close(states_[stop]);
    DiscreteStates discrete = discrete_states(linkage, options.discrete, options.max_states, run);
    result_.tested += discrete.tested;
    for (const Configuration& state : discrete.states)
      if (!options.frog.check_collisions || !checker_.collides(state)) add(state);
    result_.states = static_cast<long>(states_.size());
    banned_.assign(states_.size(), 0);
    passable_.assign(states_.size() * states_.size(), Passable::Unknown);
    frog_.set_patience(kPatience.front());
  }

  MdFrogResult plan() {
    while (static_cast<int>(result_.paths.size()) < options_.alternatives) {
      const std::optional<std::vector<int>> way = next_way();
      if (!way) {
        result_.ending = run_.over() ? run_.ending() : Ending::Exhausted;
        return std::move(result_);
      }
      MdFrogPath path = assemble(*way);
      if (options_.refute)
        if (const std::optional<double> time = options_.refute(path.path)) {
          remove_connection_at(path, *time);
          if (++result_.refuted > options_.max_refuted) break;
          continue;
        }
      const bool is_new = std::none_of(result_.paths.begin(), result_.paths.end(),
                                       [&](const MdFrogPath& other) { return blends(other.path, path.path); });
      if (is_new) result_.paths.push_back(std::move(path));
      if (!leave(*way)) break;
    }
    result_.ending =
        static_cast<int>(result_.paths.size()) == options_.alternatives ? Ending::Found : Ending::Exhausted;
    return std::move(result_);
  }

 private:
  int num_states() const { return static_cast<int>(states_.size()); }

  int add(const Configuration& state) {
    for (int i = 0; i < num_states(); ++i)
      if ((states_[i] - state).cwiseAbs().maxCoeff() < 1e-9) return i;
    states_.push_back(state);
    return num_states() - 1;
  }

  void add_stop(const Configuration& state, const char* what) {
    require_within_limits(linkage_, state, what);
    stops_.push_back(add(state));
  }

  void must_close(const Configuration& state) {
    if (vertices_.empty()) return;
    const Closure closed = closure(vertices_, state);
    if (closed.worst > 1e-9)
      throw InvalidInput("origami/goal-open",
                         fmt::format("the sheet cannot take this form: it stays open by {:.3g} rad", closed.worst),
                         fmt::format("vertex {}", closed.worst_vertex),
                         "plico origami info shows which vertices close");
  }

  // How panels lie on each other in a state depends on the way that leads there. So what is searched is a graph of
  // states together with their order of layers, as far as it has been seen.
  struct Node {
    int state;
    int leg;       // to the stop after this
    Sides layers;  // of stacked_[state]
    int before;    // node, -1: the start
    double cost;
    int depth;
  };
  struct Arc {  // to a state that may be next
    long estimate;
    int depth;
    float length;
    int node, to;
    // The next is the one of least estimate; of those the one that goes on from the deepest node, by a small step.
    bool operator<(const Arc& o) const {
      return std::tuple(estimate, -depth, length, node, to) > std::tuple(o.estimate, -o.depth, o.length, o.node, o.to);
    }
  };
  using Passage = std::tuple<int, int, Sides, int>;  // leg, state, layers, next state

  // A way through all stops whose every connection holds; nothing when there is none, or the run is over.
  std::optional<std::vector<int>> next_way() {
    do {
      if (std::optional<std::vector<int>> way = search()) return way;
    } while (!over() && try_harder());
    return {};
  }

  bool over() const { return run_.over() || result_.connections_tried > options_.max_connections; }

  std::optional<std::vector<int>> search() {
    nodes_.clear();
    seen_.clear();
    open_ = {};
    if (enter({stops_.front(), 0, layers_at(stops_.front()), -1, 0, 0})) return way_to();
    while (!open_.empty() && !over() && nodes_.size() < kMostNodes) {
      const Arc arc = open_.top();
      open_.pop();
      const Node from = nodes_[arc.node];
      if (left_.count({from.leg, from.state, from.layers, arc.to}) > 0 || !connected(from.state, arc.to)) continue;
      const std::optional<Sides> layers = layers_after(from, arc.to);
      if (!layers) continue;
      if (enter({arc.to, from.leg, *layers, arc.node, from.cost + arc.length, from.depth + 1})) return way_to();
      run_.report("planning", result_.connections_tried, 0);
    }
    return {};
  }

  // True at the last stop.
  bool enter(Node node) {
    const int last = static_cast<int>(stops_.size()) - 1;
    while (node.leg < last && node.state == stops_[node.leg + 1]) ++node.leg;
    if (!seen_.insert({node.leg, node.state, node.layers}).second) return false;
    const int id = static_cast<int>(nodes_.size());
    if (node.leg < last) {
      const int stop = stops_[node.leg + 1];
      for (int to = 0; to < num_states(); ++to) {
        if (to == node.state || (banned_[to] && to != stop) || passable(node.state, to) == Passable::No ||
            passable(node.state, to) == Passable::Left)
          continue;
        const float length = measure(node.state, to);
        const double estimate = node.cost + length + measure(to, stop);
        open_.push({std::lround(kEstimate * estimate), node.depth, length, id, to});
      }
    }
    nodes_.push_back(std::move(node));
    return nodes_.back().leg == last;
  }

  std::vector<int> way_to() const {
    std::vector<int> way;
    for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; i = nodes_[i].before) way.push_back(nodes_[i].state);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const std::vector<LayerPair>& stacked(int state) {
    const auto known = stacked_.find(state);
    return known != stacked_.end() ? known->second
                                   : stacked_.emplace(state, layers_.stacked(states_[state])).first->second;
  }
  Sides layers_at(int state) { return Sides(stacked(state).size(), 0); }

  // Nothing when panels would leave each other on another side than the one that they lie on.
  std::optional<Sides> layers_after(const Node& from, int to) {
    const std::vector<LayerPair>&before = stacked(from.state), &after = stacked(to);
    const std::vector<Waypoint>& waypoints = links_.at({from.state, to}).path.waypoints;
    PLICO_ASSERT(waypoints.size() >= 2 && from.layers.size() == before.size());
    const Sides leaving = layers_.sides(before, waypoints[1].config);
    for (std::size_t i = 0; i < before.size(); ++i)
      if (leaving[i] * from.layers[i] < 0) return {};
    Sides result = layers_.sides(after, waypoints[waypoints.size() - 2].config);
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (result[i] != 0) continue;
      const auto same = std::find_if(before.begin(), before.end(), [&](const LayerPair& pair) {
        return pair.a == after[i].a && pair.b == after[i].b;
      });
      if (same != before.end()) result[i] = from.layers[same - before.begin()];
    }
    return result;
  }

  // The next round: connections that failed are worth another look.
  bool try_harder() {
    if (++round_ >= kPatience.size()) return false;
    frog_.set_patience(kPatience[round_]);
    for (Passable& passable : passable_)
      if (passable == Passable::No) passable = Passable::Unknown;
    return true;
  }

  float measure(int a, int b) const { return static_cast<float>((states_[a] - states_[b]).squaredNorm()); }

  enum class Passable : char { Unknown, Yes, No, Left };  // Left: given up on purpose, for another path
  Passable passable(int from, int to) const { return passable_[static_cast<std::size_t>(from) * states_.size() + to]; }
  void set_passable(int from, int to, Passable passable) {
    for (const auto& [a, b] : {Edge{from, to}, Edge{to, from}})
      passable_[static_cast<std::size_t>(a) * states_.size() + b] = passable;
  }

  struct Link {
    FoldingPath path;  // empty when the connection failed
    Connection connection = Connection::Linear;
  };

  bool connected(int from, int to) {
    if (passable(from, to) != Passable::Unknown) return passable(from, to) == Passable::Yes;
    ++result_.connections_tried;
    Link link = connect(from, to);
    const bool holds = !link.path.waypoints.empty() && refine(link.path);
    set_passable(from, to, holds ? Passable::Yes : Passable::No);
    if (!holds) return false;
    Link back{{}, link.connection};
    for (auto w = link.path.waypoints.rbegin(); w != link.path.waypoints.rend(); ++w)
      back.path.waypoints.push_back({1 - w->time, w->config});
    links_[{to, from}] = std::move(back);
    links_[{from, to}] = std::move(link);
    return true;
  }

  Link connect(int from, int to) {
    if (std::optional<FoldingPath> path = linear(states_[from], states_[to]))
      return {std::move(*path), Connection::Linear};
    FrogResult found = frog_.plan(states_[from], states_[to], run_);
    result_.samples += found.counts.sampled;
    result_.tested += found.counts.tested;
    if (found.ending != Ending::Found) return {};
    result_.worst_residual = std::max(result_.worst_residual, found.worst_residual);
    return {std::move(found.path), Connection::Nonlinear};
  }

  // Adds waypoints that close; false when there are none, or they collide.
  bool refine(FoldingPath& path) {
    std::vector<Waypoint> fine = {path.waypoints.front()};
    for (std::size_t i = 1; i < path.waypoints.size(); ++i) {
      const Waypoint &from = path.waypoints[i - 1], &to = path.waypoints[i];
      const Configuration move = to.config - from.config;
      const int steps = std::max(1, static_cast<int>(std::ceil(move.norm() / kResolution)));
      for (int k = 1; k < steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        const Configuration start = from.config + share * move;
        const Projection between = projector_.project(start, projection_);
        result_.tested += between.steps + 1;
        if (!between.closed || (between.config - start).norm() > kResolution) return false;
        if (options_.frog.check_collisions && checker_.collides(between.config)) return false;
        result_.worst_residual = std::max(result_.worst_residual, between.closure.worst);
        fine.push_back({from.time + share * (to.time - from.time), between.config});
      }
      fine.push_back(to);
    }
    path.waypoints = std::move(fine);
    return true;
  }

  // The middle first: where a connection fails, it mostly fails there.
  std::optional<FoldingPath> linear(const Configuration& from, const Configuration& to) {
    const int n = options_.linear_samples;
    double worst = 0;
    for (int stride = static_cast<int>(std::bit_floor(static_cast<unsigned>(n))); stride >= 1; stride /= 2) {
      for (int i = stride; i <= n; i += 2 * stride) {
        const double share = static_cast<double>(i) / (n + 1);
        const Configuration between = (1 - share) * from + share * to;
        ++result_.samples;
        ++result_.tested;
        const double open = vertices_.empty() ? 0 : closure(vertices_, between).worst;
        if (open > 1e-9) return {};
        worst = std::max(worst, open);
        if (options_.frog.check_collisions && checker_.collides(between)) return {};
      }
    }
    result_.worst_residual = std::max(result_.worst_residual, worst);
    return FoldingPath{{{0, from}, {1, to}}};
  }

  MdFrogPath assemble(const std::vector<int>& way) {
    MdFrogPath result;
    std::vector<Waypoint>& waypoints = result.path.waypoints;
    waypoints.push_back({0, states_[way.front()]});
    result.states.push_back(states_[way.front()]);
    result.times.push_back(0);
    double length = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
      const Link& link = links_.at({way[i - 1], way[i]});
      for (std::size_t w = 1; w < link.path.waypoints.size(); ++w) {
        const Configuration& config = link.path.waypoints[w].config;
        length += (config - waypoints.back().config).norm();
        waypoints.push_back({length, config});
      }
      result.states.push_back(states_[way[i]]);
      result.times.push_back(length);
      result.connections.push_back(link.connection);
    }
    if (waypoints.size() == 1) waypoints.push_back({1, waypoints.front().config}), length = 1;  // a goal that is flat
    for (Waypoint& waypoint : waypoints) waypoint.time /= length;
    for (double& time : result.times) time /= length;
    waypoints.back().time = 1;
    return result;
  }

  // Can one be bent into the other by averaging? Each average is made foldable first.
  bool blends(const FoldingPath& a, const FoldingPath& b) {
    constexpr int kSamples = 20;
    for (int i = 1; i < kSamples; ++i) {
      const Configuration p = a.at(i / double{kSamples}), q = b.at(i / double{kSamples});
      const Projection mid =
          projector_.project((p + q) / 2, {.tolerance = 1e-9, .low = projection_.low, .high = projection_.high});
      const bool between = (mid.config - (p + q) / 2).norm() <= (p - q).norm() / 2 + 1e-9;
      if (!mid.closed || !between || checker_.collides(mid.config)) return false;
    }
    return true;
  }

  // The passage that fails is not to be taken again from a state with these layers.
  void remove_connection_at(const MdFrogPath& path, double time) {
    const auto end = std::upper_bound(path.times.begin() + 1, path.times.end() - 1, time) - path.times.begin();
    int at = static_cast<int>(nodes_.size()) - 1;
    for (auto left = static_cast<std::ptrdiff_t>(path.times.size()) - 1; left > end; --left) at = nodes_[at].before;
    PLICO_ASSERT(nodes_[at].before >= 0);
    const Node& from = nodes_[nodes_[at].before];
    left_.insert({from.leg, from.state, from.layers, nodes_[at].state});
  }

  // Makes the next way another one: the states in between are not to be used again; a direct way has none to avoid.
  bool leave(const std::vector<int>& way) {
    bool left = false;
    for (int i : way) {
      if (std::find(stops_.begin(), stops_.end(), i) != stops_.end() || banned_[i]) continue;
      banned_[i] = 1;
      left = true;
    }
    if (!left) {
      for (std::size_t i = 1; i < way.size(); ++i) set_passable(way[i - 1], way[i], Passable::Left);
      left = way.size() > 1;
    }
    return left;
  }

  const MdFrogOptions& options_;
  const Run& run_;
  const Linkage& linkage_;
  const std::vector<RealVertex>& vertices_;
  Projector projector_;
  ProjectOptions projection_;
  CollisionChecker checker_;
  Layers layers_;
  Frog frog_;
  std::vector<Configuration> states_;
  std::vector<int> stops_;
  std::vector<char> banned_;                       // states that a further path must not use
  std::vector<Passable> passable_;                 // of each connection, states x states
  std::map<int, std::vector<LayerPair>> stacked_;  // of each state looked at
  std::vector<Node> nodes_;
  std::set<std::tuple<int, int, Sides>> seen_;
  std::priority_queue<Arc> open_;
  std::set<Passage> left_;      // refuted
  std::map<Edge, Link> links_;  // those that hold, both ways
  std::size_t round_ = 0;       // of kPatience
  MdFrogResult result_;
};

}  // namespace

MdFrogResult md_frog(const Linkage& linkage, const MdFrogOptions& options, const Run& run) {
  check(options);
  require_closable(linkage);
  return Roadmap(linkage, options, run).plan();
}

}  // namespace plico
