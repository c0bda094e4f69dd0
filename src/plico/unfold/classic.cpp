#include "plico/unfold/classic.h"

#include <limits>

#include "plico/base/error.h"
#include "plico/unfold/by_component.h"
#include "plico/unfold/overlap.h"
#include "plico/unfold/parts.h"

namespace plico {

void check(const ClassicOptions& options) {
  if (options.directions < 1)
    throw InvalidOption(fmt::format("directions = {} must be at least 1", options.directions));
}

ClassicResult classic_net(const Mesh& mesh, const ClassicOptions& options, const Run& run) {
  check(options);
  ClassicResult result;
  result.ending = Ending::Found;
  result.forest = by_component(mesh, [&](const Submesh& part, int c) {
    const FlatFaces faces(part.mesh);
    const Rng rng = Rng(options.seed).stream(c);
    FoldForest best;
    int fewest = std::numeric_limits<int>::max();
    for (int i = 0; i < options.directions && fewest > 0 && (i == 0 || !run.over()); ++i) {
      Rng own = rng.stream(i);
      const Vec3 direction = random_direction(own);
      FoldForest tree = lightest_forest(part.mesh, dual_weights(part.mesh, options.heuristic, direction, own));
      const int overlaps = static_cast<int>(overlapping_pairs(faces, lay_panels(faces, tree)).size());
      if (overlaps >= fewest) continue;
      fewest = overlaps;
      best = std::move(tree);
    }
    result.overlaps += fewest;
    if (fewest > 0) result.ending = run.over() ? run.ending() : Ending::Exhausted;
    return part_overlaps(faces, best);
  });
  result.parts = count_parts(mesh, result.forest);
  return result;
}

}  // namespace plico
