#include "plico/origami/closure.h"

#include <cmath>

#include "plico/base/error.h"
#include "plico/origami/loop_walk.h"

namespace plico {
namespace {

void check(const std::vector<RealVertex>& vertices, const Configuration& config) {
  for (const RealVertex& vertex : vertices)
    for (int h : vertex.hinges)
      if (h >= config.size())
        throw InvalidInput("origami/too-few-angles",
                           fmt::format("{} fold angles, crease {} asked for", config.size(), h),
                           fmt::format("vertex {}", vertex.vertex));
}

}  // namespace

Closure closure(const std::vector<RealVertex>& vertices, const Configuration& config) {
  check(vertices, config);
  Closure result;
  for (const RealVertex& vertex : vertices) {
    Eigen::Matrix<double, 6, 1> residual = Eigen::Matrix<double, 6, 1>::Zero();
    write_residual(vertex, walk_around(vertex, config, [](std::size_t, const Vec3&, const Vec3&) {}), residual.data());
    const double size = result.residual.emplace_back(residual.norm());
    if (result.worst_vertex >= 0 && size <= result.worst) continue;
    result.worst = size;
    result.worst_vertex = vertex.vertex;
  }
  return result;
}

void require_closable(const Linkage& linkage) {
  if (!linkage.has_loops()) return;
  if (linkage.thickness > 0)
    throw InvalidInput(
        "fold/thick-loops",
        fmt::format("panels {:.4g} thick cannot close around a vertex as thin ones do", linkage.thickness), {},
        "plan for a thin sheet, or cut the loops open");
  if (linkage.loops.empty())
    throw InvalidInput("fold/loops", fmt::format("{} hinges close loops, of which the linkage says nothing",
                                                 linkage.loop_hinges.size()));
}

Tear tear(const CreasePattern& sheet, const Linkage& linkage, const Configuration& config) {
  const std::vector<Pose> poses = folding_map(linkage, config);
  std::vector<std::vector<Vec3>> images(sheet.vertices.size());
  for (int f = 0; f < sheet.num_faces(); ++f)
    for (int v : sheet.faces[f]) images[v].push_back(poses[f] * Vec3(sheet.vertices[v].x(), sheet.vertices[v].y(), 0));
  Tear result;
  std::vector<Vec3> mean(images.size(), Vec3::Zero());
  const double scale = diagonal(sheet);
  for (int v = 0; v < sheet.num_vertices(); ++v) {
    for (std::size_t i = 0; i < images[v].size(); ++i) {
      mean[v] += images[v][i] / static_cast<double>(images[v].size());
      for (std::size_t j = 0; j < i; ++j) {
        const double gap = (images[v][i] - images[v][j]).norm() / scale;
        if (gap > result.gap) result.gap = gap, result.vertex = v;
      }
    }
  }
  for (int e = 0; e < sheet.num_edges(); ++e) {
    const auto [a, b] = std::pair(sheet.edges[e].a, sheet.edges[e].b);
    if (images[a].empty() || images[b].empty()) continue;
    const double length = (sheet.vertices[b] - sheet.vertices[a]).norm();
    const double change = std::abs((mean[b] - mean[a]).norm() / length - 1);
    if (change > result.deformation) result.deformation = change, result.edge = e;
  }
  return result;
}

}  // namespace plico
