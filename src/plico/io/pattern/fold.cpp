#include "plico/io/pattern/fold.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/base/version.h"
#include "plico/fold/net_piece.h"
#include "plico/io/text/json_text.h"

namespace plico {
namespace {

std::string json_string(const std::string& text) { return nlohmann::json(text).dump(); }

std::size_t text_length(double value) {
  char digits[32];
  return static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, value).ptr - digits);
}

// The number of degrees that stands in the file for an angle: among all that read back as this angle the shortest, so
// that 90 stays 90 and a file that was read is written back number for number. A few angles are the radians of no
// double; for those the nearest is taken that is.
double file_degrees(double angle) {
  const double guess = degrees(angle);
  std::array<double, 9> near;
  near[4] = guess;
  for (std::size_t i = 4; i > 0; --i) near[i - 1] = std::nextafter(near[i], -1e9);
  for (std::size_t i = 5; i < near.size(); ++i) near[i] = std::nextafter(near[i - 1], 1e9);
  const bool exact = std::any_of(near.begin(), near.end(), [&](double d) { return radians(d) == angle; });
  const double target = exact ? angle : radians(guess);
  double best = guess;
  std::size_t length = sizeof near;
  for (double d : near) {
    if (radians(d) != target) continue;
    const std::size_t l = text_length(d);
    if (l < length) best = d, length = l;
  }
  return best;
}

void write_angles(JsonText& json, const std::vector<double>& angles) {
  json.key("edges_foldAngle");
  json.list(angles, [&](double angle) { json.number(file_degrees(angle)); });
}

// What the material allows, where it is less than a whole turn.
void write_limits(JsonText& json, const CreasePattern& sheet) {
  const auto limited = [](const Crease& e) { return e.limit < kPi; };
  if (std::none_of(sheet.edges.begin(), sheet.edges.end(), limited)) return;
  json.key("edges_plico:maxFoldAngle");
  json.list(sheet.edges, [&](const Crease& e) { limited(e) ? json.number(file_degrees(e.limit)) : json.raw("null"); });
}

template <class Point>
void write_points(JsonText& json, const std::vector<Point>& points) {
  json.key("vertices_coords");
  json.list(points, [&](const Point& p) { json.point(p); });
}

void write_integers(JsonText& json, std::string_view key, const std::vector<int>& values) {
  json.key(key);
  json.list(values, [&](int v) { json.integer(v); });
}

void write_vertices(JsonText& json, const Unfolding& net) {
  write_points(json, net.sheet.vertices);
  if (!net.mesh_vertex.empty()) write_integers(json, "vertices_plico:mesh_vertex", net.mesh_vertex);
}

void write_edges(JsonText& json, const Unfolding& net) {
  json.key("edges_vertices");
  json.list(net.sheet.edges, [&](const Crease& e) {
    json.raw("[");
    json.integer(e.a);
    json.raw(",");
    json.integer(e.b);
    json.raw("]");
  });
  json.key("edges_assignment");
  json.list(net.sheet.edges, [&](const Crease& e) {
    const char letter[] = {'"', static_cast<char>(e.assignment), '"'};
    json.raw({letter, 3});
  });
  std::vector<double> angles;
  for (const Crease& e : net.sheet.edges) angles.push_back(e.fold_angle);
  write_angles(json, angles);
  write_limits(json, net.sheet);
  if (net.mate.empty()) return;
  json.key("edges_plico:mate");
  json.list(net.mate, [&](int mate) { mate < 0 ? json.raw("null") : json.integer(mate); });
}

void write_faces(JsonText& json, const Unfolding& net) {
  json.key("faces_vertices");
  json.list(net.sheet.faces, [&](const std::vector<int>& face) { json.list(face, [&](int v) { json.integer(v); }); });
  if (!net.mesh_face.empty()) write_integers(json, "faces_plico:mesh_face", net.mesh_face);
  if (net.num_parts() > 1) write_integers(json, "faces_plico:part", net.part);
}

// About the frame `parent`, 0 being the key frame.
void open_spatial_frame(JsonText& json, int parent = 0) {
  json.open();
  json.key("frame_classes");
  json.raw("[\"foldedForm\"]");
  json.key("frame_attributes");
  json.raw("[\"3D\"]");
  json.key("frame_parent");
  json.integer(parent);
  json.key("frame_inherit");
  json.raw("true");
}

void write_face_orders(JsonText& json, const std::vector<FaceOrder>& orders) {
  std::string list;
  for (const FaceOrder& order : orders)
    list += fmt::format("{}[{},{},{}]", list.empty() ? "" : ",", order.f, order.g, order.side);
  json.key("faceOrders");
  json.raw("[" + list + "]");
}

void write_waypoint(JsonText& json, const Waypoint& waypoint, const std::vector<Vec3>& points,
                    const std::vector<int>& hinge, int parent, const std::vector<FaceOrder>& orders) {
  open_spatial_frame(json, parent);
  json.key("plico:time");
  json.number(waypoint.time);
  std::vector<double> angles;
  for (int h : hinge) angles.push_back(h < 0 ? 0 : waypoint.config[h]);
  write_angles(json, angles);
  write_points(json, points);
  if (!orders.empty()) write_face_orders(json, orders);
  json.close();
}

void write_other(JsonText& json, const std::vector<std::pair<std::string, std::string>>& other) {
  for (const auto& [key, value] : other) {
    json.quoted_key(json_string(key));
    json.raw(value);
  }
}

void write_piece(JsonText& json, const FoldPiece& piece, const Unfolding& net, int number) {
  json.open();
  if (!piece.title.empty()) {
    json.key("frame_title");
    json.raw(json_string(piece.title));
  }
  json.key("frame_classes");
  json.raw("[\"creasePattern\"]");
  json.key("frame_attributes");
  json.raw("[\"2D\"]");
  json.key("plico:piece");
  json.integer(number);
  write_vertices(json, net);
  write_edges(json, net);
  write_faces(json, net);
  write_other(json, piece.other);
  json.close();
}

// The array file_frames; a frame knows its number, so that others can be about it.
class FrameWriter {
 public:
  FrameWriter(JsonText& json, const FoldFile& file) : json_(json), file_(file) {}

  void write() {
    if (file_.folded.empty() && !file_.path && file_.pieces.empty() && file_.other_frames.empty()) return;
    json_.key("file_frames");
    json_.raw("[");
    if (!file_.folded.empty()) write_folded_form();
    if (!file_.pieces.empty())
      write_pieces();
    else if (file_.path)
      write_motion(*file_.path, file_.path_points, hinge_of_edge(file_.net.sheet), 0, file_.end_orders);
    for (const std::string& frame : file_.other_frames) {
      next();
      json_.raw(frame);
    }
    json_.raw("]");
  }

 private:
  void next() {
    if (written_++ > 0) json_.raw(",\n");
  }

  void write_folded_form() {
    next();
    open_spatial_frame(json_);
    write_points(json_, file_.folded);
    json_.close();
  }

  void write_motion(const FoldingPath& path, const std::vector<std::vector<Vec3>>& points,
                    const std::vector<int>& hinge, int parent, const std::vector<FaceOrder>& end_orders) {
    for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
      next();
      const bool last = i + 1 == path.waypoints.size();
      write_waypoint(json_, path.waypoints[i], points[i], hinge, parent, last ? end_orders : std::vector<FaceOrder>());
    }
  }

  void write_pieces() {
    const std::vector<NetPiece> pieces = pieces_of(file_.net);
    PLICO_ASSERT(pieces.size() == file_.pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const FoldPiece& piece = file_.pieces[i];
      next();
      write_piece(json_, piece, pieces[i].net, static_cast<int>(i));
      if (piece.path) write_motion(*piece.path, piece.points, hinge_of_edge(pieces[i].net.sheet), written_, {});
    }
  }

  JsonText& json_;
  const FoldFile& file_;
  int written_ = 0;  // frames; the last one has this number, since the key frame is 0
};

std::string_view classes_of(const FoldFile& file) {
  if (file.pieces.empty()) return file.path ? "[\"animation\"]" : "[\"singleModel\"]";
  return file.path ? "[\"multiModel\",\"animation\"]" : "[\"multiModel\"]";
}

// Undirected, for sorting.
std::uint64_t edge_key(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
}

// Every piece of a kit does what it does in the motion of the whole, which it then has from its pieces.
void share_motion(FoldFile& file) {
  const std::vector<NetPiece> pieces = pieces_of(file.net);
  PLICO_ASSERT(pieces.size() == file.pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    FoldPiece& piece = file.pieces[i];
    piece.points.clear();
    piece.path.reset();
    if (pieces[i].hinge.empty()) continue;
    piece.path = path_of_piece(pieces[i], *file.path);
    for (const std::vector<Vec3>& all : file.path_points) {
      std::vector<Vec3>& points = piece.points.emplace_back();
      for (int v : pieces[i].vertex) points.push_back(all[v]);
    }
  }
  file.path_points.clear();
  file.end_orders.clear();
}

}  // namespace

FoldKind kind(const FoldFile& file) {
  if (file.path) return FoldKind::Motion;
  return file.net.mesh_face.empty() ? FoldKind::CreasePattern : FoldKind::Net;
}

FoldFile fold_file(const Mesh& mesh, const Unfolding& unfolding) {
  FoldFile file;
  file.net = unfolding;
  for (int v : unfolding.mesh_vertex) file.folded.push_back(mesh.point(VertexId(v)));
  return file;
}

FoldFile fold_file(const CreasePattern& sheet) {
  FoldFile file;
  file.net.sheet = sheet;
  file.net.part = parts_of(sheet);
  return file;
}

void set_sheet(FoldFile& file, const CreasePattern& sheet) {
  file.net.sheet = sheet;
  file.net.part = parts_of(sheet);
  file.net.mate.clear();
  file.pieces.clear();
  file.path.reset();
  file.path_points.clear();
  file.end_orders.clear();
}

void set_path(FoldFile& file, const Linkage& linkage, const FoldingPath& path) {
  const CreasePattern& sheet = file.net.sheet;
  PLICO_ASSERT(linkage.num_panels() == sheet.num_faces());
  std::vector<int> panel_of(sheet.vertices.size(), -1);
  for (int f = sheet.num_faces() - 1; f >= 0; --f)
    for (int v : sheet.faces[f]) panel_of[v] = f;
  file.path = path;
  file.path_points.clear();
  file.end_orders.clear();
  for (const Waypoint& waypoint : path.waypoints) {
    const std::vector<Pose> poses = folding_map(linkage, waypoint.config);
    std::vector<Vec3>& points = file.path_points.emplace_back();
    for (int v = 0; v < sheet.num_vertices(); ++v) {
      const Vec3 flat(sheet.vertices[v].x(), sheet.vertices[v].y(), 0);
      points.push_back(panel_of[v] < 0 ? flat : Vec3(poses[panel_of[v]] * flat));
    }
  }
  if (!file.pieces.empty()) share_motion(file);
}

Mesh folded_mesh(const FoldFile& file) {
  const Unfolding& net = file.net;
  if (file.folded.empty() || net.mesh_face.empty() || net.mesh_vertex.empty())
    throw InvalidInput("fold/no-mesh", "the file does not hold the mesh it came from", {}, "give the mesh as well");
  const int num_points = *std::max_element(net.mesh_vertex.begin(), net.mesh_vertex.end()) + 1;
  if (num_points > 64 * net.sheet.num_vertices())
    throw InvalidInput("fold/mesh-numbers",
                       fmt::format("{} net vertices name {} mesh vertices", net.sheet.num_vertices(), num_points));
  PolygonSoup soup;
  soup.points.assign(num_points, file.folded[0]);
  std::vector<char> placed(num_points, 0);
  for (int v = 0; v < net.sheet.num_vertices(); ++v) {
    Vec3& point = soup.points[net.mesh_vertex[v]];
    if (placed[net.mesh_vertex[v]] && point != file.folded[v])
      throw InvalidInput("fold/folded-form",
                         fmt::format("copies of mesh vertex {} stand apart in the folded form", net.mesh_vertex[v]));
    placed[net.mesh_vertex[v]] = 1;
    point = file.folded[v];
  }
  std::vector<int> panel_of(net.mesh_face.size(), -1);
  for (int f = 0; f < net.sheet.num_faces(); ++f) {
    const int g = net.mesh_face[f];
    if (g >= net.sheet.num_faces() || panel_of[g] >= 0)
      throw InvalidInput("fold/mesh-numbers",
                         fmt::format("panel {} is mesh face {}, but every mesh face stands once", f, g));
    panel_of[g] = f;
  }
  for (int f : panel_of) {
    for (int v : net.sheet.faces[f]) soup.corners.push_back(net.mesh_vertex[v]);
    soup.offsets.push_back(static_cast<int>(soup.corners.size()));
  }
  return Mesh(std::move(soup));
}

void attach_mesh(Unfolding& net, const Mesh& mesh) {
  if (net.mesh_vertex.empty())
    throw InvalidInput("fold/no-mesh", "the file does not say which mesh vertices it is made of");
  std::vector<std::pair<std::uint64_t, int>> edges;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    edges.emplace_back(edge_key(mesh.from(h), mesh.to(h)), e);
  }
  std::sort(edges.begin(), edges.end());
  net.mesh_edge.clear();
  for (const Crease& crease : net.sheet.edges) {
    const int a = net.mesh_vertex[crease.a], b = net.mesh_vertex[crease.b];
    const std::pair<std::uint64_t, int> wanted{edge_key(a, b), -1};
    const auto at = std::lower_bound(edges.begin(), edges.end(), wanted);
    if (at == edges.end() || at->first != wanted.first)
      throw InvalidInput("fold/other-mesh",
                         fmt::format("the net has an edge between mesh vertices {} and {}, the mesh has none", a, b),
                         fmt::format("edge {}-{}", crease.a, crease.b), "give the mesh the net was made from");
    net.mesh_edge.push_back(at->second);
  }
}

std::string write_fold(const FoldFile& file) {
  JsonText json;
  json.open();
  json.key("file_spec");
  json.raw("1.2");
  json.key("file_creator");
  json.raw(fmt::format("\"plico {}\"", version()));
  json.key("file_classes");
  json.raw(classes_of(file));
  json.key("frame_classes");
  json.raw("[\"creasePattern\"]");
  json.key("frame_attributes");
  json.raw("[\"2D\"]");
  json.key("frame_unit");
  json.raw(json_string(file.unit));
  write_vertices(json, file.net);
  write_edges(json, file.net);
  write_faces(json, file.net);
  if (!file.report.empty()) {
    json.key("plico:report");
    json.raw(file.report);
  }
  write_other(json, file.other);
  FrameWriter(json, file).write();
  json.close();
  json.raw("\n");
  return json.take();
}

}  // namespace plico
