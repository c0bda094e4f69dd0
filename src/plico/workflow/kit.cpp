#include "plico/workflow/kit.h"

#include <algorithm>

#include "plico/mesh/measures.h"
#include "plico/segment/seams.h"

namespace plico {
namespace {

// The pieces of the whole net are numbered part by part.
void number_pieces(Kit& result) {
  Unfolding& net = result.net;
  std::vector<int> part_of_piece(net.num_parts());
  for (std::size_t p = 0; p < net.part.size(); ++p) part_of_piece[net.part[p]] = result.parts.part[net.mesh_face[p]];
  std::vector<int> order(part_of_piece.size()), number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return part_of_piece[i] < part_of_piece[j]; });
  result.pieces.resize(result.parts.num_parts());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[order[i]] = static_cast<int>(i);
    result.pieces[part_of_piece[order[i]]].push_back(static_cast<int>(i));
  }
  for (int& piece : net.part) piece = number[piece];
}

void join_nets(const Mesh& mesh, Kit& result) {
  FoldForest all{std::vector<char>(mesh.num_edges(), 0)};
  for (const ProvenPart& part : result.part)
    for (std::size_t e = 0; e < part.shape.edge.size(); ++e)
      if (part.forest.is_fold[e]) all.is_fold[part.shape.edge[e]] = 1;
  result.net = lay_flat(mesh, all);
  number_pieces(result);
  // The judge is never cut short: whatever is returned has been judged.
  result.verdict = verify_net(result.net, mesh);
}

double length_around(const std::vector<Vec3>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  return sum;
}

// Axes of a plane polygon: origin at the first corner, x along the first side, z its normal (Newell).
Pose frame_of(const std::vector<Vec3>& polygon) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += (polygon[i] - polygon[0]).cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
  Pose frame = Pose::Identity();
  const Vec3 z = normal.normalized();
  const Vec3 side = polygon[1] - polygon[0];
  const Vec3 x = (side - side.dot(z) * z).normalized();
  frame.linear().col(0) = x;
  frame.linear().col(1) = z.cross(x);
  frame.linear().col(2) = z;
  frame.translation() = polygon[0];
  return frame;
}

}  // namespace

int Kit::num_proven() const {
  return static_cast<int>(std::count_if(part.begin(), part.end(), [](const ProvenPart& p) { return p.proven(); }));
}

Kit make_kit(const Mesh& mesh, Segmentation parts, const ProvePartOptions& options, const Run& run) {
  const std::vector<std::vector<FaceId>> faces = faces_of_parts(parts);
  std::vector<ProvenPart> proven(faces.size());
  Run alone = run;
  alone.threads = 1;
  alone.progress = nullptr;  // parts are worked on side by side
  parallel_for(run, parts.num_parts(), [&](int i) { proven[i] = prove_part(mesh, faces[i], options, alone); });
  return put_together(mesh, std::move(parts), std::move(proven), run);
}

Kit put_together(const Mesh& mesh, Segmentation parts, std::vector<ProvenPart> proven, const Run& run) {
  Kit result;
  result.parts = std::move(parts);
  result.part = std::move(proven);
  join_nets(mesh, result);
  const bool all = result.num_proven() == result.parts.num_parts() && result.verdict.valid();
  result.ending = all ? Ending::Found : run.over() ? run.ending() : Ending::Exhausted;
  return result;
}

std::vector<int> assembly_steps(const Mesh& mesh, const Segmentation& parts, const std::vector<Joint>& joints) {
  std::vector<SeamLength> seams = seam_lengths(mesh, parts);
  for (const Joint& joint : joints) seams.push_back({joint.first, joint.second, length_around(joint.polygon)});
  std::vector<int> step(parts.num_parts(), 0);
  std::vector<double> area_of(parts.num_parts(), 0), joined(parts.num_parts(), 0);
  for (FaceId f : mesh.faces()) area_of[parts.part[f]] += area(mesh, f);
  for (int next = 1; next <= parts.num_parts(); ++next) {
    int best = -1;
    for (int p = 0; p < parts.num_parts(); ++p) {
      if (step[p] > 0) continue;
      if (best < 0 || joined[p] > joined[best] || (joined[p] == joined[best] && area_of[p] > area_of[best])) best = p;
    }
    step[best] = next;
    for (const SeamLength& seam : seams) {
      if (seam.a == best) joined[seam.b] += seam.length;
      if (seam.b == best) joined[seam.a] += seam.length;
    }
  }
  return step;
}

std::vector<Pose> assembled(const Mesh& mesh, const Unfolding& net) {
  const Linkage linkage = linkage_of(net);
  const std::vector<Pose> folded = folding_map(linkage, goal(linkage));
  std::vector<Pose> home;
  for (int p = 0; p < linkage.num_panels(); ++p) {
    std::vector<Vec3> here, there;
    for (const Vec3& corner : linkage.panels[p]) here.push_back(folded[p] * corner);
    for (int v : mesh.corners(FaceId(net.mesh_face[p]))) there.push_back(mesh.point(VertexId(v)));
    home.push_back(frame_of(there) * frame_of(here).inverse());
  }
  return home;
}

std::vector<Pose> exploded(const Mesh& mesh, const Kit& kit, double share) {
  const Vec3 middle = bounding_box(mesh).center();
  std::vector<Eigen::AlignedBox3d> boxes(kit.parts.num_parts());
  for (FaceId f : mesh.faces())
    for (int v : mesh.corners(f)) boxes[kit.parts.part[f]].extend(mesh.point(VertexId(v)));
  std::vector<Pose> poses = assembled(mesh, kit.net);
  for (std::size_t p = 0; p < poses.size(); ++p)
    poses[p].pretranslate(share * (boxes[kit.parts.part[kit.net.mesh_face[p]]].center() - middle));
  return poses;
}

}  // namespace plico
