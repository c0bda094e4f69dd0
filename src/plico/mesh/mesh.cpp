#include "plico/mesh/mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "plico/base/error.h"
#include "plico/base/sort_in_buckets.h"

namespace plico {
namespace {

std::string near(const Vec3& p) { return fmt::format("near {:.6g} {:.6g} {:.6g}", p.x(), p.y(), p.z()); }

void check_face(const PolygonSoup& soup, int f) {
  const auto face = soup.face(f);
  if (face.size() < 3)
    throw InvalidInput("mesh/face-size", fmt::format("face {} has {} corners, at least 3 are needed", f, face.size()));
  for (int v : face)
    if (v < 0 || v >= soup.num_points())
      throw InvalidInput("mesh/index",
                         fmt::format("face {} uses vertex {}, must be in [0, {}]", f, v, soup.num_points() - 1));
  std::vector<int> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    throw InvalidInput("mesh/repeated-vertex", fmt::format("face {} uses vertex {} twice", f, *twice),
                       describe_face(soup, f), "plico check --repair");
}

void check_points(const PolygonSoup& soup) {
  if (soup.num_faces() == 0)
    throw InvalidInput("mesh/empty", fmt::format("{} vertices but no faces", soup.num_points()));
  for (int v = 0; v < soup.num_points(); ++v)
    if (!soup.points[v].allFinite())
      throw InvalidInput("mesh/not-a-number", fmt::format("vertex {} has coordinates that are not finite", v));
}

}  // namespace

std::string describe_face(const PolygonSoup& soup, int face) {
  std::string corners;
  for (int v : soup.face(face)) corners += (corners.empty() ? "" : " ") + std::to_string(v);
  return fmt::format("face {} (vertices {}, {})", face, corners, near(soup.points[soup.face(face)[0]]));
}

std::string describe_edge(const PolygonSoup& soup, int a, int b) {
  return fmt::format("edge {}-{} ({})", a, b, near((soup.points[a] + soup.points[b]) / 2));
}

std::string describe_vertex(const PolygonSoup& soup, int vertex) {
  return fmt::format("vertex {} ({})", vertex, near(soup.points[vertex]));
}

Mesh::Mesh(PolygonSoup soup) : soup_(std::move(soup)) {
  check_points(soup_);
  face_.resize(soup_.corners.size());
  for (FaceId f : faces()) {
    check_face(soup_, f);
    for (HalfedgeId h : halfedges(f)) face_[h] = f;
  }
  find_twins();
  number_edges();
  find_fans();
}

void Mesh::find_twins() {
  // Sorting the halfedges by their undirected edge brings twins side by side, deterministically.
  std::vector<int> order(soup_.corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::pair<int, int>> key(order.size());
  for (int h : order) key[h] = std::minmax<int>(from(HalfedgeId(h)), to(HalfedgeId(h)));
  sort_in_buckets(
      order, num_vertices(), [&](int h) { return key[h].first; },
      [&](int g, int h) { return key[g] != key[h] ? key[g] < key[h] : g < h; });
  twin_.assign(order.size(), -1);
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && key[order[end]] == key[order[i]]) ++end;
    const auto [a, b] = key[order[i]];
    if (end - i > 2)
      throw InvalidInput("mesh/edge-faces", fmt::format("edge {}-{} has {} faces, at most 2 can unfold", a, b, end - i),
                         describe_edge(soup_, a, b), "plico check --repair");
    if (end - i == 2) {
      const int g = order[i], h = order[i + 1];
      if (soup_.corners[g] == soup_.corners[h])
        throw InvalidInput(
            "mesh/orientation",
            fmt::format("faces {} and {} run along edge {}-{} in the same direction", face_[g], face_[h], a, b),
            describe_edge(soup_, a, b), "plico check --repair");
      twin_[g] = h;
      twin_[h] = g;
    }
    i = end;
  }
}

void Mesh::number_edges() {
  edge_.assign(twin_.size(), -1);
  for (int h = 0; h < num_halfedges(); ++h) {
    const bool first = twin_[h] < 0 || h < twin_[h];
    edge_[h] = first ? num_edges() : edge_[twin_[h]];
    if (first) edge_halfedge_.push_back(h);
  }
}

void Mesh::find_fans() {
  vertex_halfedge_.assign(num_vertices(), -1);
  std::vector<int> leaving(num_vertices(), 0);
  for (int h = 0; h < num_halfedges(); ++h) {
    const VertexId v = from(HalfedgeId(h));
    ++leaving[v];
    if (vertex_halfedge_[v] < 0 || twin_[h] < 0) vertex_halfedge_[v] = h;
  }
  for (VertexId v : vertices()) {
    if (leaving[v] == 0) continue;
    const HalfedgeId start = halfedge(v);
    int fan = 0;
    HalfedgeId h = start;
    do {
      ++fan;
      h = twin(prev(h));
    } while (h.valid() && h != start);
    if (fan != leaving[v])
      throw InvalidInput("mesh/bow-tie", fmt::format("the faces around vertex {} make more than one fan", int(v)),
                         describe_vertex(soup_, v), "plico check --repair");
  }
}

}  // namespace plico
