#include "plico/workflow/shell_shape.h"

namespace plico {
namespace {

PolygonSoup shell_surface(const ConvexPolyhedron& body) {
  PolygonSoup soup;
  soup.points = body.points;
  for (const ConvexPolyhedron::Facet& facet : body.facets) soup.add_face(facet.corners);
  return soup;
}

// The points of every part after merging: those of a merged part are moved to its host, smallest first as they were.
std::vector<std::vector<Vec3>> points_after_merging(const std::vector<ShapePart>& parts, const ShellOptions& options,
                                                    const Shells& shells) {
  std::vector<std::vector<Vec3>> points;
  for (const ShapePart& part : parts) points.push_back(part.points);
  if (options.nested != NestedPolicy::Merge) return points;
  for (std::size_t i = 0; i < shells.nested.size(); ++i) {
    std::vector<Vec3>& from = points[shells.nested[i]];
    std::vector<Vec3>& to = points[shells.hosts[i]];
    to.insert(to.end(), from.begin(), from.end());
    from.clear();
  }
  return points;
}

ShellsClaim claim_of(const std::vector<ShapePart>& parts, const ShellOptions& options, const Shells& shells) {
  ShellsClaim claim;
  claim.parts = points_after_merging(parts, options, shells);
  for (const Shell& shell : shells.shells) claim.shells.push_back({shell_surface(shell.body), claim.parts[shell.part]});
  for (const ShellContact& contact : shells.contacts)
    claim.contacts.push_back({contact.first, contact.second, contact.plane, contact.polygon});
  claim.loss = shells.loss();
  return claim;
}

ShellsClaim surfaces_of(const Shells& shells) {
  ShellsClaim claim;
  for (const Shell& shell : shells.shells) claim.shells.push_back({shell_surface(shell.body), {}});
  for (const ShellContact& contact : shells.contacts)
    claim.contacts.push_back({contact.first, contact.second, contact.plane, contact.polygon});
  return claim;
}

}  // namespace

JudgedShells shell_shape(const std::vector<ShapePart>& parts, const ShellOptions& options, const Run& run) {
  JudgedShells result;
  result.shells = disjoint_shells(parts, options, run);
  // Also when somebody stopped the search: what is written is judged.
  result.verdict = verify_shells(claim_of(parts, options, result.shells), {.seed = options.seed});
  return result;
}

JudgedRemeshing remesh_shells(const Shells& shells, const RemeshOptions& options, const Run& run) {
  JudgedRemeshing result;
  result.remeshing = remesh(shells, options, run);
  const ShellsClaim before = surfaces_of(shells), after = surfaces_of(result.remeshing.shells);
  result.verdict = verify_remeshed_shells({before, after, options.max_growth});
  return result;
}

std::vector<ObjObject> shell_objects(const std::vector<ShapePart>& parts, const Shells& shells) {
  std::vector<ObjObject> objects;
  for (const Shell& shell : shells.shells) objects.push_back({parts[shell.part].name, shell_surface(shell.body)});
  return objects;
}

}  // namespace plico
