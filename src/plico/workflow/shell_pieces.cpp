#include "plico/workflow/shell_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "plico/base/error.h"
#include "plico/mesh/flat_regions.h"
#include "plico/mesh/measures.h"

namespace plico {
namespace {

constexpr double kInPlane = 1e-6;  // of the diagonal: a facet this near to the plane of a contact lies in it

// Shells are moved inward from their planes by 1e-12 of the diagonal, so facets of one plane are that far from flat,
// and slivers between them are to go.
constexpr double kFlat = 1e-9;  // of a facet's size

// The triangles of all shells, and the shell of each.
struct ShellSoup {
  PolygonSoup soup;
  std::vector<int> shell;
};

ShellSoup soup_of(const std::vector<Shell>& shells) {
  ShellSoup all;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const int first = all.soup.num_points();
    const ConvexPolyhedron& body = shells[s].body;
    all.soup.points.insert(all.soup.points.end(), body.points.begin(), body.points.end());
    for (const ConvexPolyhedron::Facet& facet : body.facets) {
      std::vector<int> corners = facet.corners;
      for (int& v : corners) v += first;
      all.soup.add_face(corners);
      all.shell.push_back(static_cast<int>(s));
    }
  }
  return all;
}

// The mesh with its flat regions whole, and the shell of each face; the triangles where that would make no surface.
void make_mesh(const ShellSoup& all, ShellPieces& result) {
  const Mesh triangles(all.soup);
  FlatRegions flat = flat_regions(triangles, kFlat);
  result.pieces.part.assign(flat.soup.num_faces(), 0);
  for (std::size_t f = 0; f < flat.region.size(); ++f) result.pieces.part[flat.region[f]] = all.shell[f];
  result.mesh = Mesh(std::move(flat.soup));
}

bool holds(const Mesh& mesh, FaceId face, const Vec3& point) {
  const Vec3 n = normal(mesh, face);
  for (HalfedgeId h : mesh.halfedges(face)) {  // facets of convex bodies are convex
    const Vec3 &a = mesh.point(mesh.from(h)), &b = mesh.point(mesh.to(h));
    if ((b - a).cross(point - a).dot(n) < 0) return false;
  }
  return true;
}

// The facet of a piece in a plane that has the middle of a contact; its normal is that of the plane times `turn`.
std::optional<int> facet_at(const ShellPieces& all, int piece, const ShellContact& contact, double turn) {
  const Vec3 middle = std::accumulate(contact.polygon.begin(), contact.polygon.end(), Vec3(Vec3::Zero())) /
                      static_cast<double>(contact.polygon.size());
  const double slack = kInPlane * diagonal(all.mesh);
  for (FaceId f : all.mesh.faces()) {
    if (all.pieces.part[f] != piece || turn * normal(all.mesh, f).dot(contact.plane.normal) < 1 - kInPlane) continue;
    if (std::abs(contact.plane.height(center(all.mesh, f))) < slack && holds(all.mesh, f, middle)) return f;
  }
  return std::nullopt;
}

void find_joints(ShellPieces& result) {
  for (const ShellContact& contact : result.judged.shells.contacts) {
    if (contact.polygon.size() < 3) continue;
    const std::optional<int> first = facet_at(result, contact.first, contact, 1);
    const std::optional<int> second = facet_at(result, contact.second, contact, -1);
    if (first && second)
      result.joints.push_back({contact.first, contact.second, *first, *second, contact.polygon});
    else
      result.notes.push_back(fmt::format("{} and {} touch, but in no single facet", result.pieces.names[contact.first],
                                         result.pieces.names[contact.second]));
  }
}

void note_what_is_missing(const std::vector<ShapePart>& parts, const ShellOptions& options, ShellPieces& result) {
  const Shells& shells = result.judged.shells;
  for (std::size_t i = 0; i < shells.nested.size(); ++i)
    result.notes.push_back(fmt::format("{} lies in {}: {}", parts[shells.nested[i]].name, parts[shells.hosts[i]].name,
                                       options.nested == NestedPolicy::Merge ? "merged" : "dropped"));
  for (int part : shells.lost) result.notes.push_back(fmt::format("nothing is left of {}", parts[part].name));
}

}  // namespace

ShellPieces shell_pieces(const std::vector<ShapePart>& parts, const ShellOptions& options, const Run& run) {
  run.report("parting shells", 0);
  ShellPieces result;
  result.judged = shell_shape(parts, options, run);
  if (result.judged.shells.shells.empty())
    throw InvalidInput("shells/lost", "no shell is left of any part", {}, "plico shell --nested keep");
  for (const Shell& shell : result.judged.shells.shells) result.pieces.names.push_back(parts[shell.part].name);
  make_mesh(soup_of(result.judged.shells.shells), result);
  find_joints(result);
  note_what_is_missing(parts, options, result);
  return result;
}

std::vector<ShapePart> nearly_convex_parts(const Mesh& mesh, const ConvexityOptions& options, const Run& run) {
  const Segmentation parts = segmentation_by_labels(mesh, cut_by_convexity(mesh, options, run));
  std::vector<ShapePart> shapes;
  for (const std::vector<FaceId>& faces : faces_of_parts(parts)) {
    std::set<int> corners;
    for (FaceId f : faces) corners.insert(mesh.corners(f).begin(), mesh.corners(f).end());
    ShapePart& shape = shapes.emplace_back();
    shape.name = parts.names[shapes.size() - 1];
    for (int v : corners) shape.points.push_back(mesh.point(VertexId(v)));
  }
  return shapes;
}

}  // namespace plico
