// The plane between two overlapping convex bodies, by the dissertation's three methods and by a full search.
#pragma once
#include <cstdint>
#include <string_view>

#include "plico/base/rng.h"
#include "plico/convex/cut_loss.h"

namespace plico {

// How a cut plane is found.
//   Lsf        least squares through the points where the two boundaries cross ([Xi17] 5.3.1)
//   Svm        soft-margin support vector machine on samples of both bodies ([Xi17] 5.3.2)
//   SvmOffset  the normal of Svm with the offset of least loss ("exact", [Xi17] eq. 5.6)
//   Full       the least loss over normal and offset (R10)
enum class CutMethod { Lsf, Svm, SvmOffset, Full };
std::string_view name(CutMethod method);  // "lsf", "svm", "svm-offset", "full"

struct SvmOptions {
  int samples = 2000;    // of both bodies together, at equal density; at least 10
  double penalty = 100;  // of a sample on the wrong side, with the union scaled to volume 100
};

// Volumes that must be left of either body; planes that leave less are taken only when no other is found.
struct CutFloor {
  double first = 0, second = 0;
};

// The two bodies must overlap (otherwise: separating_plane). Deterministic; `rng` is drawn from by Svm and SvmOffset
// only.
//   Full tries six normals both ways round: least squares, line of the centroids, vector area of the loop in which the
//   boundaries cross, principal axes of the overlap; 16 offsets each; then Newton steps in a trust region. At its
//   result both cross-sections have the same area and centroid, unless the plane holds an edge. About 200 evaluations.
Plane cut_plane(const CutPair& pair, CutMethod method, Rng& rng, const SvmOptions& svm = {});
Plane full_cut(const CutPair& pair, const CutFloor& floor = {});

// Newton in a trust region from one plane; never worse than it.
Plane polished_cut(const CutPair& pair, const Plane& start);

// The best offset for one normal: roots of the derivative, a quadratic between neighbouring vertices. O(corners^2).
Plane best_offset(const CutPair& pair, const Vec3& normal);

}  // namespace plico
