#include "plico/workflow/craft.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/base/version.h"
#include "plico/fabricate/net_sides.h"
#include "plico/io/motion/png.h"
#include "plico/io/motion/viewer.h"
#include "plico/io/page/dxf.h"
#include "plico/io/page/pdf.h"
#include "plico/io/page/svg.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/pattern/fold_colors.h"
#include "plico/mesh/measures.h"
#include "plico/segment/given.h"
#include "plico/verify/joints.h"
#include "plico/workflow/kit_joints.h"
#include "plico/workflow/kit_motion.h"
#include "plico/workflow/parts_file.h"
#include "plico/workflow/show_proof.h"
#include "plico/workflow/stand.h"

namespace plico {
namespace {

// Steps of each lane that improves a net for hands, per face and at most: seconds for a usual animal. The small nets of
// a kit gain nearly all that they will in an eighth of them, and a net that will be cut for pages needs no more before
// its pieces are improved.
constexpr long kImprovingSteps = 400, kMostImprovingSteps = 150'000, kImprovingStepsOfPart = 50,
               kImprovingStepsOfPieces = 300, kMostImprovingStepsOfPieces = 50'000;

constexpr int kMostWorkedOnLate = 10'000;  // faces

// Who waits for a motion or a few pages gets them, however late; of so many panels they take longer than who stopped
// the work, or limited its time, wants to wait.
bool gives_up(const CraftResult& result, const Run& run) {
  return result.net.sheet.num_faces() > kMostWorkedOnLate && run.over();
}

std::string_view kind_of(MotionMethod method) {
  return method == MotionMethod::Linear || method == MotionMethod::Uniform ? name(method) : "planned";
}

ProvePartOptions wanted_of_parts(const CraftOptions& options) {
  ProvePartOptions wanted{.seed = options.unfold.search.seed};
  if (!options.law)
    wanted.motion = PartMotion::None;
  else
    wanted.motion = *options.law == FoldingLaw::Uniform ? PartMotion::Uniform : PartMotion::Any;
  return wanted;
}

std::vector<JointClaim> claims_of(const std::vector<Joint>& joints) {
  std::vector<JointClaim> claims;
  for (const Joint& joint : joints) claims.push_back({joint.first_face, joint.second_face, joint.polygon});
  return claims;
}

// What is asked of a better net, which folds at the size that the present one is printed at.
OptimizeOptions better_for(const CraftOptions& options, const Mesh& mesh, double scale,
                           long steps_per_face = kImprovingSteps) {
  OptimizeOptions wanted{.seed = options.unfold.search.seed,
                         .weights = weights_for(options.wish == HandWish::Page ? "page" : "hands"),
                         .starts = 4};
  wanted.steps = std::min(steps_per_face * mesh.num_faces(), kMostImprovingSteps);
  wanted.shortest_fold = kSmallEdge / scale;
  return wanted;
}

double printed_scale(const CraftOptions& options, const Mesh& mesh, const Unfolding& net) {
  LayoutOptions layout = options.layout;
  layout.size.fill_page = true;
  return wanted_scale(net, folded_shape(mesh), layout);
}

bool may_improve(const CraftOptions& options, const Mesh& mesh) {
  return options.wish != HandWish::None && mesh.num_faces() > 2 && mesh.num_faces() <= kMostToImprove;
}

std::optional<FoldingLaw> proven_law(const std::optional<Motion>& motion) {
  if (!motion || motion->proof.verdict != PathVerdict::Free) return {};
  if (motion->method == MotionMethod::Linear) return FoldingLaw::Linear;
  if (motion->method == MotionMethod::Uniform) return FoldingLaw::Uniform;
  return {};
}

// A net that folds straight gives way to a better one that does, too.
bool improve(const Mesh& mesh, const OptimizeOptions& wanted, const Run& run, Unfolding& net, NetVerdict& verdict,
             std::optional<Motion>& motion, FoldForest& forest) {
  const std::optional<FoldingLaw> law = proven_law(motion);
  if (!law || mesh.num_faces() < 3 || run.over()) return false;
  BetterNet better = better_foldable_net(mesh, forest, {.seed = wanted.seed, .law = *law}, wanted, run);
  Unfolding laid = lay_flat(mesh, better.tree);
  NetVerdict judged = verify_net(laid, mesh);
  if (!judged.is_net() || better.proof.verdict != PathVerdict::Free) return false;
  net = std::move(laid);
  verdict = std::move(judged);
  motion = Motion{motion->method, std::move(better.path), better.proof};
  forest = std::move(better.tree);
  return true;
}

void improve_parts(const Mesh& mesh, const CraftOptions& options, const Run& run, Kit& kit) {
  if (!may_improve(options, mesh)) return;
  run.report("making the nets better for hands", 0);
  const double scale = printed_scale(options, mesh, kit.net);
  bool any = false;
  for (ProvenPart& part : kit.part)
    any |= improve(part.shape.mesh, better_for(options, part.shape.mesh, scale, kImprovingStepsOfPart), run, part.net,
                   part.verdict, part.motion, part.forest);
  if (!any) return;
  Kit better = put_together(mesh, std::move(kit.parts), std::move(kit.part), run);
  better.joints = std::move(kit.joints);
  better.mirror = std::move(kit.mirror);
  better.notes = std::move(kit.notes);
  kit = std::move(better);
}

// A mesh in several pieces, or cut into parts, becomes a kit: every piece has its own net and motion.
void find_kit(const Mesh& mesh, const CraftOptions& options, const Run& run, CraftResult& result) {
  run.report("looking for nets that fold", 0);
  Kit kit;
  if (options.parts) {
    SegmentOptions cut = *options.parts;
    cut.prove = wanted_of_parts(options);
    if (options.layout.size.is_given() && cut.wish != PartsWish::Exactly)
      cut.page = PageFit{room_without_tabs(options.layout), scale_of(folded_shape(mesh), options.layout.size)};
    kit = segment_mesh(mesh, cut, run);
  } else {
    kit = make_kit(mesh, options.pieces ? *options.pieces : by_components(mesh), wanted_of_parts(options), run);
    kit.joints = options.joints;
    result.joint_defects = verify_joints(mesh, claims_of(kit.joints));
  }
  improve_parts(mesh, options, run, kit);
  result.ending = kit.ending;
  if (options.law) result.motion = motion_of_pieces(mesh, kit, run);
  if (!result.motion) result.why_no_motion = options.law ? "nothing turns" : "none was asked for";
  result.net = kit.net;
  result.verdict = kit.verdict;
  result.kit = std::move(kit);
}

// Where the net must be cut for its pages at this scale, by edge; empty where it fits or may not be.
std::vector<char> cuts_of(const CraftOptions& options, const Unfolding& net, double scale) {
  if (!options.layout.split || !options.layout.size.is_given()) return {};
  return page_cuts(net, scale, options.layout);
}

// A net that is cut to fit pages gives way to one that is cut into as many pieces, but more compact ones.
void improve_pieces(const Mesh& mesh, const CraftOptions& options, double scale, const Run& run, FoldForest& forest,
                    CraftResult& result) {
  const std::vector<char> at = cuts_of(options, result.net, scale);
  if (at.empty()) return;
  OptimizeOptions wanted = better_for(options, mesh, scale, kImprovingStepsOfPieces);
  wanted.steps = std::min(wanted.steps, kMostImprovingStepsOfPieces);
  wanted.weights.hull_area += wanted.weights.sheet_area;  // pieces share a sheet
  wanted.weights.sheet_area = 0;
  wanted.room = room_without_tabs(options.layout) / scale;
  wanted.cuts.assign(mesh.num_edges(), 0);
  for (std::size_t e = 0; e < at.size(); ++e)
    if (at[e]) wanted.cuts[result.net.mesh_edge[e]] = 1;
  if (!improve(mesh, wanted, run, result.net, result.verdict, result.motion, forest)) return;
  for (const int e : result.net.mesh_edge) result.page_cuts.push_back(e >= 0 && wanted.cuts[e]);
}

// Of the hulls of the pieces that the net is cut into for its pages.
double hulls_when_cut(const CraftOptions& options, const Unfolding& net, double scale) {
  std::vector<char> cuts = cuts_of(options, net, scale);
  cuts.resize(net.sheet.edges.size(), 0);
  return measure_for_hands(cut_folds(net, cuts), scale).hull_area;
}

// A net that is more compact as a whole is mostly so in pieces, too; where it is not, the pieces of the first are
// improved.
void improve_net(const Mesh& mesh, const CraftOptions& options, const Run& run, CraftResult& result) {
  if (!result.motion || !may_improve(options, mesh)) return;
  run.report("making the net better for hands", 0);
  FoldForest forest = forest_of(mesh, result.net);
  const double scale = printed_scale(options, mesh, result.net);
  const bool is_cut = !cuts_of(options, result.net, scale).empty();
  const OptimizeOptions wanted = better_for(options, mesh, scale, is_cut ? kImprovingStepsOfPart : kImprovingSteps);
  Unfolding net = result.net;
  NetVerdict verdict = result.verdict;
  std::optional<Motion> motion = result.motion;
  FoldForest better = forest;
  if (improve(mesh, wanted, run, net, verdict, motion, better) &&
      (!is_cut || hulls_when_cut(options, net, scale) <= hulls_when_cut(options, result.net, scale))) {
    result.net = std::move(net);
    result.verdict = std::move(verdict);
    result.motion = std::move(motion);
    forest = std::move(better);
  }
  improve_pieces(mesh, options, scale, run, forest, result);
}

// The net that folds, or the one that comes closest, replaces the one found without regard to motion.
void find_net_that_folds(const Mesh& mesh, const CraftOptions& options, const Run& run, CraftResult& result) {
  const auto time_is_over = [&] {
    if (gives_up(result, run)) result.why_no_motion = "the time was over";
    return !result.why_no_motion.empty();
  };
  if (time_is_over()) return;
  run.report("looking for a net that folds", 0);
  NetAndMotion found = fold_or_plan(mesh, {.seed = options.unfold.search.seed, .law = *options.law}, run);
  if (!found.net.crossing.empty()) {
    const auto [a, b] = found.net.crossing.front();
    result.why_no_motion =
        fmt::format("one piece cannot fold into a shape that passes through itself (faces {} and {}, {} pairs in all)",
                    a, b, found.net.crossing.size());
    return;
  }
  if (!found.motion && time_is_over()) return;  // with the net at hand
  Unfolding net = lay_flat(mesh, found.net.tree);
  NetVerdict verdict = verify_net(net, mesh);
  if (verdict.parts > 1) {  // cut short: the net at hand folds straight, or not at all
    const MotionOptions straight{.seed = options.unfold.search.seed, .may_search = false};
    result.motion = std::move(plan(linkage_of(result.net), straight, run).motions.front());
    return;
  }
  result.net = std::move(net);
  result.verdict = std::move(verdict);
  result.motion = std::move(found.motion);
}

// Where no motion is wanted, or none exists, nothing holds a better net back.
UnfoldOutcome unfold_for_hands(const Mesh& mesh, const CraftOptions& options, const Run& run) {
  UnfoldOutcome unfolded = unfold_mesh(mesh, options.unfold, run);
  if (unfolded.ending != Ending::Found || !may_improve(options, mesh)) return unfolded;
  UnfoldOptions better = options.unfold;
  better.optimize = better_for(options, mesh, printed_scale(options, mesh, unfolded.unfolding));
  return unfold_mesh(mesh, better, run);
}

void take(UnfoldOutcome unfolded, CraftResult& result) {
  result.ending = unfolded.ending;
  result.net = std::move(unfolded.unfolding);
  result.verdict = std::move(unfolded.verdict);
}

void find_net(const Mesh& mesh, const CraftOptions& options, const Run& run, CraftResult& result) {
  take(options.law ? unfold_mesh(mesh, options.unfold, run) : unfold_for_hands(mesh, options, run), result);
  if (!options.law)
    result.why_no_motion = "none was asked for";
  else if (mesh.num_faces() == 1)
    result.why_no_motion = "one panel needs none";
  else if (result.verdict.parts > 1)
    result.why_no_motion = "there is no net in one piece";
  else
    find_net_that_folds(mesh, options, run, result);
  if (options.law && !result.motion && !run.over()) take(unfold_for_hands(mesh, options, run), result);
  improve_net(mesh, options, run, result);
}

std::string fold_text(const Mesh& mesh, const CraftOptions& options, const CraftResult& result) {
  FoldFile file = result.kit ? parts_file(mesh, *result.kit) : fold_file(mesh, result.net);
  file.report = options.made_by;
  set_colors(file, panel_colors(result.paint));
  if (result.motion && !result.kit) set_path(file, linkage_of(result.net), result.motion->path);
  return write_fold(file);
}

// "assembled" of "NAME-assembled.png".
std::string caption_of(const CraftOptions& options, const std::string& file) {
  const std::size_t begin = options.name.size() + 1;
  return file.substr(begin, file.size() - begin - 4);
}

bool is_put_together(const CraftResult& result) { return result.kit && result.kit->parts.num_parts() > 1; }

// What is printed at each side of each panel.
std::vector<std::vector<std::string>> side_ids(const CraftResult& result) {
  const NetSides sides(result.net);
  std::vector<std::vector<std::string>> ids(result.net.sheet.faces.size());
  for (int p = 0; p < result.net.sheet.num_faces(); ++p)
    for (const int edge : sides.edges(p)) ids[p].push_back(result.layout.report.edge_ids[edge]);
  return ids;
}

std::string page_text(const Mesh& mesh, const CraftOptions& options, const CraftResult& result,
                      const nlohmann::json& report) {
  ViewerInput page;
  page.title = options.name;
  page.linkage = linkage_of(result.net);
  page.stand = stand_of(result.net, page.linkage, mesh, options.layout.size.up);
  page.report = report.dump();
  page.start = 1;  // the model, beside its net
  if (is_put_together(result) && result.motion)
    page.home = standing(assembled(mesh, result.net), options.layout.size.up);
  page.part_of_panel = result.layout.report.part_of_panel;
  page.side_ids = side_ids(result);
  page.pages = result.layout.layout;
  page.colors = panel_colors(result.paint);
  if (result.motion) {
    const PathProof& proof = result.motion->proof;
    page.path = result.motion->path;
    page.motion = result.motion_kind;
    show_proof(page, proof);
    page.proof_note =
        fmt::format("{} pairs of panels examined over {} intervals of time", proof.pair_intervals, proof.intervals);
  }
  for (const CraftFile& file : result.files)
    if (file.name.ends_with(".png")) page.pictures.emplace_back(caption_of(options, file.name), file.bytes);
  for (const CraftFile& file : result.files) page.links.emplace_back(file.name, file.name);
  return viewer_page(page);
}

// False when that was given up.
bool add_pages(const CraftOptions& options, const Run& run, CraftResult& result) {
  DrawOptions how = options.draw;
  if (how.title.empty()) how.title = options.name;
  const std::vector<Drawing> pages = draw(result.layout.layout, how, result.paint);
  result.files.push_back({options.name + ".pdf", write_pdf(pages, how.title, fmt::format("plico {}", version()))});
  if (options.one_svg) result.files.push_back({options.name + ".svg", write_svg(pages)});
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const std::string stem = pages.size() == 1 ? options.name : fmt::format("{}-{}", options.name, i + 1);
    if (gives_up(result, run)) return false;
    if (!options.one_svg) result.files.push_back({stem + ".svg", write_svg(pages[i])});
    if (gives_up(result, run)) return false;
    result.files.push_back({stem + ".dxf", write_dxf(pages[i])});
  }
  return !gives_up(result, run);
}

// The finished model, and its pieces apart.
void add_pictures(const Mesh& mesh, const CraftOptions& options, CraftResult& result) {
  const Linkage linkage = linkage_of(result.net);
  PictureOptions picture;
  picture.width = 900;
  picture.height = 700;
  picture.colors = panel_colors(result.paint);
  picture.home = standing(assembled(mesh, result.net), options.layout.size.up);
  result.files.push_back({options.name + "-assembled.png", render_png(linkage, goal(linkage), picture)});
  picture.home = standing(exploded(mesh, *result.kit), options.layout.size.up);
  result.files.push_back({options.name + "-exploded.png", render_png(linkage, goal(linkage), picture)});
}

LayoutOptions layout_of(const Mesh& mesh, const CraftOptions& options, const CraftResult& result) {
  LayoutOptions layout = options.layout;
  layout.size.fill_page = true;
  layout.cuts = result.page_cuts;
  layout.may_give_up = result.net.sheet.num_faces() > kMostWorkedOnLate;
  if (result.kit) {
    layout.titles = part_titles(result.kit->parts.names, result.kit->pieces);
    layout.seams = seams_of(mesh, *result.kit);
    layout.rank = assembly_steps(mesh, result.kit->parts, result.kit->joints);
    layout.joints = joint_facets(mesh, result.net, result.kit->joints, result.kit->pieces, layout.titles);
  }
  return layout;
}

// False when that was given up.
bool add_drawings(const Mesh& mesh, const CraftOptions& options, const Run& run, CraftResult& result) {
  run.report("laying out pages", 0);
  const LayoutOptions layout = layout_of(mesh, options, result);
  const FoldedShape shape = folded_shape(mesh);
  result.layout = lay_out_pages(result.net, shape, layout, run);
  if (result.layout.given_up) return false;
  result.work = hand_work(result.net, result.layout.report);
  if (result.work.too_small() && options.joints.empty())
    result.larger = larger_pages(result.net, shape, layout, result.layout.report, run);
  run.report("judging the pages", 0);
  result.layout_verdict = verify_layout(result.layout.layout);
  if (gives_up(result, run)) return false;
  run.report("drawing pages", 0);
  result.paint = panel_paint(mesh, result.net, options.paint);
  if (gives_up(result, run) || !add_pages(options, run, result)) return false;
  if (is_put_together(result)) add_pictures(mesh, options, result);
  return !gives_up(result, run);
}

void forget_drawings(CraftResult& result) {
  result.files.clear();
  result.layout = {};
  result.layout_verdict = {};
  result.work = {};
  result.larger.reset();
  result.paint = {};
}

// "step 2": "C on page 1, onto A and B". Numbers have one width, so that they sort.
nlohmann::json assembly_json(const LayoutReport& layout) {
  nlohmann::json steps = nlohmann::json::object();
  const int digits = layout.steps.size() < 10 ? 1 : layout.steps.size() < 100 ? 2 : 4;
  for (std::size_t i = 0; i < layout.steps.size(); ++i) {
    const AssemblyStep& step = layout.steps[i];
    std::string text = fmt::format("{} on page {}", layout.part_names[step.part], layout.page_of_part[step.part] + 1);
    for (std::size_t k = 0; k < step.onto.size(); ++k)
      text += fmt::format("{}{}",
                          k == 0                     ? ", onto "
                          : k + 1 < step.onto.size() ? ", "
                                                     : " and ",
                          layout.part_names[step.onto[k]]);
    steps[fmt::format("step {:0{}}", i + 1, digits)] = std::move(text);
  }
  return steps;
}

void report_pages(const CraftResult& result, nlohmann::json& report) {
  const LayoutReport& layout = result.layout.report;
  const HandWork& work = result.work;
  report["pages"] = layout.pages;
  report["printed_parts"] = layout.parts;  // more than parts of the net where some were split to fit
  report["size_mm"] = {layout.final_size.x(), layout.final_size.y(), layout.final_size.z()};
  report["scale_mm_per_unit"] = layout.scale;
  report["fill_ratio"] = layout.fill_ratio;
  report["tabs"] = layout.tabs.tabs.size();
  report["edges"] = work.edges;
  report["edges_under_5_mm"] = work.small;
  report["seams_without_tab"] = layout.tabs.omitted + layout.tabs.short_seams;
  report["edge_ids_left_out"] = work.omitted;
  report["too_small_for_hands"] = work.too_small();
  if (result.larger)
    report["large_enough"] = {{"longest_mm", result.larger->longest_mm},
                              {"pages", result.larger->pages},
                              {"edge_ids_left_out", result.larger->work.omitted},
                              {"seams_without_tab", result.larger->work.bare}};
  report["pages_verified"] = result.layout_verdict.sound();
  if (!layout.steps.empty()) report["assembly"] = assembly_json(layout);
  report["weak_folds_cut"] = layout.weak_folds_cut;
  report["hands"] = json_of(layout.hands);
}

}  // namespace

HandWish hand_wish(std::string_view name) {
  if (name == "none") return HandWish::None;
  if (name == "page") return HandWish::Page;
  if (name == "hands") return HandWish::Hands;
  throw InvalidOption(fmt::format("optimize {} is not known: hands, page or none", name));
}

CraftResult craft(const Mesh& mesh, const CraftOptions& options, const Run& run) {
  CraftResult result;
  if (options.parts || options.pieces || (options.law && components(mesh).count > 1))
    find_kit(mesh, options, run, result);
  else
    find_net(mesh, options, run, result);
  if (result.motion && !result.proven() && run.over()) result.ending = run.ending();
  if (result.motion) result.motion_kind = kind_of(result.motion->method);
  result.drawn = !gives_up(result, run) && add_drawings(mesh, options, run, result);
  if (!result.drawn) {
    forget_drawings(result);
    result.ending = run.ending();
  }
  result.files.push_back({options.name + ".fold", fold_text(mesh, options, result)});
  const nlohmann::json report = craft_report(mesh, result);
  result.files.push_back({"report.json", report.dump(2) + "\n"});
  if (result.drawn) result.files.push_back({"index.html", page_text(mesh, options, result, report)});
  return result;
}

nlohmann::json craft_report(const Mesh& mesh, const CraftResult& result) {
  nlohmann::json report = {
      {"faces", mesh.num_faces()},
      {"components", components(mesh).count},
      {"ending", name(result.ending)},
      {"parts", result.verdict.parts},
      {"net_verified", result.verdict.valid()},
      {"overlaps", result.verdict.overlaps.count},
  };
  if (result.drawn) report_pages(result, report);
  if (result.kit) report["pieces"] = parts_json(mesh, *result.kit);
  if (result.kit && !result.kit->joints.empty()) {
    report["joints"] = joints_json(*result.kit);
    report["joints_verified"] = result.joint_defects.empty();
    report["joints_too_small_for_text"] = result.layout.report.joints_unnamed;
    report["joints_too_small_for_rivet"] = result.layout.report.joints_without_hole;
  }
  if (result.motion)
    report["motion"] = {{"kind", result.motion_kind},
                        {"verdict", name(result.motion->proof.verdict)},
                        {"waypoints", result.motion->path.waypoints.size()}};
  else
    report["no_motion"] = result.why_no_motion;
  return report;
}

}  // namespace plico
