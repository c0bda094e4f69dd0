// plico info: the facts about a mesh.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/measures.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {
namespace {

struct Spread {
  double min = std::numeric_limits<double>::infinity(), max = -min, sum = 0;
  int count = 0;
  void add(double x) {
    min = std::min(min, x);
    max = std::max(max, x);
    sum += x;
    ++count;
  }
  double mean() const { return count == 0 ? 0 : sum / count; }
};

nlohmann::json to_json(const Spread& spread) {
  if (spread.count == 0) return nullptr;
  return {{"min", spread.min}, {"mean", spread.mean()}, {"max", spread.max}};
}

std::string text(const Spread& spread) {
  if (spread.count == 0) return "none";
  return fmt::format("{:.4g} to {:.4g}, mean {:.4g}", spread.min, spread.max, spread.mean());
}

struct Folds {
  Spread angle_deg;  // of the interior edges
  int mountains = 0, valleys = 0, flat = 0, boundary = 0;
};

Folds folds_of(const Mesh& mesh) {
  Folds folds;
  for (EdgeId e : mesh.edges()) {
    if (mesh.is_boundary(e)) {
      ++folds.boundary;
      continue;
    }
    const double angle = fold_angle(mesh, e);
    folds.angle_deg.add(degrees(angle));
    ++(std::abs(angle) < 1e-9 ? folds.flat : angle < 0 ? folds.mountains : folds.valleys);
  }
  return folds;
}

struct MeshFacts {
  explicit MeshFacts(const Mesh& mesh)
      : components(plico::components(mesh).count),
        genus(plico::genus(mesh)),
        boundary_loops(static_cast<int>(plico::boundary_loops(mesh).size())),
        closed(is_closed(mesh)),
        convex(is_convex(mesh)),
        folds(folds_of(mesh)),
        box(bounding_box(mesh)),
        area(surface_area(mesh)),
        volume(plico::volume(mesh)) {
    for (EdgeId e : mesh.edges()) edge_length.add(length(mesh, e));
    for (VertexId v : mesh.vertices())
      if (is_hyperbolic(mesh, v)) hyperbolic.push_back(v);
  }

  int components, genus, boundary_loops;
  bool closed, convex;
  Folds folds;
  Spread edge_length;
  std::vector<int> hyperbolic;
  Eigen::AlignedBox3d box;
  double area, volume;
};

nlohmann::json to_json(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

void fill_report(nlohmann::json& report, const Mesh& mesh, const MeshFacts& facts) {
  report["vertices"] = mesh.num_vertices();
  report["edges"] = mesh.num_edges();
  report["faces"] = mesh.num_faces();
  report["components"] = facts.components;
  report["genus"] = facts.genus;
  report["boundary_loops"] = facts.boundary_loops;
  report["closed"] = facts.closed;
  report["convex"] = facts.convex;
  report["hyperbolic_vertices"] = facts.hyperbolic;
  report["folds"] = {{"mountain", facts.folds.mountains},
                     {"valley", facts.folds.valleys},
                     {"flat", facts.folds.flat},
                     {"boundary", facts.folds.boundary}};
  report["fold_angle_deg"] = to_json(facts.folds.angle_deg);
  report["edge_length"] = to_json(facts.edge_length);
  report["surface_area"] = facts.area;
  report["volume"] = facts.closed ? nlohmann::json(facts.volume) : nlohmann::json(nullptr);
  report["bounding_box"] = {{"min", to_json(facts.box.min())}, {"max", to_json(facts.box.max())}};
}

std::string human(const std::string& path, const Mesh& mesh, const MeshFacts& facts) {
  const Vec3 size = facts.box.sizes(), low = facts.box.min();
  std::string out = fmt::format("{}: {} vertices, {} edges, {} faces\n", path, mesh.num_vertices(), mesh.num_edges(),
                                mesh.num_faces());
  const auto line = [&](const char* what, const std::string& value) { out += fmt::format("{:<20}{}\n", what, value); };
  line("surface", facts.closed ? (facts.convex ? "closed, convex" : "closed, not convex")
                               : fmt::format("open, boundary loops: {}", facts.boundary_loops));
  line("components", fmt::format("{}", facts.components));
  line("genus", fmt::format("{}", facts.genus));
  line("hyperbolic vertices", fmt::format("{}", facts.hyperbolic.size()));
  line("folds", fmt::format("{} mountain, {} valley, {} flat, {} boundary", facts.folds.mountains, facts.folds.valleys,
                            facts.folds.flat, facts.folds.boundary));
  line("fold angles", text(facts.folds.angle_deg) + " degrees (valley positive)");
  line("edge lengths", text(facts.edge_length));
  line("size", fmt::format("{:.6g} x {:.6g} x {:.6g}, from {:.6g} {:.6g} {:.6g}", size.x(), size.y(), size.z(), low.x(),
                           low.y(), low.z()));
  line("surface area", fmt::format("{:.6g}", facts.area));
  if (facts.closed) line("volume", fmt::format("{:.6g}", facts.volume));
  return out;
}

}  // namespace

Job info_job() {
  auto path = std::make_shared<std::string>();
  return Job("info", "Tell the facts about a mesh: counts, topology, fold angles, size")
      .example("plico info bunny.obj", "what it is and how large")
      .example("plico info bunny.obj --json", "the same for programs, with the ids of hyperbolic vertices")
      .example("plico info - < bunny.stl", "from standard input, the format found out")
      .positional("MESH", "OBJ, OFF, STL or PLY file; - is standard input", *path)
      .action([path](Session& session) {
        const Mesh mesh = to_mesh(read_mesh_source(session.read(*path), *path));
        const MeshFacts facts(mesh);
        fill_report(session.report(), mesh, facts);
        session.print(human(*path, mesh, facts));
        return int{kDone};
      });
}

}  // namespace plico::jobs
