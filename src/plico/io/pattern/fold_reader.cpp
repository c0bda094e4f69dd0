// read_fold: from JSON to a FoldFile.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "plico/base/error.h"
#include "plico/fold/planar_faces.h"
#include "plico/geom/polygon.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/text/parse_json.h"

namespace plico {
namespace {

using Json = nlohmann::json;

constexpr double kMaxCoordinate = 1e30;  // as for meshes: products of six must stay finite

[[noreturn]] void fail(const std::string& code, const std::string& message, const std::string& where,
                       const std::string& suggestion = {}) {
  throw InvalidInput("fold/" + code, message, where, suggestion);
}

// ---- JSON --------------------------------------------------------------------------------------------------------

const Json* member(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

bool lists(const Json& frame, const char* key, const char* word) {
  const Json* list = member(frame, key);
  return list && list->is_array() && std::find(list->begin(), list->end(), word) != list->end();
}

// ---- Frames ------------------------------------------------------------------------------------------------------

// A frame with the frames it inherits from, nearest first.
class Frame {
 public:
  Frame(std::string where, std::vector<const Json*> chain) : where_(std::move(where)), chain_(std::move(chain)) {}

  const Json& own() const { return *chain_[0]; }
  std::string at(const std::string& key) const { return where_ + key; }

  // The value of a key, inherited or not; null when there is none.
  const Json* find(const char* key) const {
    for (const Json* frame : chain_)
      if (const Json* value = member(*frame, key)) return value;
    return nullptr;
  }

  // The array under a key, which must have `size` entries when that is not negative; null when there is none.
  const Json* array(const char* key, int size = -1) const {
    const Json* value = find(key);
    if (!value) return nullptr;
    if (!value->is_array()) fail("type", fmt::format("{} is not an array", key), at(key));
    if (value->size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4)
      fail("size", fmt::format("{} has too many entries", key), at(key));
    if (size >= 0 && static_cast<int>(value->size()) != size)
      fail("length", fmt::format("{} has {} entries, {} are needed", key, value->size(), size), at(key));
    return value;
  }

  std::string entry(const char* key, std::size_t i) const { return fmt::format("{}{}[{}]", where_, key, i); }

  // One object with everything the frame says, standing on its own.
  Json flattened() const {
    Json all = Json::object();
    for (const Json* frame : chain_)
      for (const auto& [key, value] : frame->items())
        if (!key.starts_with("file_") && key != "frame_parent" && key != "frame_inherit" && !all.contains(key))
          all[key] = value;
    return all;
  }

 private:
  std::string where_;
  std::vector<const Json*> chain_;
};

double number(const Json& value, const Frame& frame, const char* key, std::size_t i) {
  if (!value.is_number())
    fail("type", fmt::format("{} holds something that is not a number", key), frame.entry(key, i));
  const double x = value.get<double>();
  if (!std::isfinite(x)) fail("number", fmt::format("{} holds an infinite number", key), frame.entry(key, i));
  return x;
}

int index(const Json& value, int limit, const Frame& frame, const char* key, std::size_t i) {
  if (!value.is_number_integer())
    fail("type", fmt::format("{} holds something that is not an index", key), frame.entry(key, i));
  const bool fits = value.is_number_unsigned() ? value.get<std::uint64_t>() < static_cast<std::uint64_t>(limit) : false;
  if (!fits)
    fail("index", fmt::format("{} holds index {}, must be in [0, {}]", key, value.dump(), limit - 1),
         frame.entry(key, i));
  return static_cast<int>(value.get<std::uint64_t>());
}

std::vector<int> indices(const Frame& frame, const char* key, int size, int limit) {
  std::vector<int> result;
  const Json* array = frame.array(key, size);
  for (std::size_t i = 0; array && i < array->size(); ++i) result.push_back(index((*array)[i], limit, frame, key, i));
  return result;
}

// n x 3; a missing z is 0. Empty when the frame has no coordinates.
std::vector<Vec3> points(const Frame& frame, int size = -1) {
  const char* key = "vertices_coords";
  std::vector<Vec3> result;
  const Json* array = frame.array(key, size);
  for (std::size_t i = 0; array && i < array->size(); ++i) {
    const Json& row = (*array)[i];
    if (!row.is_array() || row.size() < 2 || row.size() > 3)
      fail("coordinates", "a vertex needs 2 or 3 coordinates", frame.entry(key, i));
    Vec3 p(0, 0, 0);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double x = number(row[k], frame, key, i);
      if (std::abs(x) > kMaxCoordinate)
        fail("number", fmt::format("{} holds {}, must be at most {}", key, x, kMaxCoordinate), frame.entry(key, i));
      p[static_cast<int>(k)] = x;
    }
    result.push_back(p);
  }
  return result;
}

// Frame 0 is the key frame, frame i + 1 is file_frames[i].
std::vector<Frame> frames(const Json& root) {
  constexpr std::size_t kLongestChain = 64;
  std::vector<const Json*> all{&root};
  if (const Json* more = member(root, "file_frames")) {
    if (!more->is_array()) fail("type", "file_frames is not an array", "file_frames");
    for (const Json& frame : *more) {
      if (!frame.is_object()) fail("type", "a frame is not an object", fmt::format("file_frames[{}]", all.size() - 1));
      all.push_back(&frame);
    }
  }
  std::vector<Frame> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string where = i == 0 ? "" : fmt::format("file_frames[{}].", i - 1);
    std::vector<const Json*> chain{all[i]};
    for (std::size_t at = i; at != 0;) {
      const Json *inherit = member(*all[at], "frame_inherit"), *parent = member(*all[at], "frame_parent");
      if (!inherit || !inherit->is_boolean() || !inherit->get<bool>()) break;
      if (parent && !(parent->is_number_unsigned() && parent->get<std::uint64_t>() < all.size()))
        fail("parent", fmt::format("frame_parent is {}, must be in [0, {}]", parent->dump(), all.size() - 1),
             where + "frame_parent");
      at = parent ? parent->get<std::size_t>() : 0;
      chain.push_back(all[at]);
      if (chain.size() > kLongestChain)
        fail("parent", fmt::format("a frame inherits from more than {} others, or from itself", kLongestChain),
             where + "frame_parent");
    }
    result.emplace_back(where, std::move(chain));
  }
  return result;
}

// The plane of an axis that all points of a sheet lie in; -1 when there is none.
int plane_of(const Json& coords) {
  for (std::size_t axis : {2, 1, 0}) {
    std::optional<double> level;
    const bool in_plane = std::all_of(coords.begin(), coords.end(), [&](const Json& row) {
      if (!row.is_array() || (axis == 2 && row.size() < 3)) return true;  // read_net says what is wrong with it
      if (row.size() < 3 || !row[axis].is_number()) return false;
      return row[axis].get<double>() == level.emplace(level.value_or(row[axis].get<double>()));
    });
    if (in_plane) return static_cast<int>(axis);
  }
  return -1;
}

// The front of a sheet is seen from the positive side of its axis: x to the right, and in the plane of x and z, as
// Origami Simulator writes it, z towards the reader.
Vec2 in_plane(const Vec3& p, int axis) {
  if (axis == 1) return {p.x(), 0.0 - p.z()};
  return axis == 0 ? Vec2(p.y(), p.z()) : Vec2(p.x(), p.y());
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
bool all_panels_face_one_way(const Frame& frame, int axis) {
  const std::vector<Vec3> at = points(frame);
  const Json* faces = frame.array("faces_vertices");
  if (!faces) return true;
  int front = 0, back = 0;
  for (std::size_t f = 0; f < faces->size(); ++f) {
    std::vector<Vec2> corners;
    if (!(*faces)[f].is_array()) return false;
    for (const Json& v : (*faces)[f])
      corners.push_back(in_plane(at[index(v, static_cast<int>(at.size()), frame, "faces_vertices", f)], axis));
    const double area = corners.size() < 3 ? 0 : signed_area(corners);
    front += area > 0, back += area < 0;
  }
  return front == 0 || back == 0;
}

// Called folded, or in another plane, but flat all the same.
bool is_flat_after_all(const Frame& frame) {
  if (!has_points(frame)) return false;
  const int axis = plane_of(*frame.find("vertices_coords"));
  return axis >= 0 && all_panels_face_one_way(frame, axis);
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

// ---- The sheet ---------------------------------------------------------------------------------------------------

Assignment assignment(const Json& value, const Frame& frame, std::size_t i) {
  static const std::string letters = "BMVFUCJ";
  const std::string* text = value.get_ptr<const std::string*>();
  if (!text || text->size() != 1 || letters.find(*text) == std::string::npos)
    fail("assignment",
         fmt::format("{} is not an assignment; the letters are B M V F U C J",
                     value.dump(-1, ' ', false, Json::error_handler_t::replace)),
         frame.entry("edges_assignment", i));
  return static_cast<Assignment>((*text)[0]);
}

class SheetReader {
 public:
  explicit SheetReader(const Frame& frame) : frame_(frame) {}

  CreasePattern read() {
    const Json* coords = frame_.find("vertices_coords");
    const int axis = coords ? plane_of(*coords) : 2;
    for (const Vec3& p : points(frame_)) sheet_.vertices.push_back(in_plane(p, axis));
    read_edges();
    read_faces();
    add_missing_edges();
    sides_ = edge_sides(sheet_);  // throws when two panels lie on one side of an edge
    fill_assignments();
    read_limits();
    return std::move(sheet_);
  }

 private:
  void read_edges() {
    if (const Json* list = frame_.array("edges_vertices")) {
      for (std::size_t i = 0; i < list->size(); ++i) add_edge((*list)[i], i);
    } else if (const Json* around = frame_.array("vertices_vertices", sheet_.num_vertices());
               around && !frame_.find("faces_vertices")) {
      add_edges_around(*around);
    }
    check_edges_differ();
    assigned_ = frame_.array("edges_assignment", sheet_.num_edges());
    angles_ = frame_.array("edges_foldAngle", sheet_.num_edges());
    if (!angles_) angles_ = frame_.array("edges_foldAngles", sheet_.num_edges());  // its name in FOLD 1.0
    // Faces of a planar graph need to know the boundary, so letters are read first.
    for (std::size_t i = 0; assigned_ && i < assigned_->size(); ++i)
      sheet_.edges[i].assignment = assignment((*assigned_)[i], frame_, i);
  }

  void add_edge(const Json& pair, std::size_t i) {
    const char* key = "edges_vertices";
    if (!pair.is_array() || pair.size() != 2) fail("edge", "an edge needs two vertices", frame_.entry(key, i));
    const int a = index(pair[0], sheet_.num_vertices(), frame_, key, i);
    const int b = index(pair[1], sheet_.num_vertices(), frame_, key, i);
    if (a == b) fail("edge", fmt::format("edge {} runs from vertex {} to itself", i, a), frame_.entry(key, i));
    sheet_.edges.push_back({a, b});
  }

  void add_edges_around(const Json& around) {
    const char* key = "vertices_vertices";
    for (std::size_t v = 0; v < around.size(); ++v) {
      if (!around[v].is_array()) fail("type", "a row of vertices_vertices is not an array", frame_.entry(key, v));
      for (const Json& entry : around[v]) {
        const int w = index(entry, sheet_.num_vertices(), frame_, key, v);
        if (w > static_cast<int>(v)) sheet_.edges.push_back({static_cast<int>(v), w});
      }
    }
  }

  void check_edges_differ() const {
    std::vector<std::pair<std::pair<int, int>, int>> order;
    for (int e = 0; e < sheet_.num_edges(); ++e)
      order.push_back({std::minmax(sheet_.edges[e].a, sheet_.edges[e].b), e});
    std::sort(order.begin(), order.end());
    for (std::size_t i = 1; i < order.size(); ++i)
      if (order[i - 1].first == order[i].first)
        fail("edge", fmt::format("edges {} and {} join the same vertices", order[i - 1].second, order[i].second),
             frame_.entry("edges_vertices", static_cast<std::size_t>(order[i].second)));
  }

  void read_faces() {
    const char* key = "faces_vertices";
    const Json* list = frame_.array(key);
    if (!list) {
      sheet_.faces = planar_faces(sheet_.vertices, sheet_.edges);
      if (sheet_.faces.empty()) fail("no-faces", "the edges enclose no face", "edges_vertices");
      return;
    }
    const bool ours = frame_.find("faces_plico:mesh_face") != nullptr;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Json& row = (*list)[i];
      if (!row.is_array() || row.size() < 3) fail("face", "a face needs at least 3 vertices", frame_.entry(key, i));
      std::vector<int>& face = sheet_.faces.emplace_back();
      for (const Json& v : row) face.push_back(index(v, sheet_.num_vertices(), frame_, key, i));
      check_corners_differ(face, i);
      if (!ours && signed_area(polygon(sheet_, static_cast<int>(i))) < 0) std::reverse(face.begin(), face.end());
    }
  }

  void check_corners_differ(std::vector<int> face, std::size_t i) const {
    std::sort(face.begin(), face.end());
    const auto twice = std::adjacent_find(face.begin(), face.end());
    if (twice != face.end())
      fail("face", fmt::format("face {} has vertex {} twice", i, *twice), frame_.entry("faces_vertices", i),
           "split faces with slits");
  }

  // Sides of faces that the file names no edge for, in the order of faces and sides.
  void add_missing_edges() {
    std::vector<std::pair<int, int>> known;
    for (const Crease& e : sheet_.edges) known.push_back(std::minmax(e.a, e.b));
    std::sort(known.begin(), known.end());
    std::set<std::pair<int, int>> added;
    given_ = sheet_.edges.size();
    for (const std::vector<int>& face : sheet_.faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        const int a = face[i], b = face[(i + 1) % face.size()];
        const std::pair<int, int> side = std::minmax(a, b);
        if (std::binary_search(known.begin(), known.end(), side) || !added.insert(side).second) continue;
        sheet_.edges.push_back({a, b});
      }
    }
  }

  void fill_assignments() {
    for (std::size_t i = 0; i < sheet_.edges.size(); ++i) {
      Crease& edge = sheet_.edges[i];
      const bool given = i < given_;
      const Json* angle = given && angles_ && !(*angles_)[i].is_null() ? &(*angles_)[i] : nullptr;
      if (angle) edge.fold_angle = read_angle(*angle, i);
      const bool inner = sides_[i].left >= 0 && sides_[i].right >= 0;
      if (!given || !assigned_) {
        edge.assignment = angle && inner ? assignment_of(edge.fold_angle) : Assignment::Unassigned;
        if (!inner) edge.assignment = Assignment::Boundary;
      }
      if (!angle) edge.fold_angle = flat_fold_angle(edge.assignment);
    }
  }

  // At most one entry for each edge of the file; edges that it leaves out are not limited.
  void read_limits() {
    constexpr const char* kKey = "edges_plico:maxFoldAngle";
    const Json* limits = frame_.find(kKey);
    if (!limits) return;
    if (!limits->is_array() || limits->size() > sheet_.edges.size())
      fail("limits",
           fmt::format("{} must be a list with at most one entry for each of the {} edges", kKey, sheet_.num_edges()),
           frame_.at(kKey));
    for (std::size_t e = 0; e < limits->size(); ++e) {
      const Json& limit = (*limits)[e];
      if (limit.is_null()) continue;
      if (!limit.is_number() || !(limit.get<double>() >= 0))
        fail("limits", fmt::format("{}[{}] must be degrees, at least 0, or null", kKey, e), frame_.entry(kKey, e));
      sheet_.edges[e].limit = std::min(kPi, radians(limit.get<double>()));
    }
  }

  double read_angle(const Json& value, std::size_t i) const {
    const double angle = number(value, frame_, "edges_foldAngle", i);
    if (std::abs(angle) > 180)
      fail("angle", fmt::format("fold angle {} must be in [-180, 180] degrees", angle),
           frame_.entry("edges_foldAngle", i));
    return radians(angle);
  }

  const Frame& frame_;
  CreasePattern sheet_;
  std::vector<EdgeSides> sides_;
  const Json *assigned_ = nullptr, *angles_ = nullptr;
  std::size_t given_ = 0;  // edges that the file names
};

Unfolding read_net(const Frame& frame) {
  constexpr int kAny = std::numeric_limits<int>::max();
  Unfolding net;
  net.sheet = SheetReader(frame).read();
  const int faces = net.sheet.num_faces(), edges = net.sheet.num_edges();
  net.mesh_face = indices(frame, "faces_plico:mesh_face", faces, kAny);
  net.mesh_vertex = indices(frame, "vertices_plico:mesh_vertex", net.sheet.num_vertices(), kAny);
  net.part = frame.find("faces_plico:part") ? indices(frame, "faces_plico:part", faces, faces) : parts_of(net.sheet);
  if (const Json* mates = frame.array("edges_plico:mate", edges))
    for (std::size_t i = 0; i < mates->size(); ++i)
      net.mate.push_back((*mates)[i].is_null() ? -1 : index((*mates)[i], edges, frame, "edges_plico:mate", i));
  return net;
}

std::vector<std::string> assumed(const Frame& frame, const CreasePattern& sheet) {
  std::vector<std::string> notes;
  if (is_called_folded(frame))
    notes.emplace_back("the frame is called a folded form but is flat: it was taken for the sheet");
  const int axis = plane_of(*frame.find("vertices_coords"));
  if (axis == 0 || axis == 1)
    notes.push_back(fmt::format("the sheet lies in the plane of {} and was laid into that of x and y",
                                axis == 0 ? "y and z" : "x and z"));
  const std::vector<EdgeSides> sides = edge_sides(sheet);
  int free = 0;
  for (std::size_t e = 0; e < sides.size(); ++e)
    free += sheet.edges[e].assignment == Assignment::Unassigned && is_hinge(sheet.edges[e], sides[e]);
  if (free > 0)
    notes.push_back(fmt::format("{} crease{} no assignment: {} freely, without a goal", free,
                                free == 1 ? " has" : "s have", free == 1 ? "it turns" : "they turn"));
  return notes;
}

// ---- Folded form and motion --------------------------------------------------------------------------------------

// A frame that says nothing but these keys, about the key frame, is one that we write.
bool is_spatial_frame(const Json& frame, const std::set<std::string>& extra) {
  static const std::set<std::string> ours{"frame_classes", "frame_attributes", "frame_parent", "frame_inherit",
                                          "vertices_coords"};
  for (const auto& [key, value] : frame.items())
    if (!ours.contains(key) && !extra.contains(key)) return false;
  for (const std::string& key : extra)
    if (!frame.contains(key)) return false;
  return frame.value("frame_classes", Json()) == Json{"foldedForm"} &&
         frame.value("frame_attributes", Json()) == Json{"3D"} && frame.value("frame_parent", Json(0)) == Json(0) &&
         frame.value("frame_inherit", Json()) == Json(true) && frame.contains("vertices_coords");
}

constexpr double kNoFoldDegrees = 1e-6;  // what cannot turn is not turned

// What keeps a frame with a time from being part of the motion.
std::string why_no_waypoint(const Json& frame) {
  for (const char* key : {"vertices_coords", "edges_foldAngle"})
    if (!frame.contains(key)) return fmt::format("it has no {}", key);
  if (frame.value("frame_inherit", Json()) != Json(true)) return "its frame_inherit is not true";
  if (frame.value("frame_parent", Json(0)) != Json(0)) return "its frame_parent is not 0";
  if (frame.value("frame_classes", Json()) != Json{"foldedForm"}) return "its frame_classes are not [\"foldedForm\"]";
  if (frame.value("frame_attributes", Json()) != Json{"3D"}) return "its frame_attributes are not [\"3D\"]";
  return "other frames stand between it and the key frame, or it has keys that a motion does not know";
}

// A motion is never taken for a sheet because one of its frames is not as it should be.
void refuse_stray_times(const std::vector<Frame>& all, std::size_t first) {
  for (std::size_t i = first; i < all.size(); ++i)
    if (all[i].own().contains("plico:time"))
      fail("motion",
           fmt::format("a frame has a plico:time but is no part of a motion: {}", why_no_waypoint(all[i].own())),
           all[i].at("plico:time"));
}

Waypoint read_waypoint(const Frame& frame, const std::vector<int>& hinge) {
  const Json* angles = frame.array("edges_foldAngle", static_cast<int>(hinge.size()));
  Waypoint waypoint{number(frame.own()["plico:time"], frame, "plico:time", 0), {}};
  const auto hinges = std::count_if(hinge.begin(), hinge.end(), [](int h) { return h >= 0; });
  waypoint.config.setZero(hinges);
  for (std::size_t e = 0; e < hinge.size(); ++e)
    if (const double angle = number((*angles)[e], frame, "edges_foldAngle", e); hinge[e] >= 0)
      waypoint.config[hinge[e]] = radians(angle);
    else if (std::abs(angle) > kNoFoldDegrees)
      fail("angle", fmt::format("edge {} turns by {:.6g} degrees, but is no fold of the sheet", e, angle),
           frame.entry("edges_foldAngle", e));
  return waypoint;
}

// Reads the frames that are ours; returns the number of the first that is not.
std::size_t read_motion(const std::vector<Frame>& all, FoldFile& file) {
  const int n = file.net.sheet.num_vertices();
  std::size_t i = 1;
  if (i < all.size() && is_spatial_frame(all[i].own(), {})) file.folded = points(all[i++], n);
  std::vector<int> hinge;
  for (; i < all.size() && is_spatial_frame(all[i].own(), {"edges_foldAngle", "plico:time"}); ++i) {
    if (!file.path) {
      hinge = hinge_of_edge(file.net.sheet);
      file.path.emplace();
    }
    std::vector<Waypoint>& waypoints = file.path->waypoints;
    waypoints.push_back(read_waypoint(all[i], hinge));
    file.path_points.push_back(points(all[i], n));
    if (waypoints.size() > 1 && !(waypoints[waypoints.size() - 2].time < waypoints.back().time))
      fail("time", "the times of a motion must increase", all[i].at("plico:time"));
  }
  refuse_stray_times(all, i);
  if (file.path && (file.path->waypoints.size() < 2 || file.path->waypoints.front().time != 0 ||
                    file.path->waypoints.back().time != 1))
    fail("time", "a motion starts at plico:time 0 and ends at 1", all[i - 1].at("plico:time"));
  return i;
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

FoldFile read_fold(std::string_view bytes, const std::string& name) {
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
  if (std::any_of(all.begin(), all.end(), [](const Frame& f) { return f.own().contains("plico:time"); }))
    fail("motion", "a file with a motion has its flat sheet as the key frame", frame.at("vertices_coords"));
  keep_other_keys(frame.flattened(), file);
  for (const auto& [key, value] : root.items())
    if (key.starts_with("file_") && !is_ours(key)) file.other.emplace_back(key, value.dump());
  std::sort(file.other.begin(), file.other.end());
  for (std::size_t i = 1; i < all.size(); ++i)
    file.other_frames.push_back(swapped_frame(all[i == chosen ? 0 : i].own(), i, chosen).dump());
  return file;
}

}  // namespace plico
