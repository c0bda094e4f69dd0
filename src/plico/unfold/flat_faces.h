// The faces of a mesh as rigid panels of the plane, for searches: shapes that never change, and a rounded overlap test
// that lets touching panels touch. What a search returns is laid out afresh (fold/unfolding.h) and judged exactly
// (verify/net.h).
#pragma once
#include <cmath>
#include <vector>

#include "plico/mesh/mesh.h"

namespace plico {

// A rigid motion of the plane: turn, then shift.
struct Motion2 {
  double cosine = 1, sine = 0, x = 0, y = 0;
  Vec2 operator()(const Vec2& p) const {
    return {cosine * p.x() - sine * p.y() + x, sine * p.x() + cosine * p.y() + y};
  }
};

// The motion that carries a to `from` and the direction a -> b to the direction `from` -> `to`.
inline Motion2 carry(const Vec2& a, const Vec2& b, const Vec2& from, const Vec2& to) {
  const Vec2 u = b - a, v = to - from;
  const double scale = 1 / std::sqrt(u.squaredNorm() * v.squaredNorm());
  Motion2 m{u.dot(v) * scale, cross(u, v) * scale, 0, 0};
  m.x = from.x() - (m.cosine * a.x() - m.sine * a.y());
  m.y = from.y() - (m.sine * a.x() + m.cosine * a.y());
  return m;
}

struct Box2 {
  double x0, y0, x1, y1;
  bool meets(const Box2& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
};
Box2 box_of(const Vec2* corners, int count);

// Placed faces are handed around as a pointer to their first corner; the others follow in the face's order.
class FlatFaces {
 public:
  explicit FlatFaces(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  int degree(int face) const { return mesh_->degree(FaceId(face)); }
  const Vec2* corners(int face) const { return &corner_[mesh_->soup().offsets[face]]; }  // in the face's own plane
  // Side of the cells of a grid in which a face, however turned, covers a few cells on average. Units.
  double cell_size() const { return cell_size_; }

  void place(int face, const Motion2& motion, Vec2* at) const {
    const Vec2* own = corners(face);
    for (int i = 0; i < degree(face); ++i) at[i] = motion(own[i]);
  }

  // Do two placed faces share an interior point, by more than rounding? O(1) for triangles.
  bool overlap(int face, const Vec2* at, int other, const Vec2* other_at) const;

 private:
  struct Piece {
    int first, count;  // corner numbers within the face, in piece_corner_
  };
  void add_pieces(FaceId face);
  void choose_cell_size();
  bool pieces_overlap(const Piece& a, const Vec2* at, const Piece& b, const Vec2* other_at) const;

  const Mesh* mesh_;
  std::vector<Vec2> corner_;  // one per halfedge
  std::vector<char> is_triangle_;
  std::vector<Piece> piece_;      // convex
  std::vector<int> first_piece_;  // faces + 1
  std::vector<int> piece_corner_;
  double tolerance_ = 0;  // panels that enter each other by less only touch
  double cell_size_ = 1;
};

// The motion that lays a face with its side `halfedge` from `from` to `to`.
inline Motion2 carry_side(const FlatFaces& faces, int halfedge, const Vec2& from, const Vec2& to) {
  const Mesh& mesh = faces.mesh();
  const HalfedgeId h(halfedge);
  const int face = mesh.face(h), first = mesh.soup().offsets[face];
  const Vec2* own = faces.corners(face);
  return carry(own[h - first], own[mesh.next(h) - first], from, to);
}

}  // namespace plico
