// The triangles of one convex shell while its vertices move, merge and stay on their planes.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "plico/convex/half_spaces.h"
#include "plico/geom/convex3.h"

namespace plico {

// What a shell must not leave while it is remeshed.
struct ShellRoom {
  std::vector<Plane> planes;  // the shell is strictly below all of them, exactly
  std::vector<char> contact;  // of each plane: a facet of the shell lies on it, and stays there
  Eigen::AlignedBox3d box;    // and the shell stays in this box
  double tolerance = 0;       // units: points nearer than this lie on a plane
  double margin = 0;          // units: how far a new vertex keeps from planes that it must not reach
};

class ShellSurface {
 public:
  ShellSurface(const ConvexPolyhedron& body, const ShellRoom& room);

  // A vertex to be moved, or the two ends of an edge to become one vertex; and the triangles around, as a loop.
  struct Patch {
    std::array<int, 2> removed{-1, -1};  // the second is -1 for a vertex
    std::vector<int> triangles;
    std::vector<int> loop;    // counter-clockwise seen from outside
    std::vector<int> across;  // of each side loop[i] loop[i + 1]: the corner beyond it
    std::vector<int> flats;   // planes on which the new vertex must lie
  };
  // The new vertex must lie on contact planes of the removed ones and on planes that go on beyond the loop;
  // `keep_flat`: also on those of one end of the edge alone. None when the triangles around are no disk, or for more
  // than 3 planes.
  std::optional<Patch> patch_of(int vertex) const;
  std::optional<Patch> patch_of(int from, int to, bool keep_flat) const;

  // Half-spaces of a new vertex: in the room, and no neighbour across the loop comes to lie above a new triangle.
  std::vector<Plane> limits(const Patch& patch) const;
  void add_above(const Patch& patch, std::vector<Plane>& limits) const;   // and above all triangles that go
  void add_spokes(const Patch& patch, std::vector<Plane>& limits) const;  // and the new edges are convex
  std::vector<Plane> flats(const Patch& patch) const;                     // on which it lies

  // Decided exactly on rounded coordinates: every new or changed edge is convex, the removed vertices are inside, the
  // new one is strictly in the room. Where all points lie on one of the flats, they only need to turn the right way.
  bool is_allowed(const Patch& patch, const Vec3& point) const;
  void replace(const Patch& patch, const Vec3& point);  // the new vertex keeps the number removed[0]

  Vec3 uphill(const Patch& patch) const;                     // 3 times the gradient of the volume by the new vertex
  double gain(const Patch& patch, const Vec3& point) const;  // of volume
  const Vec3& point(int v) const { return vertices_[v].point; }
  const ShellRoom& room() const { return room_; }
  bool is_alive(int v) const { return !vertices_[v].triangles.empty(); }
  int num_vertices() const { return static_cast<int>(vertices_.size()); }  // removed ones too
  int num_triangles() const { return num_triangles_; }
  std::vector<int> neighbours(int v) const;  // ascending
  std::vector<std::array<int, 2>> edges() const;
  std::vector<int> triangles() const;  // their numbers
  const std::array<int, 3>& triangle(int t) const { return triangles_[t]; }
  std::vector<Vec3> points() const;  // of vertices that are there

 private:
  struct Vertex {
    Vec3 point;
    std::vector<int> triangles;  // ascending
    std::vector<int> flats;      // ascending
  };

  void find_flats();
  void add_flat(const Plane& plane);
  std::optional<Patch> with_loop(Patch patch) const;
  std::vector<int> flats_beyond(const Patch& patch, const std::vector<int>& flats) const;
  int corner_beyond(int p, int q) const;  // of the triangle left of q p
  void add_below(const Patch& patch, int p, int q, int r, double sign, std::vector<Plane>& limits) const;
  bool on_one_flat(std::initializer_list<int> vertices, const std::vector<int>& flats) const;
  bool is_convex_side(const Patch& patch, std::size_t i, const Vec3& point) const;
  bool is_in_room(const Patch& patch, const Vec3& point) const;
  void remove_triangle(int t);
  void add_triangle(const std::array<int, 3>& corners);

  ShellRoom room_;
  std::vector<Plane> flat_planes_;
  std::vector<int> plane_of_room_;  // of each flat: the number of the contact plane, or -1
  std::vector<Vertex> vertices_;
  std::vector<std::array<int, 3>> triangles_;  // {-1, ...} when removed
  int num_triangles_ = 0;
};

}  // namespace plico
