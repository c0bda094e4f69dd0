// A net under the hands of someone: the project, how it lies on the table, and what is true of it after every edit.
// Knows nothing of JavaScript.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/verify/net.h"
#include "plico/workflow/foldable_net.h"
#include "plico/workflow/open_project.h"

namespace plico {

class Editor {
 public:
  // Throws InvalidInput as open_project() does. A mesh is unfolded at once, as `plico unfold` does.
  Editor(const std::string& bytes, const std::string& name, const Run& run = {});

  const Project& project() const { return project_; }
  const std::vector<std::string>& notes() const { return notes_; }
  const NetVerdict& verdict() const { return verdict_; }
  const Unfolding& net() const { return net_; }

  // What a click on an edge means: cut a fold; join two parts; move a branch within a part. Nothing when the edge is
  // locked, at the border, or every fold in the way is locked.
  std::optional<Edit> edit_for(int edge) const;

  Edit apply(const Edit& edit);          // returns its inverse; the net is laid flat and judged again
  Editor after(const Edit& edit) const;  // a look at what would be
  Edit search(bool folds,
              const Run& run);  // an edit that makes one net, of which a straight motion is proven if `folds`
  void arrange();               // parts side by side again

  // The corners of all faces, one face after the other, as they lie: 2 numbers a corner. An edit leaves the larger
  // pieces where they were.
  const std::vector<float>& flat_corners() const { return table_; }
  std::vector<float> mesh_corners() const;  // 3 numbers a corner

  // The net's straight motion, or the one that was planned, at a time in [0, 1]: 3 numbers a corner.
  const std::vector<float>& folded_corners(double time);
  // Proves the straight motion; with `plan` looks for another when it is not free.
  const Motion& judge_motion(bool plan, const Run& run);
  const std::optional<Motion>& motion() const { return motion_; }

  std::string fold_bytes();  // the net as a FOLD file, with the motion if it is proven

 private:
  void settle(const FoldForest& before);
  void judge();
  Linkage& linkage();

  Project project_;
  std::vector<std::string> notes_;
  Unfolding net_;
  NetVerdict verdict_;
  std::vector<float> table_, space_;
  std::optional<Linkage> linkage_;
  std::optional<FoldingPath> straight_;
  std::optional<Motion> motion_;
};

}  // namespace plico
