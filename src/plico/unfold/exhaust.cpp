#include "plico/unfold/exhaust.h"

#include <vector>

namespace plico {
namespace {

class Enumeration {
 public:
  Enumeration(const FlatFaces& faces, long max_nodes, const Run& run)
      : faces_(faces),
        mesh_(faces.mesh()),
        max_nodes_(max_nodes),
        run_(run),
        at_(mesh_.num_halfedges()),
        placed_(mesh_.num_faces(), 0),
        left_out_(mesh_.num_edges(), 0) {
    result_.net.is_fold.assign(mesh_.num_edges(), 0);
  }

  ExhaustResult go() {
    faces_.place(0, Motion2{}, at_.data());
    placed_[0] = 1;
    order_.push_back(0);
    if (extend()) {
      result_.ending = Ending::Found;
      result_.decided = true;
    } else if (!over_) {
      result_.decided = true;
    } else if (run_.over()) {
      result_.ending = run_.ending();
    }
    return std::move(result_);
  }

 private:
  // Decides the next dual edge at the border of the partial net; true once all faces are placed.
  bool extend() {
    if (static_cast<int>(order_.size()) == mesh_.num_faces()) return true;
    if (over_ || ++result_.nodes > max_nodes_ || (result_.nodes % 1024 == 0 && run_.over())) {
      over_ = true;
      return false;
    }
    const HalfedgeId side = next_side();
    if (!side.valid()) return false;
    const EdgeId edge = mesh_.edge(side);
    const int face = mesh_.face(side);
    if (fits(face, side)) {
      placed_[face] = 1;
      order_.push_back(face);
      result_.net.is_fold[edge] = 1;
      if (extend()) return true;
      result_.net.is_fold[edge] = 0;
      order_.pop_back();
      placed_[face] = 0;
    }
    left_out_[edge] = 1;
    const bool found = all_reachable() && extend();
    left_out_[edge] = 0;
    return found;
  }

  // The side of an unplaced face by which it may be hung to the partial net.
  HalfedgeId next_side() const {
    for (int f : order_)
      for (HalfedgeId h : mesh_.halfedges(FaceId(f))) {
        const HalfedgeId g = mesh_.twin(h);
        if (g.valid() && !placed_[mesh_.face(g)] && !left_out_[mesh_.edge(h)]) return g;
      }
    return HalfedgeId();
  }

  bool fits(int face, HalfedgeId side) {
    const HalfedgeId across = mesh_.twin(side);
    Vec2* at = &at_[mesh_.soup().offsets[face]];
    faces_.place(face, carry_side(faces_, side, at_[mesh_.next(across)], at_[across]), at);
    for (int other : order_)
      if (faces_.overlap(face, at, other, &at_[mesh_.soup().offsets[other]])) return false;
    return true;
  }

  bool all_reachable() const {
    std::vector<char> seen = placed_;
    std::vector<int> queue = order_;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (HalfedgeId h : mesh_.halfedges(FaceId(queue[i]))) {
        const HalfedgeId g = mesh_.twin(h);
        if (!g.valid() || seen[mesh_.face(g)] || left_out_[mesh_.edge(h)]) continue;
        seen[mesh_.face(g)] = 1;
        queue.push_back(mesh_.face(g));
      }
    return static_cast<int>(queue.size()) == mesh_.num_faces();
  }

  const FlatFaces& faces_;
  const Mesh& mesh_;
  long max_nodes_;
  const Run& run_;
  std::vector<Vec2> at_;
  std::vector<char> placed_, left_out_;
  std::vector<int> order_;
  bool over_ = false;
  ExhaustResult result_;
};

}  // namespace

ExhaustResult try_all_nets(const FlatFaces& faces, long max_nodes, const Run& run) {
  return Enumeration(faces, max_nodes, run).go();
}

}  // namespace plico
