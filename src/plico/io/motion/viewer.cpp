#include "plico/io/motion/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/geom/polygon.h"
#include "plico/io/motion/panel_joints.h"
#include "plico/io/motion/piece_colors.h"
#include "plico/io/text/base64.h"

namespace plico {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kTemplate =
#include "viewer_template.inc"
    ;
constexpr std::string_view kDataMark = "@DATA@";

Json list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

void add_panels(Json& data, const Linkage& linkage) {
  data["panels"] = data["triangles"] = Json::array();
  for (const auto& outline : linkage.panels) {
    Json coordinates = Json::array(), corners = Json::array();
    std::vector<Vec2> flat_outline;
    for (const Vec3& p : outline) {
      coordinates.push_back(p.x());
      coordinates.push_back(p.y());
      flat_outline.push_back(p.head<2>());
    }
    for (const auto& triangle : triangulate(flat_outline))
      for (int corner : triangle) corners.push_back(corner);
    data["panels"].push_back(std::move(coordinates));
    data["triangles"].push_back(std::move(corners));
  }
}

void add_tree(Json& data, const Linkage& linkage) {
  data["hinges"] = Json::array();
  for (const Hinge& hinge : linkage.hinges) {
    data["hinges"].push_back({{"left", hinge.left},
                              {"right", hinge.right},
                              {"from", list(hinge.from)},
                              {"to", list(hinge.to)},
                              {"target", hinge.target}});
    if (hinge.roll > 0) data["hinges"].back()["roll"] = hinge.roll;
  }
  data["order"] = linkage.order;
  data["parentPanel"] = linkage.parent_panel;
  data["parentHinge"] = linkage.parent_hinge;
  data["seams"] = Json::array();
  for (const Linkage::Seam& seam : linkage.seams)
    data["seams"].push_back({seam.panel_a, seam.side_a, seam.panel_b, seam.side_b});
}

// Numbers and letters of the pages, so that one can look up in space where a part goes, and colours.
void add_ids(Json& data, const ViewerInput& input) {
  const std::size_t n = input.linkage.panels.size();
  const auto fits = [n](const auto& list) { return list.empty() || list.size() == n; };
  if (!fits(input.side_ids) || !fits(input.part_of_panel) || !fits(input.colors))
    throw InvalidInput("viewer/ids", fmt::format("ids of {} panels for {}", input.side_ids.size(), n));
  data["sideIds"] = input.side_ids;
  data["partOf"] = input.part_of_panel;
  for (const Color& color : input.colors.empty() ? piece_colors(input.linkage) : input.colors)
    data["colors"].push_back(hex_text(color));
}

constexpr double kPageGap = 8;  // millimetres

// Where each page lies when they are shown in rows, upper left first, as a shift of its lower left corner.
std::vector<Vec2> in_rows(const std::vector<Page>& pages) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(pages.size()))));
  Vec2 largest = Vec2::Zero();
  for (const Page& page : pages) largest = largest.cwiseMax(page.size);
  std::vector<Vec2> at;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const std::size_t row = i / columns, column = i % columns;
    at.push_back(
        Vec2(static_cast<double>(column), -static_cast<double>(row)).cwiseProduct(largest + Vec2::Constant(kPageGap)));
  }
  return at;
}

// x0, y0, x1, y1, ... in thousandths of a millimetre.
template <class Points>
Json outline_of(const Points& points, const Vec2& shift) {
  Json list = Json::array();
  for (const Vec2& p : points)
    for (const double x : {p.x() + shift.x(), p.y() + shift.y()}) list.push_back(std::round(1000 * x) / 1000);
  return list;
}

const char* kind_of(const FoldLine& fold) {
  if (fold.assignment == Assignment::Flat) return "flat";
  return fold.assignment == Assignment::Valley ? "valley" : "mountain";
}

// Where its name is printed; parts too small for that have it in the middle.
Vec2 place_of_name(const PlacedPart& part) {
  for (const Label& label : part.labels)
    if (label.text == part.name || label.text.starts_with(part.name + " ") || label.text.starts_with(part.name + ","))
      return label.center;
  Eigen::AlignedBox2d box;
  for (const PlacedPanel& panel : part.panels)
    for (const Vec2& p : panel.corners) box.extend(p);
  return box.center();
}

void add_pages(Json& data, const ViewerInput& input) {
  if (!input.pages) return;
  const PageLayout& layout = *input.pages;
  const std::vector<Vec2> at = in_rows(layout.pages);
  std::vector<Json> panels(input.linkage.panels.size());
  Json paper = {{"pages", Json::array()}, {"tabs", Json::array()}, {"names", Json::array()}};
  for (const char* kind : {"mountain", "valley", "flat"}) paper["folds"][kind] = Json::array();
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec2& size = layout.pages[i].size;
    paper["pages"].push_back(outline_of(std::array{Vec2(0, 0), Vec2(size.x(), 0), size, Vec2(0, size.y())}, at[i]));
  }
  for (const PlacedPart& part : layout.parts) {
    const Vec2& shift = at.at(part.page);
    for (const PlacedPanel& panel : part.panels) panels.at(panel.panel) = outline_of(panel.corners, shift);
    for (const Tab& tab : part.tabs) paper["tabs"].push_back(outline_of(tab.corners, shift));
    for (const FoldLine& fold : part.folds)
      paper["folds"][kind_of(fold)].push_back(outline_of(std::array{fold.a, fold.b}, shift));
    if (layout.parts.size() > 1)
      paper["names"].push_back({{"text", part.name}, {"at", outline_of(std::array{place_of_name(part)}, shift)}});
  }
  if (std::ranges::any_of(panels, &Json::is_null))
    throw InvalidInput("viewer/pages", "a panel is on none of the pages");
  paper["panels"] = std::move(panels);
  data["paper"] = std::move(paper);
}

// The moment at which everything is folded.
double folded_at(const ViewerInput& input) { return input.home.empty() ? 1 : 0.7; }

// A piece turns about the middle of its panels.
void add_home(Json& data, const ViewerInput& input) {
  const Linkage& linkage = input.linkage;
  if (!input.home.empty() && static_cast<int>(input.home.size()) != linkage.num_panels())
    throw InvalidInput("viewer/home", fmt::format("{} motions for {} panels", input.home.size(), linkage.num_panels()));
  data["folded"] = folded_at(input);
  data["home"] = Json::array();
  if (input.home.empty()) return;
  const std::vector<Pose> folded = folding_map(linkage, input.path ? input.path->at(1) : goal(linkage));
  const std::vector<int> part = parts(linkage);
  std::vector<Eigen::AlignedBox3d> boxes(linkage.num_panels());
  for (int p = 0; p < linkage.num_panels(); ++p)
    for (const Vec3& corner : linkage.panels[p]) boxes[part[p]].extend(folded[p] * corner);
  for (int p = 0; p < linkage.num_panels(); ++p) {
    const Pose& home = input.home[p];
    const Vec3 centre = boxes[part[p]].center();
    const Eigen::Quaterniond turn(home.linear());
    const double sine = turn.vec().norm();
    data["home"].push_back({{"axis", list(sine > 0 ? Vec3(turn.vec() / sine) : Vec3(Vec3::UnitZ()))},
                            {"angle", 2 * plico::atan2(sine, turn.w())},
                            {"centre", list(centre)},
                            {"shift", list(home * centre - centre)}});
  }
}

void add_pictures(Json& data, const ViewerInput& input) {
  data["pictures"] = Json::array();
  for (const auto& [caption, png] : input.pictures)
    data["pictures"].push_back({{"caption", caption}, {"png", base64(png)}});
}

void add_motion(Json& data, const ViewerInput& input) {
  const FoldingPath path = input.path ? *input.path : linear_path(input.linkage);
  for (const Waypoint& waypoint : path.waypoints)
    if (waypoint.config.size() != input.linkage.num_hinges())
      throw InvalidInput("viewer/path", fmt::format("a waypoint has {} fold angles for {} hinges",
                                                    waypoint.config.size(), input.linkage.num_hinges()));
  data["keys"] = Json::array();
  for (int h = 0; h < input.linkage.num_hinges(); ++h) {
    Json times = Json::array(), angles = Json::array();
    for (const AngleKey& key : angle_keys(path, h)) {
      times.push_back(key.time * folded_at(input));
      angles.push_back(key.angle);
    }
    data["keys"].push_back({{"times", std::move(times)}, {"angles", std::move(angles)}});
  }
  data["motion"] = input.motion;
  data["start"] = std::clamp(input.start, 0.0, 1.0);
}

const char* word(ProofStatus status) {
  switch (status) {
    case ProofStatus::Unchecked:
      return "unchecked";
    case ProofStatus::Proven:
      return "proven";
    case ProofStatus::Collides:
      return "collides";
    case ProofStatus::Undecided:
      return "undecided";
  }
  PLICO_ASSERT(false);
  return "";
}

void add_proof(Json& data, const ViewerInput& input) {
  data["proof"] = {{"status", word(input.proof)}, {"note", input.proof_note}};
  data["collisions"] = Json::array();
  const int n = input.linkage.num_panels();
  for (const ViewerCollision& c : input.collisions) {
    if (c.panel_a < 0 || c.panel_a >= n || c.panel_b < 0 || c.panel_b >= n)
      throw InvalidInput("viewer/collision", fmt::format("collision of panels {} and {}, but there are {} panels",
                                                         c.panel_a, c.panel_b, n));
    data["collisions"].push_back(
        {{"begin", c.begin * folded_at(input)}, {"end", c.end * folded_at(input)}, {"panels", {c.panel_a, c.panel_b}}});
  }
}

void add_report(Json& data, const ViewerInput& input) {
  Json report;
  if (!input.report.empty()) {
    report = Json::parse(input.report, nullptr, false);
    if (!report.is_object()) throw InvalidInput("viewer/report", "the report is not a JSON object");
  }
  data["report"] = std::move(report);
  data["links"] = Json::array();
  for (const auto& [label, address] : input.links) data["links"].push_back({{"label", label}, {"href", address}});
}

// A "<" could end the script element that holds the data.
std::string safe_in_html(const std::string& json) {
  std::string safe;
  for (char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string viewer_page(const ViewerInput& input) {
  if (input.linkage.num_panels() == 0) throw InvalidInput("linkage/empty", "a linkage without panels cannot be shown");
  Json data = {{"title", input.title}, {"unit", input.unit}, {"thickness", input.linkage.thickness}};
  data["stand"] = {{"axis", list(input.stand.axis)}, {"angle", input.stand.angle}};
  add_panels(data, input.linkage);
  add_tree(data, input.linkage);
  add_ids(data, input);
  add_pages(data, input);
  add_motion(data, input);
  require_within_limits(input.linkage, input.path ? *input.path : linear_path(input.linkage));
  add_proof(data, input);
  add_home(data, input);
  add_pictures(data, input);
  add_report(data, input);
  std::string page(kTemplate);
  const std::size_t at = page.find(kDataMark);
  PLICO_ASSERT(at != std::string::npos);
  return page.replace(at, kDataMark.size(),
                      safe_in_html(data.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace)));
}

}  // namespace plico
