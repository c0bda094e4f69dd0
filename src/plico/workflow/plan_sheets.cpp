#include "plico/workflow/plan_sheets.h"

#include <fmt/format.h>

#include <algorithm>

#include "plico/verify/deformation.h"
#include "plico/workflow/far_motion.h"
#include "plico/workflow/plan_drawn.h"
#include "plico/workflow/plan_origami.h"

namespace plico {
namespace {

constexpr double kStripOpening = 0.2;  // of the clearance, that hinges may open by between waypoints

// One sheet of a drawing, and what its elements are there.
struct DrawnSheet {
  CreasePattern sheet;
  std::vector<int> vertices, edges, faces;
};

// Edges that border no panel belong to none.
std::vector<DrawnSheet> sheets_of(const CreasePattern& drawing, const std::vector<int>& part) {
  std::vector<DrawnSheet> sheets(1 + *std::max_element(part.begin(), part.end()));
  std::vector<int> own(drawing.vertices.size(), -1);  // number of each vertex in the sheet that is being made
  const std::vector<EdgeSides> sides = edge_sides(drawing);
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    DrawnSheet& one = sheets[s];
    std::fill(own.begin(), own.end(), -1);
    const auto own_vertex = [&](int v) {
      if (own[v] >= 0) return own[v];
      one.vertices.push_back(v);
      one.sheet.vertices.push_back(drawing.vertices[v]);
      return own[v] = one.sheet.num_vertices() - 1;
    };
    for (int e = 0; e < drawing.num_edges(); ++e) {
      const int beside = sides[e].left >= 0 ? sides[e].left : sides[e].right;
      if (beside < 0 || part[beside] != static_cast<int>(s)) continue;
      Crease& crease = one.sheet.edges.emplace_back(drawing.edges[e]);
      crease.a = own_vertex(crease.a);
      crease.b = own_vertex(crease.b);
      one.edges.push_back(e);
    }
    for (int f = 0; f < drawing.num_faces(); ++f) {
      if (part[f] != static_cast<int>(s)) continue;
      std::vector<int>& face = one.sheet.faces.emplace_back();
      for (int v : drawing.faces[f]) face.push_back(own_vertex(v));
      one.faces.push_back(f);
    }
  }
  return sheets;
}

// The drawing whose sheets are as they were folded: moved vertices and turned goals first, then the cuts of all sheets,
// which are added to `one.edges` as well.
CreasePattern put_together(const CreasePattern& drawing, std::vector<DrawnSheet>& sheets,
                           const std::vector<MotionOutcome>& outcomes) {
  CreasePattern whole = drawing;
  whole.faces.clear();
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    DrawnSheet& one = sheets[s];
    if (outcomes[s].sheet) one.sheet = *outcomes[s].sheet;
    for (std::size_t v = 0; v < one.vertices.size(); ++v) whole.vertices[one.vertices[v]] = one.sheet.vertices[v];
    for (int e = 0; e < one.sheet.num_edges(); ++e) {
      Crease crease = one.sheet.edges[e];
      crease.a = one.vertices[crease.a];
      crease.b = one.vertices[crease.b];
      if (e < static_cast<int>(one.edges.size())) {
        whole.edges[one.edges[e]] = crease;
      } else {
        one.edges.push_back(whole.num_edges());
        whole.edges.push_back(crease);
      }
    }
    for (const std::vector<int>& face : one.sheet.faces) {
      std::vector<int>& placed = whole.faces.emplace_back();
      for (int v : face) placed.push_back(one.vertices[v]);
    }
  }
  return whole;
}

// One sheet after the other, each in its part of the time.
FoldingPath one_after_the_other(const CreasePattern& whole, const std::vector<DrawnSheet>& sheets,
                                const std::vector<MotionOutcome>& outcomes) {
  const std::vector<int> hinge = hinge_of_edge(whole);
  FoldingPath path;
  Configuration config = flat(make_linkage(whole));
  path.waypoints.push_back({0, config});
  double begun = 0;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    if (!outcomes[s].proven()) continue;
    const std::vector<Waypoint>& own = outcomes[s].motions.front().path.waypoints;
    const Linkage linkage = make_linkage(sheets[s].sheet);
    for (std::size_t w = 1; w < own.size(); ++w) {
      for (int h = 0; h < linkage.num_hinges(); ++h)
        config[hinge[sheets[s].edges[linkage.hinges[h].edge]]] = own[w].config[h];
      path.waypoints.push_back({begun + own[w].time, config});
    }
    ++begun;
  }
  for (Waypoint& w : path.waypoints) w.time /= std::max(1.0, begun);
  path.waypoints.back().time = begun > 0 ? 1 : 0;
  return path;
}

// Sheets without loops have motions of few waypoints, between which the proof of sheets with loops sees them come
// apart.
void refine_strips(const std::vector<DrawnSheet>& sheets, std::vector<MotionOutcome>& outcomes, double gap,
                   const Run& run) {
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const Linkage linkage = make_linkage(sheets[s].sheet);
    if (linkage.has_loops() || !outcomes[s].proven()) continue;
    FoldingPath& path = outcomes[s].motions.front().path;
    path = refine_path(linkage, path, gap, run);
  }
}

// Of each panel of the drawing; empty when none was cut.
std::vector<double> bends_of(const CreasePattern& drawing, const std::vector<DrawnSheet>& sheets,
                             const std::vector<MotionOutcome>& outcomes) {
  std::vector<double> bends(drawing.faces.size(), 0);
  bool any = false;
  for (std::size_t s = 0; s < sheets.size(); ++s)
    for (std::size_t f = 0; f < outcomes[s].bends.size(); ++f, any = true)
      bends[sheets[s].faces[f]] = outcomes[s].bends[f];
  return any ? bends : std::vector<double>();
}

Ending worst_ending(const std::vector<MotionOutcome>& outcomes) {
  Ending worst = Ending::Found;
  for (const MotionOutcome& outcome : outcomes)
    if (outcome.ending != Ending::Found && worst != Ending::Stopped) worst = outcome.ending;
  return worst;
}

}  // namespace

MotionOutcome plan_sheets(const CreasePattern& drawing, const MotionOptions& options, const Run& run) {
  const std::vector<int> part = parts_of(drawing);
  if (part.empty() || *std::max_element(part.begin(), part.end()) == 0) return plan_drawn(drawing, options, run);
  std::vector<DrawnSheet> sheets = sheets_of(drawing, part);
  MotionOptions own = options;
  own.alternatives = 1;
  if (own.clearance <= 0) own.clearance = default_clearance(make_linkage(drawing));
  std::vector<MotionOutcome> outcomes;
  MotionOutcome result;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    outcomes.push_back(
        plan_drawn(sheets[s].sheet, own, share_of_time(run, 1.0 / static_cast<double>(sheets.size() - s + 1))));
    for (const std::string& note : outcomes.back().notes)
      result.notes.push_back(fmt::format("sheet {}: {}", s + 1, note));
  }
  const bool changed = std::any_of(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.sheet.has_value(); });
  result.bends = bends_of(drawing, sheets, outcomes);
  const CreasePattern whole = changed ? put_together(drawing, sheets, outcomes) : drawing;
  const Linkage linkage = make_linkage(whole);
  if (linkage.has_loops()) refine_strips(sheets, outcomes, kStripOpening * own.clearance, run);
  FoldingPath path = one_after_the_other(whole, sheets, outcomes);
  result.ending = worst_ending(outcomes);
  if (result.ending == Ending::Found && options.alternatives > 1) result.ending = Ending::Exhausted;  // one is made
  if (changed) result.sheet = whole;
  result.progress = 0;
  if (path.waypoints.size() < 2) return result;
  result.progress = share_of_way(linkage, path.waypoints.back().config);
  Motion motion{MotionMethod::Continuation, std::move(path), {}};
  PathProofOptions proof{.clearance = own.clearance};
  for (const MotionOutcome& outcome : outcomes) result.deformation = std::max(result.deformation, outcome.deformation);
  if (result.deformation > 0) {
    proof.clearance = deformed_clearance(own.clearance, options.deformation);
    proof.closing = kOpenOnPurpose;
  }
  motion.proof = prove_path(linkage, motion.path, proof, run);
  result.motions.push_back(std::move(motion));
  return result;
}

}  // namespace plico
