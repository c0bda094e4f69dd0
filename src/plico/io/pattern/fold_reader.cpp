// read_fold: from JSON to a FoldFile.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "plico/base/error.h"
#include "plico/geom/polygon.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/pattern/fold_frames.h"
#include "plico/io/text/parse_json.h"

namespace plico {
namespace fold_json {
namespace {

bool lists(const Json& frame, const char* key, const char* word) {
  const Json* list = member(frame, key);
  return list && list->is_array() && std::find(list->begin(), list->end(), word) != list->end();
}

bool has_points(const Frame& frame) {
  const Json* coords = frame.find("vertices_coords");
  return coords && coords->is_array() && !coords->empty();
}

bool is_called_folded(const Frame& frame) {
  return lists(frame.own(), "frame_classes", "foldedForm") && !lists(frame.own(), "frame_classes", "creasePattern");
}

bool is_flat_sheet(const Frame& frame) {
  if (!has_points(frame) || is_called_folded(frame)) return false;
  const Json& coords = *frame.find("vertices_coords");
  return std::all_of(coords.begin(), coords.end(), [](const Json& row) {
    return !row.is_array() || row.size() < 3 || (row[2].is_number() && row[2].get<double>() == 0);
  });
}

// No panel lies on its back, as some do in every form that is folded flat.
bool all_panels_face_one_way(const Frame& frame, const std::vector<Vec3>& at, const SheetPlane& plane) {
  const Json* faces = frame.array("faces_vertices");
  if (!faces) return true;
  int front = 0, back = 0;
  for (std::size_t f = 0; f < faces->size(); ++f) {
    std::vector<Vec2> corners;
    if (!(*faces)[f].is_array()) return false;
    for (const Json& v : (*faces)[f])
      corners.push_back(in_plane(at[index(v, static_cast<int>(at.size()), frame, "faces_vertices", f)], plane));
    const double area = corners.size() < 3 ? 0 : signed_area(corners);
    front += area > 0, back += area < 0;
  }
  return front == 0 || back == 0;
}

// Called folded, or in another plane, but flat all the same.
bool is_flat_after_all(const Frame& frame) {
  if (!has_points(frame)) return false;
  const std::vector<Vec3> at = points(frame);
  const std::optional<SheetPlane> plane = sheet_plane(at);
  return plane && all_panels_face_one_way(frame, at, *plane);
}

std::size_t sheet_frame(const std::vector<Frame>& all) {
  const auto at = std::find_if(all.begin(), all.end(), is_flat_sheet);
  if (at != all.end()) return static_cast<std::size_t>(at - all.begin());
  const auto other = std::find_if(all.begin(), all.end(), is_flat_after_all);
  if (other != all.end()) return static_cast<std::size_t>(other - all.begin());
  const bool any =
      std::any_of(all.begin(), all.end(), [](const Frame& f) { return f.find("vertices_coords") != nullptr; });
  if (any)
    fail("no-sheet", "the file holds only folded forms, no flat sheet", "vertices_coords",
         "export the crease pattern as well");
  fail("no-sheet", "no frame has vertices_coords", "vertices_coords");
}

std::vector<std::string> assumed(const SheetPlane& plane) {
  std::vector<std::string> notes;
  if (plane.axis < 0)
    notes.emplace_back("the sheet lies in a tilted plane and was laid into that of x and y");
  else if (plane.axis < 2)
    notes.push_back(fmt::format("the sheet lies in the plane of {} and was laid into that of x and y",
                                plane.axis == 0 ? "y and z" : "x and z"));
  if (plane.off > 0 && plane.axis >= 0)
    notes.push_back(fmt::format("the sheet is flat but for {:.2g}, which was left out", plane.off));
  return notes;
}

std::vector<std::string> assumed(const Frame& frame, const CreasePattern& sheet) {
  std::vector<std::string> notes;
  if (is_called_folded(frame))
    notes.emplace_back("the frame is called a folded form but is flat: it was taken for the sheet");
  for (std::string& note : assumed(sheet_plane(points(frame)).value_or(SheetPlane()))) notes.push_back(std::move(note));
  const std::vector<EdgeSides> sides = edge_sides(sheet);
  int free = 0;
  for (std::size_t e = 0; e < sides.size(); ++e)
    free += sheet.edges[e].assignment == Assignment::Unassigned && is_hinge(sheet.edges[e], sides[e]);
  if (free > 0)
    notes.push_back(fmt::format("{} crease{} no assignment: {} freely, without a goal", free,
                                free == 1 ? " has" : "s have", free == 1 ? "it turns" : "they turn"));
  return notes;
}

void check_version(const Json& root) {
  const Json* spec = member(root, "file_spec");
  if (!spec || !spec->is_number() || spec->get<double>() < 2) return;
  fail("version", fmt::format("file_spec is {}, versions below 2 can be read", spec->dump()), "file_spec");
}

// The keys of the sheet that are read into values; all others are kept as text.
bool is_ours(const std::string& key) {
  static const std::set<std::string> keys{"file_spec",
                                          "file_creator",
                                          "file_classes",
                                          "file_frames",
                                          "frame_classes",
                                          "frame_attributes",
                                          "frame_unit",
                                          "frame_parent",
                                          "frame_inherit",
                                          "vertices_coords",
                                          "vertices_plico:mesh_vertex",
                                          "edges_vertices",
                                          "edges_assignment",
                                          "edges_foldAngle",
                                          "edges_foldAngles",
                                          "edges_plico:mate",
                                          "edges_plico:maxFoldAngle",
                                          "faces_vertices",
                                          "faces_plico:mesh_face",
                                          "faces_plico:part",
                                          "plico:report"};
  return keys.contains(key);
}

void keep_other_keys(const Json& sheet, FoldFile& file) {
  for (const auto& [key, value] : sheet.items())
    if (!is_ours(key)) file.other.emplace_back(key, value.dump());
}

// The sheet in frame `chosen` becomes the key frame and the key frame takes its place, so every other frame keeps its
// number; what frame `number` says about its parent follows. (A key frame has no parent, whatever it says.)
Json swapped_frame(const Json& frame, std::size_t number, std::size_t chosen) {
  const bool was_key = number == chosen;
  Json kept = Json::object();
  for (const auto& [key, value] : frame.items())
    if (!key.starts_with("file_") && !(was_key && (key == "frame_parent" || key == "frame_inherit"))) kept[key] = value;
  if (was_key) return kept;
  const bool inherits = kept.value("frame_inherit", Json()) == Json(true);
  const Json parent = kept.value("frame_parent", inherits ? Json(0) : Json());
  if (parent == Json(0)) kept["frame_parent"] = chosen;
  if (parent == Json(chosen)) kept["frame_parent"] = 0;
  return kept;
}

}  // namespace
}  // namespace fold_json

FoldFile read_fold(std::string_view bytes, const std::string& name) {
  using namespace fold_json;
  const Json root = parse_json(bytes, name, "fold");
  if (!root.is_object()) fail("json", "a FOLD file is a JSON object", name);
  check_version(root);
  const std::vector<Frame> all = frames(root);
  const std::size_t chosen = sheet_frame(all);
  const Frame& frame = all[chosen];
  FoldFile file;
  file.net = read_net(frame);
  file.notes = assumed(frame, file.net.sheet);
  if (const Json* unit = frame.find("frame_unit"); unit && unit->is_string()) file.unit = unit->get<std::string>();
  if (const Json* report = member(root, "plico:report")) file.report = report->dump();
  if (chosen == 0) {
    keep_other_keys(root, file);
    for (std::size_t i = read_motion(all, file); i < all.size(); ++i) file.other_frames.push_back(all[i].own().dump());
    return file;
  }
  const auto says = [&](const char* key) {
    return std::any_of(all.begin(), all.end(), [&](const Frame& f) { return f.own().contains(key); });
  };
  if (says("plico:time") || says("plico:piece"))
    fail("motion", "a file with a motion, or with pieces, has its flat sheet as the key frame",
         frame.at("vertices_coords"));
  keep_other_keys(frame.flattened(), file);
  for (const auto& [key, value] : root.items())
    if (key.starts_with("file_") && !is_ours(key)) file.other.emplace_back(key, value.dump());
  std::sort(file.other.begin(), file.other.end());
  for (std::size_t i = 1; i < all.size(); ++i)
    file.other_frames.push_back(swapped_frame(all[i == chosen ? 0 : i].own(), i, chosen).dump());
  return file;
}

}  // namespace plico
