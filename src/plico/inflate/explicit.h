// The dissertation's own way to inflate: forces added up step by step. Source: [Xi17] eqs. 4.1-4.9, read as R8.
#pragma once
#include "plico/inflate/inflate.h"
#include "plico/inflate/obstacles.h"

namespace plico {

// P += dt f at options.pressure (1 where that is 0), until growth, hyperbolic vertices or steps end it, or the mesh
// bursts: the step is too long for the stiffest springs, or pressure too high for any. Pressure pushes a vertex along
// the sum of its faces' normals, each weighted by the angle at the vertex. The mesh is one that inflate() takes, and
// outlives this.
class ExplicitInflation {
 public:
  ExplicitInflation(const Mesh& mesh, const InflateOptions& options);

  // Ten steps, fewer where something ends it, and then a look at the whole mesh; false when there is nothing left to
  // do. O(n log n).
  bool advance(const Run& run = {});
  // As it is after the last look that found nothing wrong; the fields that inflate() adds are not filled.
  const Inflation& result() const { return result_; }
  const Mesh& mesh() const { return now_; }                            // with the points of result()
  const std::vector<char>& hyperbolic() const { return hyperbolic_; }  // of each vertex of mesh()
  bool ended() const { return ended_; }

 private:
  void look(const Run& run);
  void end(InflateLimit limit);

  const Mesh& mesh_;
  InflateOptions options_;
  SkinEnergy energy_;
  Obstacles obstacles_;
  Eigen::VectorXd x_, gradient_;
  Mesh now_;
  Eigen::VectorXd pressure_;  // on each vertex of it
  std::vector<char> hyperbolic_;
  Inflation result_;
  bool ended_ = false;
};

// All of it. O(steps n).
Inflation integrate(const Mesh& mesh, const InflateOptions& options, const Run& run);

}  // namespace plico
