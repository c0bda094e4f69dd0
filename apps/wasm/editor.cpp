#include "editor.h"

#include <numeric>

#include "plico/io/pattern/fold.h"
#include "plico/workflow/unfold_mesh.h"

namespace plico {
namespace {

// The pieces that an edit moves as wholes: faces joined by folds that were there before and still are.
std::vector<int> rigid_pieces(const Mesh& mesh, const FoldForest& before, const FoldForest& now) {
  std::vector<int> piece(mesh.num_faces(), -1), stack;
  int count = 0;
  for (int start = 0; start < mesh.num_faces(); ++start) {
    if (piece[start] >= 0) continue;
    piece[start] = count;
    stack.push_back(start);
    while (!stack.empty()) {
      const int face = stack.back();
      stack.pop_back();
      for (HalfedgeId h : mesh.halfedges(FaceId(face))) {
        const int e = mesh.edge(h);
        if (!before.is_fold[e] || !now.is_fold[e]) continue;
        const int across = mesh.face(mesh.twin(h));
        if (piece[across] >= 0) continue;
        piece[across] = count;
        stack.push_back(across);
      }
    }
    ++count;
  }
  return piece;
}

// Of every part the first face of its largest piece: the one that stays where it lies.
std::vector<int> anchors(const std::vector<int>& piece, const std::vector<int>& part, int num_parts) {
  std::vector<int> size(piece.size(), 0), anchor(num_parts, -1);
  for (int p : piece) ++size[p];
  for (std::size_t f = 0; f < piece.size(); ++f) {
    int& best = anchor[part[f]];
    if (best < 0 || size[piece[f]] > size[piece[best]]) best = static_cast<int>(f);
  }
  return anchor;
}

// The rigid motion of the plane that takes a to a2 and the direction a -> b to a2 -> b2.
struct Placing {
  Vec2 from, to, turn;  // turn is cos, sin
  Placing(const Vec2& a, const Vec2& b, const Vec2& a2, const Vec2& b2) : from(a), to(a2) {
    const Vec2 u = b - a, v = b2 - a2;
    turn = Vec2(u.dot(v), u.x() * v.y() - u.y() * v.x()).normalized();
  }
  Vec2 operator()(const Vec2& p) const {
    const Vec2 d = p - from;
    return to + Vec2(turn.x() * d.x() - turn.y() * d.y(), turn.y() * d.x() + turn.x() * d.y());
  }
};

}  // namespace

Editor::Editor(const std::string& bytes, const std::string& name, const Run& run) {
  OpenedProject opened = open_project(bytes, name);
  project_ = std::move(opened.project);
  notes_ = std::move(opened.notes);
  if (!opened.has_net) plico::apply_edit(project_, replacement(unfold_mesh(project_.mesh, {}, run).forest));
  judge();
  arrange();
}

std::optional<Edit> Editor::edit_for(int edge) const {
  if (edge < 0 || edge >= project_.mesh.num_edges() || project_.mesh.is_boundary(EdgeId(edge)) || project_.locked[edge])
    return std::nullopt;
  if (project_.forest.is_fold[edge]) return CutEdge{edge};
  const HalfedgeId h = project_.mesh.halfedge(EdgeId(edge));
  const int left = project_.mesh.face(h), right = project_.mesh.face(project_.mesh.twin(h));
  if (net_.part[left] != net_.part[right]) return JoinEdge{edge};
  const int fold = fold_in_the_way(project_, edge);
  if (fold < 0) return std::nullopt;
  return MoveFold{edge, fold};
}

Edit Editor::apply(const Edit& edit) {
  const FoldForest before = project_.forest;
  Edit inverse = plico::apply_edit(project_, edit);
  if (before == project_.forest) return inverse;
  judge();
  settle(before);
  return inverse;
}

Editor Editor::after(const Edit& edit) const {
  Editor other = *this;
  other.apply(edit);
  return other;
}

Edit Editor::search(bool folds, const Run& run) {
  return folds ? replacement(find_foldable_net(project_.mesh, {}, run).tree)
               : replacement(unfold_mesh(project_.mesh, {}, run).forest);
}

void Editor::judge() {
  net_ = lay_flat(project_.mesh, project_.forest);
  verdict_ = verify_net(net_, project_.mesh);
  linkage_.reset();
  straight_.reset();
  motion_.reset();
}

void Editor::arrange() {
  table_.clear();
  for (const auto& face : net_.sheet.faces)
    for (int v : face) {
      table_.push_back(static_cast<float>(net_.sheet.vertices[v].x()));
      table_.push_back(static_cast<float>(net_.sheet.vertices[v].y()));
    }
}

void Editor::settle(const FoldForest& before) {
  const std::vector<int>& offsets = project_.mesh.soup().offsets;
  const std::vector<float> lay = table_;
  const auto lay_at = [&](int corner) { return Vec2(lay[2 * corner], lay[2 * corner + 1]); };
  const auto corner = [&](int face, int i) { return net_.sheet.vertices[net_.sheet.faces[face][i]]; };
  std::vector<Placing> placing;
  for (int face : anchors(rigid_pieces(project_.mesh, before, project_.forest), net_.part, net_.num_parts()))
    placing.emplace_back(corner(face, 0), corner(face, 1), lay_at(offsets[face]), lay_at(offsets[face] + 1));
  for (int f = 0; f < project_.mesh.num_faces(); ++f)
    for (int i = 0; i < offsets[f + 1] - offsets[f]; ++i) {
      const Vec2 p = placing[net_.part[f]](corner(f, i));
      table_[2 * (offsets[f] + i)] = static_cast<float>(p.x());
      table_[2 * (offsets[f] + i) + 1] = static_cast<float>(p.y());
    }
}

std::vector<float> Editor::mesh_corners() const {
  std::vector<float> corners;
  for (int v : project_.mesh.soup().corners)
    for (double x : project_.mesh.soup().points[v]) corners.push_back(static_cast<float>(x));
  return corners;
}

Linkage& Editor::linkage() {
  if (!linkage_) linkage_ = linkage_of(net_);
  return *linkage_;
}

const std::vector<float>& Editor::folded_corners(double time) {
  const Linkage& of = linkage();
  if (!straight_) straight_ = linear_path(of);
  const std::vector<Pose> poses = folding_map(of, (motion_ ? motion_->path : *straight_).at(time));
  space_.clear();
  for (int p = 0; p < of.num_panels(); ++p)
    for (const Vec3& corner : of.panels[p])
      for (double x : Vec3(poses[p] * corner)) space_.push_back(static_cast<float>(x));
  return space_;
}

const Motion& Editor::judge_motion(bool plan, const Run& run) {
  if (motion_ && (!plan || motion_->proof.verdict == PathVerdict::Free)) return *motion_;
  const MotionOptions options{.method = plan ? MotionMethod::Auto : MotionMethod::Linear};
  MotionOutcome outcome = plico::plan(linkage(), options, run);
  motion_ = std::move(outcome.motions.front());
  return *motion_;
}

std::string Editor::fold_bytes() {
  FoldFile file = fold_file(project_.mesh, net_);
  if (motion_ && motion_->proof.verdict == PathVerdict::Free) set_path(file, linkage(), motion_->path);
  return write_fold(file);
}

}  // namespace plico
