#include "plico/io/pattern/ori.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/fold/linkage.h"
#include "plico/io/text/parse_json.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

constexpr double kFlat = 1e-9;             // of the largest coordinate: how far vertices may be off the plane
constexpr double kRounded = 5e-6;          // files have six digits
constexpr double kBeyond = radians(1e-3);  // that much above 180 degrees is rounding
constexpr int kMostRows = 10'000'000;      // more than any file holds: a bad count must not ask for memory

// The file's tables, as they stand.
struct Tables {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<double, 5>> creases;  // v1, v2, angle, face, parent
  std::vector<std::array<double, 6>> faces;    // 3, a, b, c, parent, crease
};

template <std::size_t N>
std::vector<std::array<double, N>> text_table(TextScanner& scan, const char* what) {
  const int rows = scan.integer(fmt::format("the number of {}", what));
  if (rows < 0 || rows > kMostRows) scan.fail("ori/count", fmt::format("there cannot be {} {}", rows, what));
  std::vector<std::array<double, N>> table;
  for (int i = 0; i < rows; ++i) {
    std::array<double, N> row{};
    for (double& x : row) x = scan.number(fmt::format("row {} of the {}", i, what));
    table.push_back(row);
  }
  return table;
}

template <std::size_t N>
std::vector<std::array<double, N>> json_table(const nlohmann::json& root, const char* key, const std::string& name) {
  const auto at = root.find(key);
  if (at == root.end() || !at->is_array())
    throw InvalidInput("ori/key", fmt::format("the file has no list '{}'", key), name);
  std::vector<std::array<double, N>> table;
  for (const nlohmann::json& row : *at) {
    const bool fits = row.is_array() && row.size() >= N &&
                      std::all_of(row.begin(), row.end(), [](const nlohmann::json& x) { return x.is_number(); });
    if (!fits)
      throw InvalidInput("ori/row", fmt::format("a row of '{}' must have {} numbers", key, N),
                         fmt::format("{}, {}[{}]", name, key, table.size()));
    std::array<double, N> values{};
    for (std::size_t i = 0; i < N; ++i) values[i] = row[i].get<double>();
    table.push_back(values);
  }
  return table;
}

bool is_json(std::string_view bytes) {
  const auto first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{';
}

Tables read_tables(std::string_view bytes, const std::string& name) {
  Tables tables;
  if (is_json(bytes)) {
    const nlohmann::json root = parse_json(bytes, name, "ori");
    tables.vertices = json_table<3>(root, "vertices", name);
    tables.creases = json_table<5>(root, "creases", name);
    tables.faces = json_table<6>(root, "faces", name);
    return tables;
  }
  TextScanner scan(bytes, name);  // what follows the faces (base, order, placement) says nothing about the sheet
  tables.vertices = text_table<3>(scan, "vertices");
  tables.creases = text_table<5>(scan, "creases");
  tables.faces = text_table<6>(scan, "faces");
  return tables;
}

class Import {
 public:
  Import(const Tables& tables, std::string name) : tables_(tables), name_(std::move(name)) {}

  OriFile run() {
    lay_vertices();
    lay_faces();
    add_creases();
    add_other_sides();
    find_signs();
    set_angles();
    return std::move(result_);
  }

 private:
  using Side = std::pair<int, int>;  // vertices, ascending

  [[noreturn]] void fail(const char* code, const std::string& message, const std::string& where,
                         const std::string& suggestion = {}) const {
    throw InvalidInput(code, message, fmt::format("{}, {}", name_, where), suggestion);
  }

  CreasePattern& sheet() { return result_.pattern.sheet; }

  int id(double value, std::size_t size, const std::string& where) const {
    if (!(value >= 0 && value < static_cast<double>(size)) || value != std::floor(value))
      fail("ori/id", fmt::format("there is no number {}", value), where);
    return static_cast<int>(value);
  }

  void lay_vertices() {
    if (tables_.vertices.empty() || tables_.faces.empty())
      throw InvalidInput("ori/empty", "the file has no panels", name_);
    double largest = 0;
    std::array<double, 3> most{};
    for (std::size_t v = 0; v < tables_.vertices.size(); ++v)
      for (int i = 0; i < 3; ++i) {
        const double x = tables_.vertices[v][i];
        if (!(std::abs(x) <= kLargestCoordinate))
          fail("read/number", fmt::format("a coordinate is {}, must be finite", x), fmt::format("vertex {}", v));
        most[i] = std::max(most[i], std::abs(x));
        largest = std::max(largest, std::abs(x));
      }
    const bool in_xy = most[2] <= kFlat * largest, in_xz = most[1] <= kFlat * largest;
    if (!in_xy && !in_xz)
      throw InvalidInput("ori/not-flat", "the sheet lies neither in the xy plane nor in the xz plane", name_);
    for (const auto& [x, y, z] : tables_.vertices) sheet().vertices.push_back(in_xy ? Vec2(x, y) : Vec2(x, 0.0 - z));
  }

  void lay_faces() {
    for (std::size_t f = 0; f < tables_.faces.size(); ++f) {
      const auto& row = tables_.faces[f];
      const std::string where = fmt::format("face {}", f);
      if (row[0] != 3) fail("ori/face", "a face must be a triangle: 3 a b c parent crease", where);
      std::vector<int> face;
      for (int i = 1; i <= 3; ++i) face.push_back(id(row[i], sheet().vertices.size(), where));
      const Vec2 &a = sheet().vertices[face[0]], &b = sheet().vertices[face[1]], &c = sheet().vertices[face[2]];
      const double turn = cross(b - a, c - a);
      if (turn == 0) fail("ori/face", "a face has no area", where);
      if (turn < 0) std::swap(face[1], face[2]);
      for (int i = 0; i < 3; ++i) sides_[side(face[i], face[(i + 1) % 3])].push_back(static_cast<int>(f));
      sheet().faces.push_back(std::move(face));
    }
    for (const auto& [side, faces] : sides_)
      if (faces.size() > 2)
        fail("ori/side", "more than two faces meet at one side",
             fmt::format("vertices {}-{}", side.first, side.second));
  }

  static Side side(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  void add_creases() {
    for (std::size_t c = 0; c < tables_.creases.size(); ++c) {
      const std::string where = fmt::format("crease {}", c);
      const int a = id(tables_.creases[c][0], sheet().vertices.size(), where);
      const int b = id(tables_.creases[c][1], sheet().vertices.size(), where);
      const auto at = sides_.find(side(a, b));
      if (at == sides_.end() || at->second.size() != 2)
        fail("ori/crease", fmt::format("vertices {}-{} are not a side of two faces", a, b), where);
      if (!crease_of_.emplace(at->first, static_cast<int>(c)).second)
        fail("ori/crease", fmt::format("vertices {}-{} have two creases", a, b), where);
      sheet().edges.push_back({a, b, Assignment::Flat, 0});
    }
  }

  void add_other_sides() {
    for (const auto& [side, faces] : sides_)
      if (crease_of_.count(side) == 0)
        sheet().edges.push_back(
            {side.first, side.second, faces.size() == 2 ? Assignment::Join : Assignment::Boundary, 0});
  }

  // Which side of v1 -> v2 turns by the angle: the child's, for creases of the tree. All others follow the majority.
  void find_signs() {
    result_.sign.assign(tables_.creases.size(), 0);
    int sum = 0;
    for (std::size_t f = 0; f < tables_.faces.size(); ++f) {
      const std::string where = fmt::format("face {}", f);
      if (tables_.faces[f][5] < 0) continue;  // the base
      const int c = id(tables_.faces[f][5], tables_.creases.size(), where);
      const Crease& crease = sheet().edges[c];
      const std::vector<int>& face = sheet().faces[f];
      const auto apex = std::find_if(face.begin(), face.end(), [&](int v) { return v != crease.a && v != crease.b; });
      const std::vector<int>& beside = sides_.at(side(crease.a, crease.b));
      if (std::find(beside.begin(), beside.end(), static_cast<int>(f)) == beside.end())
        fail("ori/face", fmt::format("the face does not have crease {}, about which it turns", c), where);
      const Vec2& from = sheet().vertices[crease.a];
      result_.sign[c] = cross(sheet().vertices[crease.b] - from, sheet().vertices[*apex] - from) > 0 ? 1 : -1;
      sum += result_.sign[c];
    }
    std::replace(result_.sign.begin(), result_.sign.end(), 0, sum >= 0 ? 1 : -1);
  }

  void set_angles() {
    int rounded = 0;
    for (std::size_t c = 0; c < tables_.creases.size(); ++c) {
      double angle = result_.sign[c] * tables_.creases[c][2];
      if (!(std::abs(angle) <= kPi + kBeyond))
        fail("ori/angle", fmt::format("the fold angle is {:.6g} degrees, at most 180 are possible", degrees(angle)),
             fmt::format("crease {}", c));
      const double right = kPi / 2 * std::round(angle / (kPi / 2));
      if (angle != right && std::abs(angle - right) <= kRounded) angle = right, ++rounded;
      sheet().edges[c].fold_angle = std::clamp(angle, -kPi, kPi);
      sheet().edges[c].assignment = assignment_of(angle);
    }
    if (rounded > 0)
      result_.pattern.notes.push_back(
          fmt::format("{} fold angle{} within 0.0003 degrees of a multiple of 90 {} taken for it", rounded,
                      rounded == 1 ? "" : "s", rounded == 1 ? "was" : "were"));
  }

  const Tables& tables_;
  std::string name_;
  OriFile result_;
  std::map<Side, std::vector<int>> sides_;  // faces at each
  std::map<Side, int> crease_of_;
};

struct ListedState {
  std::vector<double> angles;  // radians
  std::string where;
};

std::vector<ListedState> text_frames(std::string_view bytes, const std::string& name) {
  TextScanner scan(bytes, name);
  std::vector<ListedState> frames;
  while (scan.more()) {
    ListedState& frame = frames.emplace_back();
    frame.where = fmt::format("{}:{}", name, scan.line());
    while (scan.more_on_line()) frame.angles.push_back(radians(scan.number("a fold angle")));
  }
  return frames;
}

std::vector<ListedState> json_frames(std::string_view bytes, const std::string& name) {
  const nlohmann::json root = parse_json(bytes, name, "trj");
  const auto at = root.find("trajs");
  if (at == root.end() || !at->is_array()) throw InvalidInput("trj/key", "the file has no list 'trajs'", name);
  std::vector<ListedState> frames;
  for (const nlohmann::json& row : *at) {
    ListedState frame{{}, fmt::format("{}, trajs[{}]", name, frames.size())};
    if (!row.is_array()) throw InvalidInput("trj/frame", "a frame must be a list of angles", frame.where);
    for (const nlohmann::json& x : row) {
      if (!x.is_number()) throw InvalidInput("trj/frame", "a frame must be a list of angles", frame.where);
      frame.angles.push_back(x.get<double>());
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace

OriFile read_ori(std::string_view bytes, const std::string& name) {
  return Import(read_tables(bytes, name), name).run();
}

FoldingPath read_trj(std::string_view bytes, const OriFile& ori, const std::string& name) {
  const std::vector<ListedState> frames = is_json(bytes) ? json_frames(bytes, name) : text_frames(bytes, name);
  if (frames.size() < 2)
    throw InvalidInput("trj/frames", fmt::format("a motion needs two frames at least, there are {}", frames.size()),
                       name);
  const std::vector<int> hinges = hinge_of_edge(ori.pattern.sheet);
  const auto moving = std::count_if(hinges.begin(), hinges.end(), [](int h) { return h >= 0; });
  FoldingPath path;
  for (const ListedState& frame : frames) {
    if (frame.angles.size() != ori.sign.size())
      throw InvalidInput(
          "trj/frame",
          fmt::format("a frame has {} angles, the sheet has {} creases", frame.angles.size(), ori.sign.size()),
          frame.where);
    Waypoint waypoint{static_cast<double>(path.waypoints.size()) / static_cast<double>(frames.size() - 1),
                      Configuration::Zero(moving)};
    for (std::size_t c = 0; c < frame.angles.size(); ++c) {
      const double angle = ori.sign[c] * frame.angles[c];
      if (!(std::abs(angle) <= kPi + kBeyond))
        throw InvalidInput(
            "trj/angle", fmt::format("crease {} folds by {:.6g} degrees, at most 180 are possible", c, degrees(angle)),
            frame.where);
      waypoint.config[hinges[c]] = std::clamp(angle, -kPi, kPi);
    }
    path.waypoints.push_back(std::move(waypoint));
  }
  return path;
}

}  // namespace plico
