// What someone works on: a mesh, which of its edges are folds, and which of those choices must stay. Edits are values
// that can be stored, sent, replayed and undone; they hold no algorithm: what is judged or searched comes from outside.
#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "plico/fold/unfolding.h"
#include "plico/mesh/mesh.h"

namespace plico {

struct Project {
  std::string name;  // of the model, for titles and file names
  Mesh mesh;
  FoldForest forest;
  std::vector<char> locked;  // one per mesh edge: stays the fold or the cut that it is
  bool operator==(const Project& other) const;
};

// No fold at all, and nothing locked.
Project new_project(std::string name, Mesh mesh);

// Edges of the mesh. Cutting a fold makes two parts of one; joining a cut makes one of two.
struct CutEdge {
  int edge = -1;
  bool operator==(const CutEdge&) const = default;
};
struct JoinEdge {
  int edge = -1;
  bool operator==(const JoinEdge&) const = default;
};
// Joins one edge and cuts another: what hangs there moves, and the number of parts stays.
struct MoveFold {
  int join = -1, cut = -1;
  bool operator==(const MoveFold&) const = default;
};
struct LockEdge {
  int edge = -1;
  bool locked = true;
  bool operator==(const LockEdge&) const = default;
};
// A whole net at once, as searches find them: the edges that are folds, ascending.
struct ReplaceNet {
  std::vector<int> folds;
  bool operator==(const ReplaceNet&) const = default;
};
using Edit = std::variant<CutEdge, JoinEdge, MoveFold, LockEdge, ReplaceNet>;

// Changes the project, and returns the edit that takes it back; apply_edit(project, apply_edit(project, edit)) changes
// nothing. Throws InvalidOption, with the project as it was, when the edit does not fit: an edge that is not there, is
// already so, is locked or at the border, or a join that would close a cycle. O(edges).
Edit apply_edit(Project& project, const Edit& edit);

// Of the folds between the two faces of a cut edge, along the tree, the one to cut when that edge is joined, so that
// fewer panels move; ties go to the lower edge. Locked folds are passed over. -1 when the faces are in different parts
// or every fold between them is locked. O(edges).
int fold_in_the_way(const Project& project, int edge);

// {"edit": "cut", "edge": 12}, "join", {"edit": "move", "join": 3, "cut": 12}, {"edit": "lock", "edge": 3,
// "locked": true}, {"edit": "net", "folds": [...]}; lists are JSON arrays. read_edits() throws InvalidInput
// ("project/...").
std::string write_edits(const std::vector<Edit>& edits);
std::vector<Edit> read_edits(std::string_view json, const std::string& name = "edits");

// One JSON object: mesh, folds, locks. The same project gives the same bytes.
std::string write_project(const Project& project);
// Throws InvalidInput ("project/...") for what is no project, or one of a later version.
Project read_project(std::string_view json, const std::string& name = "project");

}  // namespace plico
