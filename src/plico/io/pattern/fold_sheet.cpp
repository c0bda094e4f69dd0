// The flat sheet of a frame.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "plico/base/error.h"
#include "plico/fold/planar_faces.h"
#include "plico/geom/polygon.h"
#include "plico/io/pattern/fold_frames.h"

namespace plico::fold_json {
namespace {

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
    const std::vector<Vec3> at = points(frame_);
    const SheetPlane plane = sheet_plane(at).value_or(SheetPlane());
    for (const Vec3& p : at) sheet_.vertices.push_back(in_plane(p, plane));
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

}  // namespace

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

}  // namespace plico::fold_json
