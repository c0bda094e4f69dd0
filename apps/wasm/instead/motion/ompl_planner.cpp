// Instead of OMPL, which would be a third of the module: no planning.
#include "plico/base/error.h"
#include "plico/motion/planner.h"

namespace plico {

bool has_planners() { return false; }
void silence_planners() {}

PlannedPath plan_path(const Linkage&, const PlannerOptions& options, const Run&) {
  check(options);
  throw InvalidOption(fmt::format("planner {} is not in this build", name(options.planner)),
                      "use the program on a computer: plico fold");
}

}  // namespace plico
