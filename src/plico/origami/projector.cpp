#include "plico/origami/projector.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "plico/base/error.h"
#include "plico/origami/loop_walk.h"

namespace plico {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

struct Limits {
  Configuration low, high;

  Configuration clamp(const Configuration& config) const { return config.cwiseMax(low).cwiseMin(high); }
  bool held(int h) const { return low[h] >= high[h]; }
  // Would a move from `at` along `step` leave the limits at once?
  bool blocks(int h, double at, double step) const { return (step < 0 && at <= low[h]) || (step > 0 && at >= high[h]); }
};

Limits limits_of(const ProjectOptions& options, int num_creases) {
  const auto fill = [&](const Configuration& given, double otherwise) {
    if (given.size() == 0) return Configuration(Configuration::Constant(num_creases, otherwise));
    if (given.size() == num_creases) return given;
    throw InvalidInput("origami/limits", fmt::format("{} limits for {} creases", given.size(), num_creases));
  };
  return {fill(options.low, -kPi), fill(options.high, kPi)};
}

Configuration damping_of(const ProjectOptions& options, int num_creases) {
  if (options.weight.size() == 0) return Configuration::Constant(num_creases, options.damping);
  if (options.weight.size() == num_creases) return options.damping * options.weight;
  throw InvalidInput("origami/weights", fmt::format("{} weights for {} creases", options.weight.size(), num_creases));
}

void check(const ProjectOptions& o) {
  require(o.tolerance > 0, "tolerance", o.tolerance, "above 0");
  require(o.max_step > 0, "max step", o.max_step, "above 0");
  require(o.damping > 0, "damping", o.damping, "above 0");
  require(o.most_turn > 0, "most turn", o.most_turn, "above 0");
  if (o.weight.size() > 0) require(o.weight.minCoeff() > 0, "weight", o.weight.minCoeff(), "above 0");
}

}  // namespace

// Residual, Jacobian by columns and normal matrix of all loops. Entry k of loop l is its k-th crease.
class Projector::Equations {
 public:
  Equations(std::vector<RealVertex> loops, int num_creases) : loops_(std::move(loops)), num_creases_(num_creases) {
    for (const RealVertex& loop : loops_) {
      for (int h : loop.hinges)
        if (h < 0 || h >= num_creases)
          throw InvalidInput("origami/crease-index", fmt::format("crease {} of {}", h, num_creases),
                             fmt::format("vertex {}", loop.vertex));
      first_row_.push_back(first_row_.back() + loop.num_equations());
      first_column_.push_back(first_column_.back() + loop.num_equations() * static_cast<int>(loop.hinges.size()));
    }
    residual_.resize(first_row_.back());
    columns_.resize(first_column_.back());
    build_pattern();
  }

  const std::vector<RealVertex>& loops() const { return loops_; }
  int num_creases() const { return num_creases_; }

  double squared_residual(const Configuration& config) {
    for (std::size_t l = 0; l < loops_.size(); ++l)
      write_residual(loops_[l], walk_around(loops_[l], config, [](std::size_t, const Vec3&, const Vec3&) {}),
                     &residual_[first_row_[l]]);
    return residual_.squaredNorm();
  }

  double worst_residual() const {
    double worst = 0;
    for (std::size_t l = 0; l < loops_.size(); ++l)
      worst = std::max(worst, residual_.segment(first_row_[l], loops_[l].num_equations()).norm());
    return worst;
  }

  // The derivative at `config`.
  void linearize(const Configuration& config) {
    for (std::size_t l = 0; l < loops_.size(); ++l) write_columns(l, config);
  }

  // Of J^T J + diag(damping), with the rows and columns of held creases those of the identity.
  void factorize(const Configuration& damping, const std::vector<char>& held) {
    double* values = normal_.valuePtr();
    std::fill(values, values + normal_.nonZeros(), 0.0);
    for (int h = 0; h < num_creases_; ++h) values[diagonal_[h]] = held[h] ? 1 : damping[h];
    const int* slot = slots_.data();
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const auto& hinges = loops_[l].hinges;
      for (std::size_t i = 0; i < hinges.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j, ++slot) {
          if (held[hinges[i]] || held[hinges[j]]) continue;
          const double product = column(l, i).dot(column(l, j));
          values[*slot] += i != j && hinges[i] == hinges[j] ? 2 * product : product;
        }
    }
    solver_.factorize(normal_);
  }

  Configuration solve(const Configuration& right) const { return solver_.solve(right); }

  Configuration gradient() const { return transposed_times(residual_); }

  // J^T J times a direction.
  Configuration normal_times(const Configuration& direction) const {
    Eigen::VectorXd image = Eigen::VectorXd::Zero(residual_.size());
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t k = 0; k < loops_[l].hinges.size(); ++k)
        image.segment(first_row_[l], loops_[l].num_equations()) += direction[loops_[l].hinges[k]] * column(l, k);
    return transposed_times(image);
  }

 private:
  Eigen::Map<const Eigen::VectorXd> column(std::size_t l, std::size_t k) const {
    const int rows = loops_[l].num_equations();
    return {&columns_[first_column_[l] + rows * static_cast<int>(k)], rows};
  }

  void write_columns(std::size_t l, const Configuration& config) {
    const RealVertex& loop = loops_[l];
    const int rows = loop.num_equations();
    double* out = &columns_[first_column_[l]];
    const Walk end = walk_around(loop, config, [&](std::size_t k, const Vec3& axis, const Vec3& point) {
      Eigen::Map<Vec3>(out + rows * k) = axis;
      if (loop.is_hole()) Eigen::Map<Vec3>(out + rows * k + 3) = point;
    });
    if (!loop.is_hole()) return;
    for (std::size_t k = 0; k < loop.hinges.size(); ++k) {  // velocity of the walk's end when it turns about the axis
      Eigen::Map<Vec3> axis(out + rows * k), point(out + rows * k + 3);
      point = axis.cross(end.shift - point).eval();
    }
  }

  Configuration transposed_times(const Eigen::VectorXd& rows) const {
    Configuration result = Configuration::Zero(num_creases_);
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t k = 0; k < loops_[l].hinges.size(); ++k)
        result[loops_[l].hinges[k]] += column(l, k).dot(rows.segment(first_row_[l], loops_[l].num_equations()));
    return result;
  }

  // Lower half of J^T J: a slot of its values for every pair of entries of a loop, so that filling needs no search.
  void build_pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    for (int h = 0; h < num_creases_; ++h) entries.emplace_back(h, h, 1);
    for_pairs([&](int row, int col) { entries.emplace_back(row, col, 1); });
    normal_.resize(num_creases_, num_creases_);
    normal_.setFromTriplets(entries.begin(), entries.end());
    const auto slot = [&](int row, int col) {
      const int *begin = normal_.innerIndexPtr() + normal_.outerIndexPtr()[col],
                *end = normal_.innerIndexPtr() + normal_.outerIndexPtr()[col + 1];
      return static_cast<int>(std::lower_bound(begin, end, row) - normal_.innerIndexPtr());
    };
    for (int h = 0; h < num_creases_; ++h) diagonal_.push_back(slot(h, h));
    for_pairs([&](int row, int col) { slots_.push_back(slot(row, col)); });
    solver_.analyzePattern(normal_);
  }

  template <class Visit>
  void for_pairs(Visit visit) const {
    for (const RealVertex& loop : loops_)
      for (std::size_t i = 0; i < loop.hinges.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
          const auto [low, high] = std::minmax(loop.hinges[i], loop.hinges[j]);
          visit(high, low);
        }
  }

  std::vector<RealVertex> loops_;
  int num_creases_;
  std::vector<int> first_row_ = {0}, first_column_ = {0};  // per loop
  Eigen::VectorXd residual_;
  std::vector<double> columns_;
  Sparse normal_;
  std::vector<int> diagonal_, slots_;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> solver_;
};

namespace {

// Solves (J^T J + diag(damping)) x = `right(held)` and makes a step of x, holding the creases that would leave their
// limits at once.
template <class Equations, class Right, class Step>
Configuration solve_within(Equations& equations, const Limits& limits, const Configuration& at,
                           const Configuration& damping, const Right& right, const Step& step,
                           std::vector<char>& held) {
  equations.linearize(at);
  held.assign(at.size(), 0);
  for (int h = 0; h < at.size(); ++h) held[h] = limits.held(h) ? 1 : 0;
  for (int round = 0;; ++round) {
    Configuration rhs = right(held);
    for (int h = 0; h < at.size(); ++h)
      if (held[h]) rhs[h] = 0;
    equations.factorize(damping, held);
    Configuration result = step(equations.solve(rhs));
    bool again = false;
    for (int h = 0; h < at.size(); ++h) {
      if (held[h]) {
        result[h] = 0;
      } else if (limits.blocks(h, at[h], result[h])) {
        held[h] = 1;
        result[h] = 0;
        again = true;
      }
    }
    if (!again || round == 3) return result;
  }
}

}  // namespace

Projector::Projector(std::vector<RealVertex> vertices, int num_creases)
    : equations_(std::make_unique<Equations>(std::move(vertices), num_creases)) {}
Projector::Projector(const Linkage& linkage) : Projector(linkage.loops, linkage.num_hinges()) {}
Projector::~Projector() = default;
Projector::Projector(Projector&&) noexcept = default;
Projector& Projector::operator=(Projector&&) noexcept = default;

const std::vector<RealVertex>& Projector::vertices() const { return equations_->loops(); }
int Projector::num_creases() const { return equations_->num_creases(); }

Projection Projector::project(const Configuration& start, const ProjectOptions& options, const Run& run) {
  check(options);
  if (start.size() != num_creases())
    throw InvalidInput("origami/too-few-angles",
                       fmt::format("{} fold angles for {} creases", start.size(), num_creases()));
  const Limits limits = limits_of(options, num_creases());
  const Configuration damping = damping_of(options, num_creases());
  Projection result;
  result.config = limits.clamp(start);
  double size = equations_->squared_residual(result.config);
  const Configuration begun = result.config;
  std::vector<char> held;
  while (equations_->worst_residual() > options.tolerance && result.steps < options.max_steps && !run.over()) {
    Configuration direction = solve_within(
        *equations_, limits, result.config, damping, [&](const std::vector<char>&) { return equations_->gradient(); },
        [](const Configuration& x) { return Configuration(-x); }, held);
    const double longest = direction.cwiseAbs().maxCoeff();
    if (longest > options.max_step) direction *= options.max_step / longest;
    ++result.steps;
    bool smaller = false;
    for (double length = 1; length > 1e-4 && !smaller; length /= 2) {
      Configuration next = limits.clamp(result.config + length * direction);
      const double next_size = equations_->squared_residual(next);
      smaller = next_size < size;
      if (smaller) {
        result.config = std::move(next);
        size = next_size;
      }
    }
    if (!smaller || (result.config - begun).cwiseAbs().maxCoeff() > options.most_turn) break;
  }
  result.closure = closure(vertices(), result.config);
  result.closed = result.closure.worst <= options.tolerance;
  return result;
}

Configuration Projector::tangent(const Configuration& at, const Configuration& direction,
                                 const ProjectOptions& options) {
  return tangents(at, direction, options);
}

Eigen::MatrixXd Projector::tangents(const Configuration& at, const Eigen::MatrixXd& directions,
                                    const ProjectOptions& options) {
  check(options);
  const Limits limits = limits_of(options, num_creases());
  std::vector<char> held;
  const auto without_held = [&](Configuration vector) {
    for (int h = 0; h < vector.size(); ++h)
      if (held[h]) vector[h] = 0;
    return vector;
  };
  Eigen::MatrixXd result(directions.rows(), directions.cols());
  for (int i = 0; i < directions.cols(); ++i) {
    const Configuration direction = directions.col(i);
    const auto right = [&](const std::vector<char>&) { return equations_->normal_times(without_held(direction)); };
    if (i == 0)
      result.col(i) = solve_within(
          *equations_, limits, at, damping_of(options, num_creases()), right,
          [&](const Configuration& x) { return Configuration(direction - x); }, held);
    else
      result.col(i) = without_held(direction - equations_->solve(without_held(right(held))));
  }
  return result;
}

std::vector<RealVertex> grouped(std::vector<RealVertex> vertices, const std::vector<int>& group,
                                const std::vector<int>& sign) {
  for (RealVertex& vertex : vertices)
    for (std::size_t k = 0; k < vertex.hinges.size(); ++k) {
      const auto h = static_cast<std::size_t>(vertex.hinges[k]);
      if (h >= group.size() || h >= sign.size())
        throw InvalidInput("origami/crease-index", fmt::format("crease {} of {} has no group", h, group.size()),
                           fmt::format("vertex {}", vertex.vertex));
      vertex.hinges[k] = group[h];
      vertex.directions[k] *= sign[h];  // a turn backwards is a turn about the axis reversed
    }
  return vertices;
}

Projection project(const std::vector<RealVertex>& vertices, const Configuration& start, const ProjectOptions& options) {
  return Projector(vertices, static_cast<int>(start.size())).project(start, options);
}

}  // namespace plico
