#include "plico/unfold/flat_faces.h"

#include <algorithm>

#include "plico/fold/unfolding.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

// Corner numbers 0, 1, 2: the common case, without a look-up.
struct Triangle {
  const Vec2* at;
  static constexpr int size() { return 3; }
  const Vec2& operator[](int i) const { return at[i]; }
};
struct Indexed {
  const Vec2* at;
  const int* index;
  int count;
  int size() const { return count; }
  const Vec2& operator[](int i) const { return at[index[i]]; }
};

struct Touch {
  double tolerance;
  double operator()(const Vec2& side) const { return tolerance * (std::abs(side.x()) + std::abs(side.y())); }
};

template <class A, class B>
bool share_interior(const A& a, const B& b, double tolerance) {
  return !side_separates(a, b, Touch{tolerance}) && !side_separates(b, a, Touch{tolerance});
}

}  // namespace

Box2 box_of(const Vec2* corners, int count) {
  Box2 box{corners[0].x(), corners[0].y(), corners[0].x(), corners[0].y()};
  for (int i = 1; i < count; ++i) {
    box.x0 = std::min(box.x0, corners[i].x());
    box.y0 = std::min(box.y0, corners[i].y());
    box.x1 = std::max(box.x1, corners[i].x());
    box.y1 = std::max(box.y1, corners[i].y());
  }
  return box;
}

FlatFaces::FlatFaces(const Mesh& mesh) : mesh_(&mesh), tolerance_(1e-12 * diagonal(mesh)) {
  corner_.reserve(mesh.num_halfedges());
  first_piece_.push_back(0);
  for (FaceId f : mesh.faces()) {
    const std::vector<Vec2> flat = flat_corners(mesh, f);
    corner_.insert(corner_.end(), flat.begin(), flat.end());
    is_triangle_.push_back(flat.size() == 3);
    add_pieces(f);
  }
  choose_cell_size();
}

void FlatFaces::choose_cell_size() {
  double sum = 0;
  std::vector<double> extent;
  for (FaceId f : mesh_->faces()) {
    const Box2 box = box_of(corners(f), degree(f));
    extent.push_back(std::max(box.x1 - box.x0, box.y1 - box.y0));
    sum += extent.back();
  }
  if (sum == 0) return;
  cell_size_ = 1.2 * sum / mesh_->num_faces();
  // A few faces far larger than the mean must not fill the grid.
  const auto cells = [&] {
    double n = 0;
    for (double e : extent) n += (e / cell_size_ + 1) * (e / cell_size_ + 1);
    return n;
  };
  while (cells() > 12.0 * mesh_->num_faces()) cell_size_ *= 1.25;
}

void FlatFaces::add_pieces(FaceId face) {
  const std::span<const Vec2> outline(corners(face), degree(face));
  const auto add = [&](std::span<const int> corner_numbers) {
    piece_.push_back({static_cast<int>(piece_corner_.size()), static_cast<int>(corner_numbers.size())});
    piece_corner_.insert(piece_corner_.end(), corner_numbers.begin(), corner_numbers.end());
  };
  if (outline.size() == 3 || is_convex(outline)) {
    std::vector<int> all(outline.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    add(all);
  } else {
    for (const auto& triangle : triangulate(outline)) add(triangle);
  }
  first_piece_.push_back(static_cast<int>(piece_.size()));
}

bool FlatFaces::pieces_overlap(const Piece& a, const Vec2* at, const Piece& b, const Vec2* other_at) const {
  const Indexed pa{at, &piece_corner_[a.first], a.count}, pb{other_at, &piece_corner_[b.first], b.count};
  return share_interior(pa, pb, tolerance_);
}

bool FlatFaces::overlap(int face, const Vec2* at, int other, const Vec2* other_at) const {
  if (is_triangle_[face] && is_triangle_[other]) {
    const Triangle a{at}, b{other_at};
    return share_interior(a, b, tolerance_);
  }
  for (int i = first_piece_[face]; i < first_piece_[face + 1]; ++i)
    for (int j = first_piece_[other]; j < first_piece_[other + 1]; ++j)
      if (pieces_overlap(piece_[i], at, piece_[j], other_at)) return true;
  return false;
}

}  // namespace plico
