// The energy of a skin of springs around a sealed amount of air. Source: [Xi17] 4.4.1, eqs. 4.1-4.9, read as R8.
#pragma once
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

// What pulls back, and how much, in units in which the mean edge is 1 long and a spring of stiffness 1 pulls with 1.
struct SkinOptions {
  bool constrained = true;         // eqs. 4.6-4.9; otherwise eqs. 4.1-4.5
  double edge_stiffness = 1;       // E_e, above 0
  double stiff_edges = 10;         // lambda_se: how much stiffer convex and deep concave edges are, at least 1
  double deep_angle = 1.2;         // radians: a valley that folds by more is deep, kept as a feature
  double anchor_stiffness = 0.05;  // E_v: springs to where a vertex was, at least 0
  double stiff_anchors = 10;       // lambda_sv: how much stiffer these are where a vertex is not hyperbolic, at least 1
  // How strongly the excess of the angle sum above 2 pi is pressed out, against pressure; 0 as in the dissertation.
  double flattening = 1;
};
void check(const SkinOptions& options);  // throws InvalidOption

std::vector<char> hyperbolic_vertices(const Mesh& mesh);  // of each whether it is; O(n)
int count_hyperbolic(const std::vector<char>& hyperbolic);

// Sum of (L - L0)^2 E / 2 over stretched edges, |x - P|^2 E_v / 2 over vertices, and pressure times
//   - V0 log(V / V0): a sealed amount of air, whose pressure falls as 1 / V, so that every pressure has its minimum
//     (with eq. 4.1's constant pressure the energy -p V falls faster than springs rise, and the skin bursts);
//   - 200 V0 (how far |V / V0 - 1| exceeds the room of hold_volume())^2 max(1, flattening): neither air nor flattening
//     alone keeps a volume, air lets it grow and flattening thin limbs shrink;
//   - flattening times the sum of w (angle sum - 2 pi)^2 over hyperbolic vertices, where w is smaller the larger the
//     excess was at the last classify(): those that are nearly flat go first.
class SkinEnergy {
 public:
  // A closed triangle mesh of positive volume; vertices of `kept` faces do not move.
  SkinEnergy(const Mesh& mesh, const SkinOptions& options, const std::vector<FaceId>& kept);

  // Which edges and anchors are stiff, by the shape as it is now and which of its vertices are hyperbolic (eqs. 4.6
  // and 4.8).
  void classify(const Mesh& now, const std::vector<char>& hyperbolic);
  // From here on the volume changes freely by this share of it, and is pushed back the more beyond. O(1).
  void hold_volume(double room) { room_ = room; }
  void fix(VertexId v) { fixed_[v] = 1; }
  bool is_fixed(VertexId v) const { return fixed_[v] != 0; }

  Eigen::VectorXd only_free(Eigen::VectorXd forces) const;  // forces on fixed vertices become 0

  double unit() const { return unit_; }  // the mean edge, in the mesh's unit
  Eigen::VectorXd start() const { return origin_; }
  // 3 n numbers in units of the mean edge, infinite where the volume is not positive. O(n).
  double operator()(double pressure, const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;
  double volume(const Eigen::VectorXd& x) const;  // in cubes of unit()
  double start_volume() const { return volume_; }
  std::vector<Vec3> points(const Eigen::VectorXd& x) const;  // in the mesh's unit; kept exactly where nothing moved

 private:
  double springs(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;
  double anchors(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;
  double air(const Eigen::VectorXd& x, double pressure, Eigen::VectorXd& gradient) const;
  double excess(const Eigen::VectorXd& x, double weight, Eigen::VectorXd& gradient) const;
  Vec3 corner(const Eigen::VectorXd& x, int face, int i) const { return x.segment<3>(3 * triangles_[3 * face + i]); }

  SkinOptions options_;
  double unit_ = 1, volume_ = 0, room_ = std::numeric_limits<double>::infinity();
  Vec3 center_;
  Eigen::VectorXd origin_;
  std::vector<Vec3> points_;           // as they were given, to the last bit
  std::vector<int> triangles_, ends_;  // 3 a face, 2 an edge
  std::vector<double> rest_, edge_stiffness_, anchor_stiffness_, flatten_;
  std::vector<char> fixed_;
};

}  // namespace plico
