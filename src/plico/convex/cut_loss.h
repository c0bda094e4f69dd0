// What a plane cuts off two convex bodies, with its first and second derivative in all three degrees of freedom of the
// plane: the dissertation's eq. 5.1 read as R9, smooth as in R10.
#pragma once
#include "plico/geom/convex3.h"

namespace plico {

// Two bodies that one plane is to separate: `first` below it, `second` above. Not owned.
struct CutPair {
  const ConvexPolyhedron& first;
  const ConvexPolyhedron& second;
  double first_weight = 1, second_weight = 1;  // of the volume that either loses
  double first_volume = volume(first), second_volume = volume(second);
};

// A plane with axes: the points origin + x axes.col(0) + y axes.col(1).
struct PlaneFrame {
  Vec3 origin;
  Eigen::Matrix3d axes;  // columns: x, y, normal

  Plane plane() const { return {axes.col(2), axes.col(2).dot(origin)}; }
};
PlaneFrame frame_of(const Plane& plane, const Vec3& near);  // origin: the point of the plane nearest to `near`

// The plane z = t + a x + b y of the frame; derivatives are by (t, a, b) at 0.
struct CutLoss {
  double value = 0;    // weighted volume of `first` above and of `second` below
  double flipped = 0;  // the same for the plane turned over
  Vec3 gradient = Vec3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

// By Leibniz' rule: the gradient is the difference of the two cross-sections' areas and first moments, the Hessian one
// of integrals along their boundaries. Twice differentiable where the plane holds no edge. O(corners).
CutLoss cut_loss(const CutPair& pair, const PlaneFrame& frame);

}  // namespace plico
