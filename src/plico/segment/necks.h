// Where a shape is narrow: cuts that take a limb off, short, hidden in valleys, and with much on both sides.
#pragma once
#include <optional>
#include <vector>

#include "plico/base/run.h"
#include "plico/segment/dual_graph.h"

namespace plico {

struct NeckOptions {
  double min_area = 0.008;  // of the smaller side, as a share of the whole mesh; in [0, 0.5]
  int eigenvectors = 13;    // that are swept; at least 1
  int refined = 12;         // cuts of the sweeps that are refined by a minimum cut; at least 1
  double area_power = 0.6;  // of the smaller side's area in the score; in [0, 1]
};
void check(const NeckOptions& options);  // throws InvalidOption naming field, value and range

// A cut of a part in two connected sides.
struct Neck {
  std::vector<int> side;  // the faces of the smaller side, ascending
  double cost = 0;        // of the seam (DualGraph), units
  double score = 0;  // cost over area of the smaller side to the power above, both for a mesh of area 1: small is good
};

// The best cut found of `faces`, which must be connected; none when no cut leaves both sides large enough. Sweeps of
// low eigenvectors give cuts, each is replaced by the minimum cut in a band around it. Nearly linear.
std::optional<Neck> best_neck(const DualGraph& graph, const std::vector<int>& faces, const NeckOptions& options = {});

struct NeckCutOptions {
  double worst_score = 0.8;  // no cut scores this or more; infinity: cut as long as there are cuts
  int max_parts = 12;        // at least 1
  NeckOptions neck;
};

// Cuts the parts that are there (`part` of each face, 0..k-1, connected) at the best neck of any of them, again and
// again. Returns the part of each face; parts keep their number on the larger side. A run that is over leaves fewer
// parts.
std::vector<int> cut_at_necks(const DualGraph& graph, std::vector<int> part, const NeckCutOptions& options = {},
                              const Run& run = {});

// Judges a cut: `side` and the rest of `faces`. What hangs loose of either side goes to the other until both are
// connected; none when a side is empty or too small.
std::optional<Neck> neck_at(const DualGraph& graph, const std::vector<int>& faces, const std::vector<int>& side,
                            const NeckOptions& options);

// The same cut with its seam where that is cheapest, within a band around it.
std::optional<Neck> smoothed_neck(const DualGraph& graph, const std::vector<int>& faces, const std::vector<int>& side,
                                  const NeckOptions& options);

}  // namespace plico
