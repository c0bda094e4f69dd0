// The foldable configuration near a given one.
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "plico/base/run.h"
#include "plico/origami/closure.h"

namespace plico {

struct ProjectOptions {
  double tolerance = 1e-13;  // radians, of the worst residual; above 0
  double max_step = 0.3;     // radians a fold angle may move in one step; above 0
  double damping = 1e-9;     // added to the diagonal of J^T J; above 0
  int max_steps = 60;
  double most_turn = std::numeric_limits<double>::infinity();  // radians from the start; farther ends the search
  // Limits of each fold angle, radians, or empty for [-pi, pi]. A crease with low = high is held there.
  Configuration low = {}, high = {};
  // How dear a turn of each crease is, above 0, or empty for 1: "nearest" is least in the sum of weight * turn^2.
  Configuration weight = {};
};

struct Projection {
  Configuration config;  // the best found, within the limits
  Closure closure;       // of it
  int steps = 0;
  bool closed = false;  // the tolerance was reached
};

// Projects to the configurations in which every real vertex and hole of one sheet closes, by damped Gauss-Newton
// (J^T J + damping I): three rows a real vertex (the column of a crease is its direction turned by the walk so far),
// six a hole. A step that makes the residual grow is halved; a crease that pushes against its limit is held there.
// The sparsity pattern and its symbolic factorization are made once. The flat state is a branch point: what lies near
// it is found, but on no particular branch. Deterministic; one thread at a time.
class Projector {
 public:
  // Throws InvalidInput when a vertex names a crease outside [0, num_creases).
  Projector(std::vector<RealVertex> vertices, int num_creases);
  explicit Projector(const Linkage& linkage);
  explicit Projector(const CreasePattern& sheet) : Projector(make_linkage(sheet)) {}
  ~Projector();
  Projector(Projector&&) noexcept;
  Projector& operator=(Projector&&) noexcept;

  const std::vector<RealVertex>& vertices() const;
  int num_creases() const;

  // One numeric factorization a step. `start` outside the limits is clamped first. A run that is over ends the search
  // between two steps, not closed. Throws InvalidInput when sizes differ.
  Projection project(const Configuration& start, const ProjectOptions& options = {}, const Run& run = {});

  // The part of `direction` that keeps every loop closed to first order at `at`; limits hold creases as in `project`.
  Configuration tangent(const Configuration& at, const Configuration& direction, const ProjectOptions& options = {});
  // The same of several directions, one a column. The creases that the limits hold are those of the first.
  Eigen::MatrixXd tangents(const Configuration& at, const Eigen::MatrixXd& directions,
                           const ProjectOptions& options = {});

 private:
  class Equations;
  std::unique_ptr<Equations> equations_;
};

// The same loops when creases turn together: crease h by sign[h] (1 or -1) times the angle of group[h]. What a
// projector then projects is one angle per group. Throws InvalidInput when a walk needs a crease without a group.
std::vector<RealVertex> grouped(std::vector<RealVertex> vertices, const std::vector<int>& group,
                                const std::vector<int>& sign);

// Once; for many projections of one sheet keep a Projector.
Projection project(const std::vector<RealVertex>& vertices, const Configuration& start,
                   const ProjectOptions& options = {});

}  // namespace plico
