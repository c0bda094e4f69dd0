#include "plico/verify/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "plico/mesh/measures.h"

namespace plico {
namespace {

class PartsCheck {
 public:
  PartsCheck(const PartsClaim& claim, const Unfolding& net, const Mesh& mesh) : claim_(claim), net_(net), mesh_(mesh) {}

  PartsVerdict run(const Run& run) {
    verdict_.net = verify_net(net_, mesh_, {}, run);
    verdict_.parts = static_cast<int>(claim_.faces.size());
    const bool sizes = claim_.names.size() == claim_.faces.size() && claim_.pieces.size() == claim_.faces.size() &&
                       claim_.seam.size() == net_.sheet.edges.size();
    if (!sizes) defect("parts/numbers", "the file does not say for every part and edge what belongs to it");
    check_names();
    if (check_faces()) {
      check_connected();
      if (sizes) check_pieces();
      if (sizes && verdict_.net.valid()) check_seams();
      check_joints();
    }
    check_order();
    return std::move(verdict_);
  }

 private:
  void defect(const std::string& code, std::string message) {
    constexpr int kShown = 5;
    if (++count_[code] <= kShown) verdict_.defects.push_back({code, std::move(message)});
  }

  void check_names() {
    std::set<std::string> seen;
    for (const std::string& name : claim_.names) {
      if (name.empty()) defect("parts/name", "a part has no name");
      if (!seen.insert(name).second) defect("parts/name", fmt::format("two parts are called {}", name));
    }
  }

  // Fills part_; false when the parts are no partition of the faces.
  bool check_faces() {
    part_.assign(mesh_.num_faces(), -1);
    for (std::size_t p = 0; p < claim_.faces.size(); ++p) {
      if (claim_.faces[p].empty()) defect("parts/faces", fmt::format("part {} has no face", p));
      for (int f : claim_.faces[p]) {
        if (f < 0 || f >= mesh_.num_faces())
          defect("parts/faces", fmt::format("part {} names face {}, the mesh has {}", p, f, mesh_.num_faces()));
        else if (part_[f] >= 0)
          defect("parts/faces", fmt::format("face {} is in parts {} and {}", f, part_[f], p));
        else
          part_[f] = static_cast<int>(p);
      }
    }
    for (FaceId f : mesh_.faces())
      if (part_[f] < 0) defect("parts/faces", fmt::format("face {} is in no part", int(f)));
    return !count_.contains("parts/faces");
  }

  // Faces reached from the first one of their part, part by part.
  void check_connected() {
    std::vector<char> reached(mesh_.num_faces(), 0);
    for (std::size_t p = 0; p < claim_.faces.size(); ++p) {
      std::vector<int> queue{claim_.faces[p][0]};
      reached[queue[0]] = 1;
      std::size_t done = 0;
      for (; done < queue.size(); ++done)
        for (HalfedgeId h : mesh_.halfedges(FaceId(queue[done])))
          if (const HalfedgeId g = mesh_.twin(h); g.valid() && part_[mesh_.face(g)] == static_cast<int>(p))
            if (!reached[mesh_.face(g)]) reached[mesh_.face(g)] = 1, queue.push_back(mesh_.face(g));
      if (done != claim_.faces[p].size())
        defect("parts/connected", fmt::format("part {} is not connected: {} of its {} faces hang together",
                                              name(static_cast<int>(p)), done, claim_.faces[p].size()));
    }
  }

  // The steps of all parts are 1, 2, ... in some order.
  void check_order() {
    if (claim_.steps.empty()) return;
    const int parts = static_cast<int>(claim_.names.size());
    std::vector<int> at(parts + 1, -1);
    for (int p = 0; p < static_cast<int>(claim_.steps.size()); ++p) {
      const int step = claim_.steps[p];
      if (step < 1 || step > parts)
        defect("parts/order", fmt::format("part {} is step {} of {}", name(p), step, parts));
      else if (at[step] >= 0)
        defect("parts/order", fmt::format("parts {} and {} are both step {}", name(at[step]), name(p), step));
      else
        at[step] = p;
    }
  }

  void check_joints() {
    for (Defect& found : verify_joints(mesh_, claim_.joints)) defect(found.code, std::move(found.message));
    verdict_.joints = static_cast<int>(claim_.joints.size());
    for (std::size_t j = 0; j < claim_.joints.size(); ++j) {
      const JointClaim& joint = claim_.joints[j];
      check_side(j + 1, joint.first_face, joint.first);
      check_side(j + 1, joint.second_face, joint.second);
      if (joint.first >= 0 && joint.first == joint.second)
        defect("joint/part", fmt::format("joint {} glues part {} to itself", j + 1, name(joint.first)));
    }
  }

  void check_side(std::size_t joint, int face, int part) {
    if (part < 0 || face < 0 || face >= mesh_.num_faces() || part_[face] == part) return;
    defect("joint/part", fmt::format("joint {} says that face {} is of part {}, it is of {}", joint, face, name(part),
                                     name(part_[face])));
  }

  // For messages.
  std::string name(int part) const {
    return part < static_cast<int>(claim_.names.size()) ? claim_.names[part] : std::to_string(part);
  }

  // A piece is called "head", or "head.2" when it is one of several.
  void check_alone(int part, int nth, int piece) {
    if (piece >= static_cast<int>(claim_.alone.size())) return;
    const PartsClaim::Piece& alone = claim_.alone[piece];
    const std::string wanted = claim_.pieces[part].size() == 1 ? name(part) : fmt::format("{}.{}", name(part), nth + 1);
    if (alone.title != wanted)
      defect("parts/title", fmt::format("piece {} is called {}, but is {}", piece, alone.title, wanted));
    const bool said = part < static_cast<int>(claim_.folds.size()) && claim_.folds[part];
    if (said && !alone.moves && std::ranges::count(net_.part, piece) > 1)
      defect("parts/motion", fmt::format("part {} is said to fold, but {} has no motion", name(part), wanted));
  }

  void check_pieces() {
    std::vector<int> owner(net_.num_parts(), -1);
    for (std::size_t p = 0; p < claim_.pieces.size(); ++p)
      for (int piece : claim_.pieces[p]) {
        if (piece < 0 || piece >= net_.num_parts() || owner[piece] >= 0)
          return defect("parts/pieces",
                        fmt::format("part {} names piece {} of the net, which it does not have", p, piece));
        owner[piece] = static_cast<int>(p);
      }
    for (int f = 0; f < net_.sheet.num_faces(); ++f)
      if (const int g = net_.mesh_face[f]; g < 0 || g >= mesh_.num_faces() || owner[net_.part[f]] != part_[g])
        defect("parts/pieces", fmt::format("panel {} lies in a piece of another part", f));
    for (std::size_t p = 0; p < claim_.pieces.size(); ++p) {
      const std::vector<int>& pieces = claim_.pieces[p];
      verdict_.in_one_piece += pieces.size() == 1;
      for (std::size_t i = 0; i < pieces.size(); ++i) check_alone(static_cast<int>(p), static_cast<int>(i), pieces[i]);
    }
  }

  // Which part each copy of a seam edge belongs to is asked of the panels, not of the mesh edges the file names.
  void check_seams() {
    std::map<std::pair<int, int>, int> panel_beside;  // a side, as it runs around its panel
    for (int f = 0; f < net_.sheet.num_faces(); ++f) {
      const std::vector<int>& face = net_.sheet.faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) panel_beside[{face[i], face[(i + 1) % face.size()]}] = f;
    }
    const auto part_beside = [&](int e) {
      const Crease& crease = net_.sheet.edges[e];
      auto at = panel_beside.find({crease.a, crease.b});
      if (at == panel_beside.end()) at = panel_beside.find({crease.b, crease.a});
      return part_[net_.mesh_face[at->second]];
    };
    std::map<int, std::vector<int>> edges_of;
    for (int e = 0; e < net_.sheet.num_edges(); ++e) {
      const int mate = net_.mate.empty() ? -1 : net_.mate[e];
      const bool seam = mate >= 0 && part_beside(e) != part_beside(mate);
      if (seam != (claim_.seam[e] > 0))
        defect("parts/seam",
               fmt::format("edge {} {}", e, seam ? "is a seam without a number" : "has a number but is no seam"));
      if (claim_.seam[e] > 0) edges_of[claim_.seam[e]].push_back(e);
      if (seam && e < mate) count_seam(e, mate);
    }
    int between = 0;
    for (EdgeId e : mesh_.edges())
      if (const HalfedgeId h = mesh_.halfedge(e), g = mesh_.twin(h); h.valid() && g.valid())
        between += part_[mesh_.face(h)] != part_[mesh_.face(g)];
    if (between != verdict_.seam_edges)
      defect("parts/seam",
             fmt::format("{} edges of the mesh lie between parts, {} are glued", between, verdict_.seam_edges));
    for (const auto& [number, edges] : edges_of)
      if (edges.size() != 2 || net_.mate.empty() || net_.mate[edges[0]] != edges[1])
        defect("parts/seam", fmt::format("seam {} is not on two edges that are glued together", number));
  }

  double flat_length(int e) const {
    const Crease& crease = net_.sheet.edges[e];
    return (net_.sheet.vertices[crease.a] - net_.sheet.vertices[crease.b]).norm();
  }

  void count_seam(int e, int mate) {
    const double one = flat_length(e), other = flat_length(mate);
    if (!(std::abs(one - other) <= 1e-9 * verdict_.net.scale * diagonal(mesh_)))
      defect("parts/seam", fmt::format("edges {} and {} are glued but not equally long", e, mate));
    ++verdict_.seam_edges;
    verdict_.seam_length += one / verdict_.net.scale;
  }

  const PartsClaim& claim_;
  const Unfolding& net_;
  const Mesh& mesh_;
  std::vector<int> part_;  // of each mesh face
  std::map<std::string, int> count_;
  PartsVerdict verdict_;
};

}  // namespace

PartsVerdict verify_parts(const PartsClaim& claim, const Unfolding& net, const Mesh& mesh, const Run& run) {
  return PartsCheck(claim, net, mesh).run(run);
}

}  // namespace plico
