// Disjoint convex shells: one convex piece for every part of a shape, no two of which share an interior point.
// [Xi17] chapter 5 with its open end closed: the planes between the parts are optimized in all degrees of freedom.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plico/base/run.h"
#include "plico/convex/pair_cut.h"
#include "plico/geom/convex3.h"

namespace plico {

// A part of a shape. Only its points matter: faces may overlap, be open, missing or turned over.
struct ShapePart {
  std::string name;
  std::vector<Vec3> points;
};

// What happens to a part that lies inside the hull of a larger one by at least `nested_share` of its volume.
enum class NestedPolicy { Drop, Merge, Keep };
std::string_view name(NestedPolicy policy);  // "drop", "merge", "keep"

struct ShellOptions {
  std::uint64_t seed = 1;  // of the samples of the SVM methods
  CutMethod method = CutMethod::Full;
  SvmOptions svm = {};
  NestedPolicy nested = NestedPolicy::Drop;
  double nested_share = 0.9;              // in (0, 1]
  double least_kept = 0.1;                // of each hull's volume, after all cuts; Full only; in [0, 1)
  std::vector<std::string> protect = {};  // names of parts whose lost volume counts four times; Full only
  int max_sweeps = 20;  // over all pairs, each seen trimmed by all other planes; Full only; at least 0
};

struct Shell {
  int part = 0;           // in the input
  ConvexPolyhedron body;  // a hull: convex exactly
  double hull_volume = 0, kept_volume = 0;
};

// Two shells whose hulls overlapped or came close, and the plane that keeps them apart: every point of `first` lies
// strictly below it and every point of `second` strictly above, exactly.
struct ShellContact {
  int first = 0, second = 0;  // numbers of shells
  Plane plane;
  bool cut = false;           // the hulls overlapped
  std::vector<Vec3> polygon;  // where the two shells touch (within 1e-7 of the diagonal), counter-clockwise seen from
                              // above the plane; empty when they do not
};

struct Shells {
  Ending ending = Ending::Found;       // TimedOut, Stopped: disjoint, but planes were not optimized to the end
  std::vector<Shell> shells;           // in the order of their parts
  std::vector<ShellContact> contacts;  // of all pairs whose boxes meet
  std::vector<int> lost;               // parts of which nothing is left after the cuts
  std::vector<int> nested;             // parts dropped or merged
  std::vector<int> hosts;              // the part that each of `nested` lies in
  double union_volume = 0;             // of the hulls of all parts (merged where parts were merged)
  double shell_volume = 0;
  int sweeps = 0;

  double loss() const { return union_volume > 0 ? (union_volume - shell_volume) / union_volume : 0; }  // [Xi17] eq. 5.8
  double least_kept() const;  // the smallest kept fraction of a hull that was cut; 0 when a part is lost, 1 at most
};

// Laws: the volume of all shells never shrinks from sweep to sweep; shells are disjoint after each. A shell lies in the
// hull of its part (of the merged parts). The result does not depend on the number of threads.
// Throws InvalidInput naming the part when it has fewer than 4 points that span space, a coordinate that is not finite,
// or more than kMaxParts parts are given; InvalidOption for a protected name that no part has.
// O(pairs * facets) for the boxes' pairs, and some hundred times that for pairs that overlap.
Shells disjoint_shells(const std::vector<ShapePart>& parts, const ShellOptions& options = {}, const Run& run = {});

constexpr int kMaxParts = 2000;

void check(const ShellOptions& options);  // throws InvalidOption naming field, value and range

}  // namespace plico
