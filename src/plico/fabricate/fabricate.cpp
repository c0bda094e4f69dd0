#include "plico/fabricate/fabricate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/fabricate/pieces.h"
#include "plico/fabricate/split.h"
#include "plico/geom/convex2.h"
#include "plico/geom/polygon.h"
#include "plico/geom/rectangle_fit.h"
#include "plico/mesh/segmentation.h"

namespace plico {
namespace {

using Outlines = std::vector<std::vector<std::vector<int>>>;

Unfolding in_millimetres(Unfolding net, double scale) {
  for (Vec2& v : net.sheet.vertices) v *= scale;
  net.mate.resize(net.sheet.edges.size(), -1);  // a file may name no mates
  return net;
}

std::vector<std::vector<Vec2>> part_points(const Unfolding& net) {
  std::vector<std::vector<Vec2>> points(net.num_parts());
  for (int f = 0; f < net.sheet.num_faces(); ++f)
    for (int v : net.sheet.faces[f]) points[net.part[f]].push_back(net.sheet.vertices[v]);
  return points;
}

// Parts must fit with a tab's depth to spare on both sides, which is the most that tabs can add.
// Many parts, like the pieces of a set, share pages: about kPartsAPage lie on one, not each alone on its own.
constexpr int kPartsAPage = 8;
constexpr double kShareCovered = 0.5;  // of a page, by the hulls of parts with their tabs

double scale_that_shares_pages(const Unfolding& net, const LayoutOptions& options) {
  double hulls = 0;
  for (auto& points : part_points(net)) hulls += signed_area(convex_hull(std::move(points)));
  const int pages = (net.num_parts() + kPartsAPage - 1) / kPartsAPage;
  if (net.num_parts() <= kPartsAPage || hulls <= 0) return std::numeric_limits<double>::infinity();
  return std::sqrt(kShareCovered * pages * printable(options.page).prod() / hulls);
}

// The largest scale at which every part of the net fits a page, rounded down so that the longest side of the model is a
// whole number of millimetres.
double scale_that_fills_page(const Unfolding& net, const FoldedShape& shape, const LayoutOptions& options) {
  double scale = std::numeric_limits<double>::infinity();
  for (auto& points : part_points(net))
    scale = std::min(scale, 0.999 * largest_scale(convex_hull(std::move(points)), room_without_tabs(options)));
  if (!std::isfinite(scale) || scale <= 0) return 1;
  scale = std::min(scale, scale_that_shares_pages(net, options));
  const double longest = scale * shape.size.maxCoeff();
  return longest > 2 ? scale * std::floor(longest) / longest : scale;
}

bool any_too_large(const Unfolding& net, const Vec2& room) {
  return std::ranges::any_of(part_points(net),
                             [&](const auto& points) { return !angle_that_fits(convex_hull(points), room); });
}

[[noreturn]] void throw_too_large(const std::string& part, double factor, double scale, const FoldedShape& shape,
                                  const LayoutOptions& options, bool is_panel) {
  const double longest = std::floor(10 * 0.999 * factor * scale * shape.size.maxCoeff()) / 10;
  const Vec2 page = options.page.size;
  throw InvalidInput(is_panel ? "fabricate/panel-too-large" : "fabricate/part-too-large",
                     fmt::format("{} {} does not fit a page of {:g} x {:g} mm at {:g} mm per unit",
                                 is_panel ? "a panel of part" : "part", part, page.x(), page.y(), scale),
                     {},
                     fmt::format("{} or a larger --page{}",
                                 longest > 0 ? fmt::format("use --longest {:g}mm or less", longest)
                                             : fmt::format("use --scale {:.4g} or less", 0.999 * factor * scale),
                                 is_panel ? "" : ", or --split"));
}

// Which item fits least, and by which factor it would have to shrink.
void require_fit(const std::vector<PlaceItem>& items, const Unfolding& net, const std::vector<PartTitle>& titles,
                 double scale, const FoldedShape& shape, const LayoutOptions& options) {
  std::vector<std::vector<Vec2>> bare;
  for (auto& points : part_points(net)) bare.push_back(convex_hull(std::move(points)));
  int worst = -1;
  double factor = 1;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (angle_that_fits(items[i].hull, printable(options.page))) continue;
    const double fits = std::min(1.0, largest_scale(bare[i], room_without_tabs(options)));
    if (worst < 0 || fits < factor) worst = static_cast<int>(i), factor = fits;
  }
  if (worst >= 0) throw_too_large(titles[worst].id, factor, scale, shape, options, options.split);
}

void cut_weak_folds(const LayoutOptions& options, Unfolding& net, LayoutReport& report) {
  if (options.weak_folds == WeakFolds::Keep || (options.weak_folds == WeakFolds::CutFew && !options.split)) return;
  const std::vector<char> weak = weak_folds(net, 1);
  const int cuts = static_cast<int>(std::ranges::count(weak, 1));
  if (cuts == 0 || (options.weak_folds == WeakFolds::CutFew && cuts * kPanelsACut > net.sheet.num_faces())) return;
  report.weak_folds_cut = cuts;
  net = cut_folds(net, weak);
}

// In millimetres, with the folds cut that are not to stay.
Unfolding net_to_print(const Unfolding& model_net, const LayoutOptions& options, LayoutReport& report) {
  Unfolding net = in_millimetres(model_net, report.scale);
  cut_weak_folds(options, net, report);
  if (!options.split || !any_too_large(net, room_without_tabs(options))) return net;
  const auto cut = [&](std::vector<char> cuts) {
    cuts.resize(net.sheet.edges.size(), 0);
    report.folds_cut += static_cast<int>(std::ranges::count(cuts, 1));
    net = cut_folds(net, cuts);
  };
  if (!options.cuts.empty()) cut(options.cuts);
  if (any_too_large(net, room_without_tabs(options))) cut(cuts_to_fit(NetSides(net), room_without_tabs(options)));
  return net;
}

// Items to place: every part with its tabs.
std::vector<PlaceItem> place_items(const Unfolding& net, const Tabs& tabs) {
  std::vector<PlaceItem> items(net.num_parts());
  const auto add = [](PlaceItem& item, std::vector<Vec2> piece) {
    item.hull.insert(item.hull.end(), piece.begin(), piece.end());
    item.area += std::abs(signed_area(piece));
    item.pieces.push_back(std::move(piece));
  };
  for (int f = 0; f < net.sheet.num_faces(); ++f)
    for (auto& piece : convex_pieces(polygon(net.sheet, f))) add(items[net.part[f]], std::move(piece));
  const NetSides sides(net);
  for (const NetTab& tab : tabs.tabs)
    add(items[net.part[sides.side(tab.edge).panel]], {tab.corners[1], tab.corners[0], tab.corners[3], tab.corners[2]});
  for (PlaceItem& item : items) item.hull = convex_hull(std::move(item.hull));
  return items;
}

// The direction of a panel's first side, radians.
double first_direction(const CreasePattern& sheet, int panel) {
  const std::vector<int>& corners = sheet.faces[panel];
  const Vec2 side = sheet.vertices[corners[1]] - sheet.vertices[corners[0]];
  return plico::atan2(side.y(), side.x());
}

std::vector<std::optional<Placement>> given_placements(const Unfolding& net, const std::vector<PanelPlace>& places) {
  std::vector<std::optional<Placement>> given;
  if (!places.empty()) given.resize(net.num_parts());
  for (const PanelPlace& place : places) {
    if (place.panel < 0 || place.panel >= net.sheet.num_faces())
      throw InvalidOption(fmt::format("put: panel {} must be in [0, {}]", place.panel, net.sheet.num_faces() - 1));
    if (place.page < 0 || place.page >= net.num_parts())
      throw InvalidOption(
          fmt::format("put: page {} must be in [1, {}], one a part at most", place.page + 1, net.num_parts()));
    const double angle = place.angle - first_direction(net.sheet, place.panel);
    const Vec2 corner = net.sheet.vertices[net.sheet.faces[place.panel][0]];
    given[net.part[place.panel]] = Placement{place.page, angle, place.at - rotation(angle) * corner};
  }
  return given;
}

// What given_placements() would have to be given for the parts to lie as they do.
std::vector<PanelPlace> places_of(const Unfolding& net, const std::vector<Placement>& placements) {
  std::vector<PanelPlace> places(placements.size());
  for (int f = net.sheet.num_faces() - 1; f >= 0; --f) {
    const Placement& placement = placements[net.part[f]];
    places[net.part[f]] = {f, placement.page, placement(net.sheet.vertices[net.sheet.faces[f][0]]),
                           placement.angle + first_direction(net.sheet, f)};
  }
  return places;
}

// Builds the placed parts out of the net, its tabs and where everything goes.
class Assembler {
 public:
  Assembler(const NetSides& sides, const Outlines& outlines, const Tabs& tabs, const Placed& placed,
            const FoldedShape& shape, const std::vector<PartTitle>& titles, const LayoutOptions& options)
      : sides_(sides),
        net_(sides.net()),
        outlines_(outlines),
        placed_(placed),
        shape_(shape),
        titles_(titles),
        options_(options),
        tab_of_(net_.sheet.num_edges(), nullptr) {
    for (const NetTab& tab : tabs.tabs) tab_of_[tab.edge] = &tab;
  }

  std::vector<PlacedPart> parts() {
    std::vector<PlacedPart> parts(net_.num_parts());
    for (std::size_t p = 0; p < parts.size(); ++p) {
      parts[p].part = static_cast<int>(p);
      parts[p].name = titles_[p].id;
      parts[p].title = titles_[p].name;
      parts[p].page = placed_.placements[p].page;
      add_outlines(parts[p]);
    }
    for (int f = 0; f < net_.sheet.num_faces(); ++f) {
      const Placement& at = placed_.placements[net_.part[f]];
      PlacedPanel panel{{}, sides_.edges(f), f};
      for (int v : net_.sheet.faces[f]) panel.corners.push_back(at(net_.sheet.vertices[v]));
      parts[net_.part[f]].panels.push_back(std::move(panel));
    }
    for (int e = 0; e < net_.sheet.num_edges(); ++e)
      if (sides_.side(e).panel >= 0) add_edge(parts[net_.part[sides_.side(e).panel]], e);
    return parts;
  }

 private:
  void add_outlines(PlacedPart& part) const {
    const Placement& at = placed_.placements[part.part];
    for (const auto& loop : outlines_[part.part]) {
      std::vector<Vec2> outline;
      for (int e : loop) {
        outline.push_back(at(sides_.from(sides_.side(e))));
        if (!tab_of_[e]) continue;
        const auto& [a, b, tip_b, tip_a] = tab_of_[e]->corners;
        if (a != sides_.from(sides_.side(e))) outline.push_back(at(a));
        outline.push_back(at(tip_a));
        outline.push_back(at(tip_b));
        if (b != sides_.to(sides_.side(e))) outline.push_back(at(b));
      }
      part.outlines.push_back(std::move(outline));
    }
    std::ranges::stable_sort(part.outlines, std::greater<>(), [](const auto& o) { return std::abs(signed_area(o)); });
  }

  void add_edge(PlacedPart& part, int e) const {
    const Placement& at = placed_.placements[part.part];
    const Crease& edge = net_.sheet.edges[e];
    if (sides_.is_fold(e)) {
      part.folds.push_back(
          {e, at(sides_.from(sides_.side(e))), at(sides_.to(sides_.side(e))), kind(edge), edge.fold_angle});
    } else if (tab_of_[e]) {
      Tab tab{e, net_.mate[e], tab_of_[e]->corners, seam_angle(e)};
      for (Vec2& p : tab.corners) p = at(p);
      part.tabs.push_back(tab);
    }
  }

  Assignment kind(const Crease& edge) const {
    if (edge.fold_angle == 0 && (edge.assignment == Assignment::Mountain || edge.assignment == Assignment::Valley))
      return edge.assignment;
    return assignment_of(edge.fold_angle, options_.flat);
  }

  // Not known: most seams of a model are convex.
  double seam_angle(int e) const {
    if (!shape_.seam_angle.empty() && !net_.mesh_edge.empty() && net_.mesh_edge[e] >= 0 &&
        net_.mesh_edge[e] < static_cast<int>(shape_.seam_angle.size()))
      return shape_.seam_angle[net_.mesh_edge[e]];
    if (net_.sheet.edges[e].fold_angle != 0) return net_.sheet.edges[e].fold_angle;
    return -kPi / 2;
  }

  const NetSides& sides_;
  const Unfolding& net_;
  const Outlines& outlines_;
  const Placed& placed_;
  const FoldedShape& shape_;
  const std::vector<PartTitle>& titles_;
  const LayoutOptions& options_;
  std::vector<const NetTab*> tab_of_;
};

// Turned round, 6 reads as 9 and 86 as 98: a full stop says which way up such a number stands.
std::string readable_number(int number) {
  std::string digits = fmt::format("{}", number);
  const bool turns = digits.find_first_not_of("01689") == std::string::npos;
  return turns && digits.find_first_of("69") != std::string::npos ? digits + "." : digits;
}

// The number of every edge that is glued: given, or counted walking around the parts. Seams within a part are counted
// by themselves, those between parts together.
std::vector<int> seam_numbers(const NetSides& sides, const Outlines& outlines, const std::vector<int>& given) {
  const Unfolding& net = sides.net();
  std::vector<int> number(net.sheet.num_edges());
  int between = given.empty() ? 0 : std::ranges::max(given);
  for (const auto& loops : outlines) {
    int within = 0;
    for (const auto& loop : loops)
      for (int e : loop) {
        const int mate = net.mate[e];
        if (mate < 0 || number[e] > 0) continue;
        const bool is_within = sides.part(e) == sides.part(mate);
        const int known = is_within || e >= static_cast<int>(given.size()) ? 0 : given[e];
        number[e] = number[mate] = known > 0 ? known : is_within ? ++within : ++between;
      }
  }
  return number;
}

// "12" within a part, "B12" on the edge that is glued to part B. Seams that wanted a tab and have none are marked, they
// need tape.
std::vector<std::string> seam_names(const NetSides& sides, const Outlines& outlines, const Tabs& tabs,
                                    const std::vector<PartTitle>& titles, const std::vector<int>& given) {
  const Unfolding& net = sides.net();
  std::vector<std::string> names(net.sheet.num_edges());
  const std::vector<int> number = seam_numbers(sides, outlines, given);
  for (int e = 0; e < net.sheet.num_edges(); ++e) {
    if (number[e] == 0) continue;
    const int here = sides.part(e), there = sides.part(net.mate[e]);
    names[e] = fmt::format("{}{}", here == there ? "" : titles[there].id, readable_number(number[e]));
  }
  for (int e : tabs.without)
    for (int side : {e, net.mate[e]}) names[side] += "°";
  return names;
}

// Of each part of the net, which may have been cut further: the first piece of a named part "A" is then "A.1".
std::vector<PartTitle> titles_of(const Unfolding& net, const Unfolding& before, const LayoutOptions& options) {
  std::vector<PartTitle> titles;
  if (options.titles.empty()) {
    for (int part = 0; part < net.num_parts(); ++part) titles.push_back({part_name(part), ""});
    return titles;
  }
  std::vector<int> origin(net.num_parts()), pieces(before.num_parts()), seen(before.num_parts());
  for (int f = net.sheet.num_faces() - 1; f >= 0; --f) origin[net.part[f]] = before.part[f];
  for (int from : origin) ++pieces[from];
  for (int from : origin) {
    PartTitle title = options.titles[from];
    if (pieces[from] > 1) title.id += fmt::format(".{}", ++seen[from]);
    titles.push_back(std::move(title));
  }
  return titles;
}

// Of each printed part; those that one part was cut into stay together.
std::vector<int> printed_ranks(const Unfolding& net, const Unfolding& before, const std::vector<int>& rank) {
  if (rank.empty()) return {};
  std::vector<int> result(net.num_parts());
  for (int f = 0; f < net.sheet.num_faces(); ++f) result[net.part[f]] = rank[before.part[f]];
  return result;
}

// Parts are numbered, and so lettered and laid on pages, in the order in which they are put together.
void number_by_steps(const Unfolding& before, const std::vector<int>& rank, Unfolding& net) {
  const std::vector<AssemblyStep> steps = assembly_order(NetSides(net), printed_ranks(net, before, rank));
  std::vector<int> number(net.num_parts());
  for (std::size_t i = 0; i < steps.size(); ++i) number[steps[i].part] = static_cast<int>(i);
  for (int& part : net.part) part = number[part];
}

ModelView view_of(const Unfolding& net, const FoldedShape& shape, char up) {
  ModelView view{{}, up};
  if (net.mesh_face.size() != net.sheet.faces.size()) return view;
  for (int face : net.mesh_face) {
    if (face < 0 || face >= static_cast<int>(shape.faces.size())) return {{}, up};
    view.panels.push_back(shape.faces[face]);
  }
  return view;
}

// Steps and pictures are for those who have several parts to put together.
void show_assembly(const NetSides& sides, const Unfolding& model_net, const FoldedShape& shape,
                   const LayoutOptions& options, PageLayout& layout, LayoutReport& report) {
  const Unfolding& net = sides.net();
  if (net.num_parts() < 2) return;
  report.steps = assembly_order(sides, printed_ranks(net, model_net, options.rank));
  std::vector<int> step(net.num_parts());
  for (std::size_t i = 0; i < report.steps.size(); ++i) step[report.steps[i].part] = static_cast<int>(i) + 1;
  for (PlacedPart& part : layout.parts) part.step = step[part.part];
  if (options.place.key != KeyWish::All || !options.labels.part_names) return;
  report.pages_without_picture = add_insets(layout, net, view_of(net, shape, options.size.up), step, Font());
}

int count_pages_without_ruler(const PageLayout& layout) {
  return static_cast<int>(
      std::ranges::count_if(layout.pages, [](const Page& p) { return p.key_form == KeyForm::None; }));
}

void check(const LayoutOptions& options) {
  check(options.page);
  check(options.tabs);
  check(options.labels);
  if (!(options.flat >= 0 && options.flat <= kPi / 2))
    throw InvalidOption(fmt::format("flat = {:g} deg must be in [0, 90] deg", degrees(options.flat)));
}

}  // namespace

Vec2 room_without_tabs(const LayoutOptions& options) {
  const double tab = options.tabs.side == TabSide::None ? 0 : options.tabs.depth;
  return printable(options.page) - Vec2::Constant(2 * tab);
}

double wanted_scale(const Unfolding& net, const FoldedShape& shape, const LayoutOptions& options) {
  return options.size.fill_page && !options.size.is_given() ? scale_that_fills_page(net, shape, options)
                                                            : scale_of(shape, options.size);
}

std::vector<char> page_cuts(const Unfolding& net, double scale, const LayoutOptions& options) {
  const Unfolding printed = in_millimetres(net, scale);
  if (!any_too_large(printed, room_without_tabs(options))) return {};
  return cuts_to_fit(NetSides(printed), room_without_tabs(options));
}

LayoutResult lay_out_pages(const Unfolding& model_net, const FoldedShape& shape, const LayoutOptions& options,
                           const Run& run) {
  check(options);
  LayoutResult result;
  LayoutReport& report = result.report;
  report.scale = wanted_scale(model_net, shape, options);
  report.final_size = report.scale * shape.size;
  const auto gives_up = [&] { return result.given_up = options.may_give_up && run.over(); };

  Unfolding net = net_to_print(model_net, options, report);
  number_by_steps(model_net, options.rank, net);
  const std::vector<PartTitle> titles = titles_of(net, model_net, options);
  report.hands = measure_for_hands(net, 1);
  const NetSides sides(net);
  const Outlines outlines = sides.outlines();
  if (gives_up()) return result;
  run.report("making tabs", 0);
  report.tabs = make_tabs(sides, outlines, options.tabs);

  const std::vector<PlaceItem> items = place_items(net, report.tabs);
  require_fit(items, net, titles, report.scale, shape, options);
  if (gives_up()) return result;
  const Placed placed = place(items, options.page, options.place, run, given_placements(net, options.places));
  if (gives_up()) return result;

  PageLayout& layout = result.layout;
  layout.pages = placed.pages;
  layout.scale = report.scale;
  layout.folded_size = report.final_size;
  layout.margin = options.page.margin;
  layout.has_taped_seams = options.labels.edge_ids && !report.tabs.without.empty();
  layout.parts = Assembler(sides, outlines, report.tabs, placed, shape, titles, options).parts();
  add_marks(layout, sides, outlines, options.marks);
  show_assembly(sides, model_net, shape, options, layout, report);
  run.report("writing labels", 0);
  if (gives_up()) return result;
  report.joints_unnamed = write_joints(layout, options.joints, options.joint, net.part, placed.placements, Font());
  report.edge_ids = seam_names(sides, outlines, report.tabs, titles, options.seams);
  for (const PlacedPart& part : layout.parts) report.part_names.push_back(part.name);
  for (const PlacedPart& part : layout.parts) report.page_of_part.push_back(part.page);
  report.places = places_of(net, placed.placements);
  report.printed_part = net.part;
  for (const int part : net.part) report.part_of_panel.push_back(titles[part].id);
  report.labels = add_labels(layout, report.edge_ids, Font(), options.labels, options.may_give_up ? run : Run{});
  if (gives_up()) return result;
  report.joints_without_hole = draw_joints(layout, options.joints, options.joint, net.part, placed.placements);
  report.pages = static_cast<int>(layout.pages.size());
  report.parts = static_cast<int>(layout.parts.size());
  report.fill_ratio = placed.fill_ratio;
  report.pages_without_ruler = options.place.key == KeyWish::None ? 0 : count_pages_without_ruler(layout);
  return result;
}

}  // namespace plico
