#include "plico/unfold/grow.h"

#include <queue>
#include <tuple>

#include "plico/unfold/panel_grid.h"

namespace plico {
namespace {

class Growing {
 public:
  Growing(const FlatFaces& faces, const std::vector<double>& weights)
      : faces_(faces),
        mesh_(faces.mesh()),
        weights_(weights),
        at_(mesh_.num_halfedges()),
        placed_(mesh_.num_faces(), 0),
        grid_(mesh_.num_faces(), faces.cell_size()),
        forest_{std::vector<char>(mesh_.num_edges(), 0)} {}

  FoldForest run(int seed_face) {
    place(seed_face, Motion2{});
    while (!ready_.empty()) {
      const Side side = ready_.top();
      ready_.pop();
      const int face = mesh_.face(HalfedgeId(side.halfedge));
      if (placed_[face]) continue;
      const Motion2 motion = motion_for(side.halfedge);
      const int overlaps = side.overlaps < 0 ? overlaps_at(face, motion) : 0;
      if (overlaps > 0) {
        ready_.push({overlaps, side.weight, side.halfedge});
        continue;
      }
      forest_.is_fold[mesh_.edge(HalfedgeId(side.halfedge))] = 1;
      place(face, motion);
    }
    return std::move(forest_);
  }

 private:
  // A way to place a panel: across its halfedge, beside a panel that lies already.
  struct Side {
    int overlaps;  // -1: not tested yet, taken before all that are known to overlap
    double weight;
    int halfedge;
    bool operator<(const Side& o) const {  // std::priority_queue takes the greatest first
      return std::tie(overlaps, weight, halfedge) > std::tie(o.overlaps, o.weight, o.halfedge);
    }
  };

  Motion2 motion_for(int side) const {
    const HalfedgeId g(side), h = mesh_.twin(g);
    return carry_side(faces_, g, at_[mesh_.next(h)], at_[h]);
  }

  Vec2* corners(int face) { return &at_[mesh_.soup().offsets[face]]; }

  int overlaps_at(int face, const Motion2& motion) {
    Vec2* at = corners(face);  // not placed yet, so free for trying
    faces_.place(face, motion, at);
    int count = 0;
    grid_.visit_meeting(box_of(at, faces_.degree(face)), [&](int other) {
      count += faces_.overlap(face, at, other, corners(other));
      return true;
    });
    return count;
  }

  void place(int face, const Motion2& motion) {
    Vec2* at = corners(face);
    faces_.place(face, motion, at);
    grid_.insert(face, box_of(at, faces_.degree(face)));
    placed_[face] = 1;
    for (HalfedgeId h : mesh_.halfedges(FaceId(face))) {
      const HalfedgeId g = mesh_.twin(h);
      if (g.valid() && !placed_[mesh_.face(g)]) ready_.push({-1, weights_[mesh_.edge(h)], g});
    }
  }

  const FlatFaces& faces_;
  const Mesh& mesh_;
  const std::vector<double>& weights_;
  std::vector<Vec2> at_;
  std::vector<char> placed_;
  PanelGrid grid_;
  std::priority_queue<Side> ready_;
  FoldForest forest_;
};

}  // namespace

FoldForest grow_tree(const FlatFaces& faces, const std::vector<double>& weights, int seed_face) {
  return Growing(faces, weights).run(seed_face);
}

}  // namespace plico
