#include "plico/project/project.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {
namespace {

// Which part every face is in.
class FaceParts {
 public:
  explicit FaceParts(const Mesh& mesh) : parent_(mesh.num_faces()) {
    for (std::size_t f = 0; f < parent_.size(); ++f) parent_[f] = static_cast<int>(f);
  }
  int find(int face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }
  bool join(int a, int b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

std::pair<int, int> faces_beside(const Mesh& mesh, int edge) {
  const HalfedgeId h = mesh.halfedge(EdgeId(edge));
  return {mesh.face(h), mesh.face(mesh.twin(h))};
}

void require_edge(const Project& project, int edge) {
  if (edge < 0 || edge >= project.mesh.num_edges())
    throw InvalidOption(fmt::format("edge {} must be in [0, {}]", edge, project.mesh.num_edges() - 1));
  if (project.mesh.is_boundary(EdgeId(edge)))
    throw InvalidOption(fmt::format("edge {} is at the border of the mesh and has one face", edge));
}

void require_free(const Project& project, int edge, bool fold) {
  require_edge(project, edge);
  if (static_cast<bool>(project.forest.is_fold[edge]) != fold)
    throw InvalidOption(fmt::format("edge {} is {} already", edge, fold ? "cut" : "a fold"));
  if (project.locked[edge]) throw InvalidOption(fmt::format("edge {} is locked", edge), "unlock it first");
}

void require_forest(const Project& project, const std::vector<char>& is_fold) {
  FaceParts parts(project.mesh);
  for (int e = 0; e < project.mesh.num_edges(); ++e) {
    if (!is_fold[e]) continue;
    const auto [left, right] = faces_beside(project.mesh, e);
    if (!parts.join(left, right))
      throw InvalidOption(fmt::format("a fold at edge {} would close a ring of faces", e),
                          "cut another edge of the ring");
  }
}

std::vector<int> folds_of(const FoldForest& forest) {
  std::vector<int> folds;
  for (std::size_t e = 0; e < forest.is_fold.size(); ++e)
    if (forest.is_fold[e]) folds.push_back(static_cast<int>(e));
  return folds;
}

class Application {
 public:
  explicit Application(Project& project) : project_(project) {}

  Edit operator()(const CutEdge& edit) {
    require_free(project_, edit.edge, true);
    project_.forest.is_fold[edit.edge] = 0;
    return JoinEdge{edit.edge};
  }
  Edit operator()(const JoinEdge& edit) {
    require_free(project_, edit.edge, false);
    std::vector<char> folds = project_.forest.is_fold;
    folds[edit.edge] = 1;
    take(std::move(folds));
    return CutEdge{edit.edge};
  }
  Edit operator()(const MoveFold& edit) {
    require_free(project_, edit.join, false);
    require_free(project_, edit.cut, true);
    std::vector<char> folds = project_.forest.is_fold;
    folds[edit.join] = 1, folds[edit.cut] = 0;
    take(std::move(folds));
    return MoveFold{edit.cut, edit.join};
  }
  Edit operator()(const LockEdge& edit) {
    require_edge(project_, edit.edge);
    const bool before = std::exchange(project_.locked[edit.edge], edit.locked);
    return LockEdge{edit.edge, before};
  }
  Edit operator()(const ReplaceNet& edit) {
    std::vector<char> folds(project_.mesh.num_edges(), 0);
    for (int e : edit.folds) {
      require_edge(project_, e);
      folds[e] = 1;
    }
    for (int e = 0; e < project_.mesh.num_edges(); ++e)
      if (project_.locked[e] && folds[e] != project_.forest.is_fold[e])
        throw InvalidOption(fmt::format("edge {} is locked", e), "unlock it first");
    ReplaceNet back{folds_of(project_.forest)};
    take(std::move(folds));
    return back;
  }

 private:
  void take(std::vector<char> folds) {
    require_forest(project_, folds);
    project_.forest.is_fold = std::move(folds);
  }

  Project& project_;
};

// The tree that hangs from one face: from where each face was reached, and how many faces hang below it.
struct HangingTree {
  std::vector<int> order, up_edge, up_face, size;

  HangingTree(const Mesh& mesh, const FoldForest& forest, int root)
      : order{root}, up_edge(mesh.num_faces(), -1), up_face(mesh.num_faces(), -1), size(mesh.num_faces(), 1) {
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (HalfedgeId h : mesh.halfedges(FaceId(order[i]))) {
        const int e = mesh.edge(h);
        if (!forest.is_fold[e] || e == up_edge[order[i]]) continue;
        const int across = mesh.face(mesh.twin(h));
        up_edge[across] = e, up_face[across] = order[i];
        order.push_back(across);
      }
    }
    for (std::size_t i = order.size(); i-- > 1;) size[up_face[order[i]]] += size[order[i]];
  }
};

}  // namespace

bool Project::operator==(const Project& other) const {
  return name == other.name && mesh.soup().points == other.mesh.soup().points &&
         mesh.soup().corners == other.mesh.soup().corners && mesh.soup().offsets == other.mesh.soup().offsets &&
         forest == other.forest && locked == other.locked;
}

Project new_project(std::string name, Mesh mesh) {
  const std::size_t edges = mesh.num_edges();
  return {std::move(name), std::move(mesh), {std::vector<char>(edges, 0)}, std::vector<char>(edges, 0)};
}

Edit apply_edit(Project& project, const Edit& edit) { return std::visit(Application(project), edit); }

int fold_in_the_way(const Project& project, int edge) {
  require_edge(project, edge);
  const auto [left, right] = faces_beside(project.mesh, edge);
  const HangingTree tree(project.mesh, project.forest, left);
  const int all = static_cast<int>(tree.order.size());
  int best = -1, fewest = all;
  for (int face = right; tree.up_edge[face] >= 0; face = tree.up_face[face]) {
    const int moved = std::min(tree.size[face], all - tree.size[face]);
    const int fold = tree.up_edge[face];
    if (!project.locked[fold] && (moved < fewest || (moved == fewest && fold < best))) best = fold, fewest = moved;
  }
  return best;
}

}  // namespace plico
