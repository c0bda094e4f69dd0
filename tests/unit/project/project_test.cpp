#include "plico/project/project.h"

#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/shapes/shapes.h"

namespace plico {
namespace {

int folds(const Project& project) {
  int n = 0;
  for (char fold : project.forest.is_fold) n += fold;
  return n;
}

// Every edge of the cube that closes no ring, in order.
Project joined_cube() {
  Project project = new_project("cube", Mesh(cube()));
  for (int e = 0; e < project.mesh.num_edges(); ++e) {
    try {
      apply_edit(project, JoinEdge{e});
    } catch (const InvalidOption&) {
    }
  }
  return project;
}

int first_cut(const Project& project) {
  for (int e = 0; e < project.mesh.num_edges(); ++e)
    if (!project.forest.is_fold[e]) return e;
  return -1;
}

TEST(Project, JoiningAllThatMayBeJoinedMakesOneTree) { EXPECT_EQ(folds(joined_cube()), 5); }

TEST(Project, AnEditThatDoesNotFitChangesNothing) {
  Project project = joined_cube();
  const Project before = project;
  EXPECT_THROW(apply_edit(project, JoinEdge{first_cut(project)}), InvalidOption);  // closes a ring
  EXPECT_THROW(apply_edit(project, CutEdge{first_cut(project)}), InvalidOption);
  EXPECT_THROW(apply_edit(project, CutEdge{99}), InvalidOption);
  EXPECT_THROW(apply_edit(project, ReplaceNet{{0, 1, 2, 3, 4, 5, 6}}), InvalidOption);
  EXPECT_TRUE(project == before);
}

TEST(Project, ALockedEdgeStaysAsItIs) {
  Project project = joined_cube();
  const int cut = first_cut(project);
  apply_edit(project, LockEdge{cut, true});
  EXPECT_THROW(apply_edit(project, MoveFold{cut, fold_in_the_way(project, cut)}), InvalidOption);
  EXPECT_THROW(apply_edit(project, JoinEdge{cut}), InvalidOption);
}

TEST(Project, JoiningWithinAPartMovesWhatIsInTheWay) {
  Project project = joined_cube();
  for (int e = 0; e < project.mesh.num_edges(); ++e) {
    if (project.forest.is_fold[e]) continue;
    const int fold = fold_in_the_way(project, e);
    ASSERT_GE(fold, 0);
    apply_edit(project, MoveFold{e, fold});
    EXPECT_EQ(lay_flat(project.mesh, project.forest).num_parts(), 1);
  }
}

TEST(Project, UndoingAnyEditsInReverseGivesTheFirstBytesAndRedoingTheLast) {
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Project project = new_project("cube", Mesh(cube()));
    const std::string first = write_project(project);
    std::vector<Edit> done, back;
    for (int i = 0; i < 200; ++i) {
      const int e = rng.below(project.mesh.num_edges());
      const int kind = rng.below(4);
      const Edit edit = kind == 0   ? Edit(CutEdge{e})
                        : kind == 1 ? Edit(JoinEdge{e})
                        : kind == 2 ? Edit(LockEdge{e, rng.below(2) == 0})
                                    : Edit(MoveFold{e, fold_in_the_way(project, e)});
      try {
        back.push_back(apply_edit(project, edit));
        done.push_back(edit);
      } catch (const InvalidOption&) {
      }
    }
    const std::string last = write_project(project);
    ASSERT_GT(done.size(), 20u);
    for (std::size_t i = back.size(); i-- > 0;) apply_edit(project, back[i]);
    EXPECT_EQ(write_project(project), first);
    for (const Edit& edit : read_edits(write_edits(done))) apply_edit(project, edit);
    EXPECT_EQ(write_project(project), last);
  }
}

TEST(ProjectFile, ReadsBackWhatWasWritten) {
  Project project = joined_cube();
  apply_edit(project, LockEdge{3, true});
  EXPECT_TRUE(read_project(write_project(project)) == project);
}

TEST(ProjectFile, SaysWhatIsWrong) {
  EXPECT_THROW(read_project("{"), InvalidInput);
  EXPECT_THROW(read_project("{}"), InvalidInput);
  EXPECT_THROW(read_project("[]"), InvalidInput);
  std::string later = write_project(joined_cube());
  later.replace(later.find(":1"), 2, ":9");
  EXPECT_THROW(read_project(later), InvalidInput);
  EXPECT_THROW(read_edits("[{\"edit\": \"bend\"}]"), InvalidInput);
  EXPECT_THROW(read_edits("{}"), InvalidInput);
}

}  // namespace
}  // namespace plico
