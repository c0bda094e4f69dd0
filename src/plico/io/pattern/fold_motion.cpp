// The folded form and the motion of a FOLD file.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "plico/base/error.h"
#include "plico/io/pattern/fold_frames.h"

namespace plico::fold_json {
namespace {

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

}  // namespace

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

}  // namespace plico::fold_json
