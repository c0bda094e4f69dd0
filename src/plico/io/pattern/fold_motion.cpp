// The folded form of a FOLD file, and its motion or its pieces with theirs.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "plico/base/error.h"
#include "plico/fold/net_piece.h"
#include "plico/io/pattern/fold_frames.h"

namespace plico::fold_json {
namespace {

// A frame that says nothing but these keys, about the sheet in frame `parent`, is one that we write.
bool is_spatial_frame(const Json& frame, const std::set<std::string>& extra, std::size_t parent = 0) {
  static const std::set<std::string> ours{"frame_classes", "frame_attributes", "frame_parent", "frame_inherit",
                                          "vertices_coords"};
  for (const auto& [key, value] : frame.items())
    if (!ours.contains(key) && !extra.contains(key)) return false;
  for (const std::string& key : extra)
    if (!frame.contains(key)) return false;
  return frame.value("frame_classes", Json()) == Json{"foldedForm"} &&
         frame.value("frame_attributes", Json()) == Json{"3D"} &&
         frame.value("frame_parent", Json(0)) == Json(parent) && frame.value("frame_inherit", Json()) == Json(true) &&
         frame.contains("vertices_coords");
}

constexpr double kNoFoldDegrees = 1e-6;  // what cannot turn is not turned

// What keeps a frame with a time from being part of the motion.
std::string why_no_waypoint(const Json& frame, std::size_t parent) {
  for (const char* key : {"vertices_coords", "edges_foldAngle"})
    if (!frame.contains(key)) return fmt::format("it has no {}", key);
  if (frame.value("frame_inherit", Json()) != Json(true)) return "its frame_inherit is not true";
  if (frame.value("frame_parent", Json(0)) != Json(parent)) return fmt::format("its frame_parent is not {}", parent);
  if (frame.value("frame_classes", Json()) != Json{"foldedForm"}) return "its frame_classes are not [\"foldedForm\"]";
  if (frame.value("frame_attributes", Json()) != Json{"3D"}) return "its frame_attributes are not [\"3D\"]";
  return fmt::format("other frames stand between it and {}, or it has keys that a motion does not know",
                     parent == 0 ? "the key frame" : "its sheet");
}

bool is_piece(const Frame& frame) { return frame.own().contains("plico:piece"); }

// A motion is never taken for a sheet, or a kit for one net, because one of the frames is not as it should be.
void refuse_strays(const std::vector<Frame>& all, std::size_t first, std::size_t parent) {
  for (std::size_t i = first; i < all.size(); ++i) {
    if (is_piece(all[i])) fail("piece", "a piece stands apart from the other pieces", all[i].at("plico:piece"));
    if (all[i].own().contains("plico:time"))
      fail(
          "motion",
          fmt::format("a frame has a plico:time but is no part of a motion: {}", why_no_waypoint(all[i].own(), parent)),
          all[i].at("plico:time"));
  }
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

struct ReadMotion {
  std::optional<FoldingPath> path;
  std::vector<std::vector<Vec3>> points;
  std::vector<FaceOrder> end_orders;
};

std::vector<FaceOrder> read_face_orders(const Frame& frame, int panels) {
  constexpr const char* kKey = "faceOrders";
  const Json* list = frame.array(kKey);
  std::vector<FaceOrder> orders;
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const Json& entry = (*list)[i];
    if (!entry.is_array() || entry.size() != 3)
      fail("face-orders", "faceOrders holds something that is not two panels and a side", frame.entry(kKey, i));
    const int f = index(entry[0], panels, frame, kKey, i), g = index(entry[1], panels, frame, kKey, i);
    const double side = number(entry[2], frame, kKey, i);
    if (f == g || (side != 1 && side != 0 && side != -1))
      fail("face-orders", fmt::format("panels {} and {} with side {}, must be two and -1, 0 or 1", f, g, side),
           frame.entry(kKey, i));
    orders.push_back({f, g, static_cast<int>(side)});
  }
  return orders;
}

// The frames from `i` on that move the sheet in frame `parent`; `i` becomes the number of the first that does not. The
// last may have an order of its layers when that is the sheet of the key frame.
ReadMotion read_waypoints(const std::vector<Frame>& all, std::size_t& i, std::size_t parent,
                          const CreasePattern& sheet) {
  ReadMotion motion;
  std::vector<int> hinge;
  for (bool ended = false; i < all.size() && !ended; ++i) {
    ended = parent == 0 && is_spatial_frame(all[i].own(), {"edges_foldAngle", "plico:time", "faceOrders"}, parent);
    if (!ended && !is_spatial_frame(all[i].own(), {"edges_foldAngle", "plico:time"}, parent)) break;
    if (ended) motion.end_orders = read_face_orders(all[i], sheet.num_faces());
    if (!motion.path) {
      hinge = hinge_of_edge(sheet);
      motion.path.emplace();
    }
    std::vector<Waypoint>& waypoints = motion.path->waypoints;
    waypoints.push_back(read_waypoint(all[i], hinge));
    motion.points.push_back(points(all[i], sheet.num_vertices()));
    if (waypoints.size() > 1 && !(waypoints[waypoints.size() - 2].time < waypoints.back().time))
      fail("time", "the times of a motion must increase", all[i].at("plico:time"));
  }
  if (!motion.path) return motion;
  const std::vector<Waypoint>& waypoints = motion.path->waypoints;
  if (waypoints.size() < 2 || waypoints.front().time != 0 || waypoints.back().time != 1) {
    refuse_strays(all, i, parent);  // what is missing may stand elsewhere
    fail("time", "a motion starts at plico:time 0 and ends at 1", all[i - 1].at("plico:time"));
  }
  return motion;
}

// ---- Pieces ------------------------------------------------------------------------------------------------------

// The number of the first entry that differs, -1 for none.
template <class List, class Same>
int first_difference(const List& one, const List& other, Same same) {
  const std::size_t common = std::min(one.size(), other.size());
  for (std::size_t i = 0; i < common; ++i)
    if (!same(one[i], other[i])) return static_cast<int>(i);
  return one.size() == other.size() ? -1 : static_cast<int>(common);
}

bool same_crease(const Crease& one, const Crease& other) {
  return one.a == other.a && one.b == other.b && one.assignment == other.assignment &&
         one.fold_angle == other.fold_angle && one.limit == other.limit;
}

// The key frame is the truth about the sheet; what a piece repeats of it must agree.
void require_same(const Unfolding& piece, const Unfolding& on_sheet, const Frame& frame) {
  const auto require = [&](int at, const char* what, const char* key) {
    if (at >= 0)
      fail("piece", fmt::format("{} {} of a piece is not as on the sheet", what, at),
           frame.entry(key, static_cast<std::size_t>(at)));
  };
  const auto equal = [](const auto& one, const auto& other) { return one == other; };
  require(first_difference(piece.sheet.vertices, on_sheet.sheet.vertices, equal), "vertex", "vertices_coords");
  require(first_difference(piece.mesh_vertex, on_sheet.mesh_vertex, equal), "vertex", "vertices_plico:mesh_vertex");
  require(first_difference(piece.sheet.edges, on_sheet.sheet.edges, same_crease), "edge", "edges_vertices");
  require(first_difference(piece.mate, on_sheet.mate, equal), "edge", "edges_plico:mate");
  require(first_difference(piece.sheet.faces, on_sheet.sheet.faces, equal), "panel", "faces_vertices");
  require(first_difference(piece.mesh_face, on_sheet.mesh_face, equal), "panel", "faces_plico:mesh_face");
}

bool is_key_of_piece(const std::string& key) {
  static const std::set<std::string> keys{"frame_title",
                                          "frame_classes",
                                          "frame_attributes",
                                          "plico:piece",
                                          "vertices_coords",
                                          "vertices_plico:mesh_vertex",
                                          "edges_vertices",
                                          "edges_assignment",
                                          "edges_foldAngle",
                                          "edges_plico:mate",
                                          "edges_plico:maxFoldAngle",
                                          "faces_vertices",
                                          "faces_plico:mesh_face"};
  return keys.contains(key);
}

FoldPiece read_piece(const Frame& frame, int number, const Unfolding& on_sheet) {
  if (frame.own()["plico:piece"] != Json(number))
    fail("piece",
         fmt::format("this is piece {} of the kit, but is numbered {}", number, frame.own()["plico:piece"].dump()),
         frame.at("plico:piece"));
  if (frame.own().value("frame_inherit", Json(false)) != Json(false))
    fail("piece", "a piece stands on its own, so its frame inherits from no other", frame.at("frame_inherit"));
  require_same(read_net(frame), on_sheet, frame);
  FoldPiece piece;
  if (const Json* title = frame.find("frame_title")) {
    if (!title->is_string()) fail("type", "frame_title is not a text", frame.at("frame_title"));
    piece.title = title->get<std::string>();
  }
  for (const auto& [key, value] : frame.own().items())
    if (!is_key_of_piece(key)) piece.other.emplace_back(key, value.dump());
  return piece;
}

// One frame a piece, in the order of the net's parts, each followed by its motion; returns the number of the
// frame behind them.
std::size_t read_pieces(const std::vector<Frame>& all, std::size_t& i, FoldFile& file) {
  const std::vector<NetPiece> pieces = pieces_of(file.net);
  std::vector<std::optional<FoldingPath>> paths;
  std::size_t parent = 0;
  while (i < all.size() && is_piece(all[i])) {
    const std::size_t number = file.pieces.size();
    if (number == pieces.size())
      fail("piece", fmt::format("the net has {} pieces, here is one more", number), all[i].at("plico:piece"));
    file.pieces.push_back(read_piece(all[i], static_cast<int>(number), pieces[number].net));
    parent = i++;
    ReadMotion motion = read_waypoints(all, i, parent, pieces[number].net.sheet);
    file.pieces.back().path = motion.path;
    file.pieces.back().points = std::move(motion.points);
    paths.push_back(std::move(motion.path));
  }
  refuse_strays(all, i, parent);
  if (paths.size() < pieces.size())
    fail("piece", fmt::format("the net has {} pieces, {} of them stand in frames", pieces.size(), paths.size()),
         "file_frames");
  if (std::any_of(paths.begin(), paths.end(), [](const auto& path) { return path.has_value(); }))
    file.path = joined_path(make_linkage(file.net.sheet), pieces, paths);
  return i;
}

}  // namespace

std::size_t read_motion(const std::vector<Frame>& all, FoldFile& file) {
  std::size_t i = 1;
  if (i < all.size() && is_spatial_frame(all[i].own(), {}))
    file.folded = points(all[i++], file.net.sheet.num_vertices());
  ReadMotion motion = read_waypoints(all, i, 0, file.net.sheet);
  if (motion.path) {
    file.path = std::move(motion.path);
    file.path_points = std::move(motion.points);
    file.end_orders = std::move(motion.end_orders);
  } else if (i < all.size() && is_piece(all[i])) {
    return read_pieces(all, i, file);
  }
  refuse_strays(all, i, 0);
  return i;
}

}  // namespace plico::fold_json
