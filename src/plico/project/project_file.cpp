#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/text/parse_json.h"
#include "plico/project/project.h"

namespace plico {
namespace {

using nlohmann::json;
using Ordered = nlohmann::ordered_json;

constexpr int kVersion = 1;

struct ToJson {
  Ordered operator()(const CutEdge& edit) const { return {{"edit", "cut"}, {"edge", edit.edge}}; }
  Ordered operator()(const JoinEdge& edit) const { return {{"edit", "join"}, {"edge", edit.edge}}; }
  Ordered operator()(const MoveFold& edit) const { return {{"edit", "move"}, {"join", edit.join}, {"cut", edit.cut}}; }
  Ordered operator()(const LockEdge& edit) const {
    return {{"edit", "lock"}, {"edge", edit.edge}, {"locked", edit.locked}};
  }
  Ordered operator()(const ReplaceNet& edit) const { return {{"edit", "net"}, {"folds", edit.folds}}; }
};

// One value of a file and the words for where it stands.
class Value {
 public:
  Value(const json& value, std::string place, const std::string& name)
      : value_(value), place_(std::move(place)), name_(name) {}

  Value operator[](const char* key) const {
    const auto found = value_.is_object() ? value_.find(key) : value_.end();
    if (found == value_.end()) fail(fmt::format("{} has no \"{}\"", place_, key));
    return {*found, fmt::format("{}/{}", place_, key), name_};
  }
  std::vector<Value> list() const {
    if (!value_.is_array()) fail(fmt::format("{} must be a list", place_));
    std::vector<Value> items;
    for (const json& item : value_) items.emplace_back(item, fmt::format("{}[{}]", place_, items.size()), name_);
    return items;
  }
  int whole() const {
    constexpr double kMost = std::numeric_limits<int>::max();
    if (!value_.is_number_integer() || std::abs(value_.get<double>()) > kMost)
      fail(fmt::format("{} must be a whole number below 2^31", place_));
    return value_.get<int>();
  }
  std::vector<int> wholes() const {
    std::vector<int> numbers;
    for (const Value& item : list()) numbers.push_back(item.whole());
    return numbers;
  }
  double number() const {
    if (!value_.is_number()) fail(fmt::format("{} must be a number", place_));
    return value_.get<double>();
  }
  std::string text() const {
    if (!value_.is_string()) fail(fmt::format("{} must be a text", place_));
    return value_.get<std::string>();
  }
  bool truth() const {
    if (!value_.is_boolean()) fail(fmt::format("{} must be true or false", place_));
    return value_.get<bool>();
  }
  [[noreturn]] void fail(const std::string& message) const { throw InvalidInput("project/form", message, name_); }

 private:
  const json& value_;
  std::string place_;
  const std::string& name_;
};

Edit edit_of(const Value& value) {
  const std::string kind = value["edit"].text();
  if (kind == "cut") return CutEdge{value["edge"].whole()};
  if (kind == "join") return JoinEdge{value["edge"].whole()};
  if (kind == "move") return MoveFold{value["join"].whole(), value["cut"].whole()};
  if (kind == "lock") return LockEdge{value["edge"].whole(), value["locked"].truth()};
  if (kind == "net") return ReplaceNet{value["folds"].wholes()};
  value.fail(fmt::format("'{}' is no edit, must be cut, join, move, lock or net", kind));
}

std::vector<int> set_entries(const std::vector<char>& flags) {
  std::vector<int> entries;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) entries.push_back(static_cast<int>(i));
  return entries;
}

Mesh mesh_of(const Value& value) {
  PolygonSoup soup;
  for (const Value& p : value["vertices"].list()) {
    const std::vector<Value> x = p.list();
    if (x.size() != 3) p.fail(fmt::format("a vertex has {} coordinates, must be 3", x.size()));
    soup.points.emplace_back(x[0].number(), x[1].number(), x[2].number());
  }
  for (const Value& face : value["faces"].list()) soup.add_face(face.wholes());
  return Mesh(std::move(soup));
}

Project project_of(const Value& value) {
  const int version = value["plico_project"].whole();
  if (version != kVersion) value.fail(fmt::format("version {} of projects must be {}", version, kVersion));
  Project project = new_project(value["name"].text(), mesh_of(value["mesh"]));
  try {
    apply_edit(project, ReplaceNet{value["folds"].wholes()});
    for (int e : value["locked"].wholes()) apply_edit(project, LockEdge{e, true});
  } catch (const InvalidOption& error) {
    value.fail(error.what());
  }
  return project;
}

}  // namespace

std::string write_edits(const std::vector<Edit>& edits) {
  Ordered list = Ordered::array();
  for (const Edit& edit : edits) list.push_back(std::visit(ToJson(), edit));
  return list.dump() + "\n";
}

std::vector<Edit> read_edits(std::string_view text, const std::string& name) {
  const json parsed = parse_json(text, name, "project");
  std::vector<Edit> edits;
  for (const Value& value : Value(parsed, "edits", name).list()) edits.push_back(edit_of(value));
  return edits;
}

std::string write_project(const Project& project) {
  Ordered vertices = Ordered::array(), faces = Ordered::array();
  for (const Vec3& p : project.mesh.soup().points) vertices.push_back({p.x(), p.y(), p.z()});
  for (FaceId f : project.mesh.faces()) {
    const auto corners = project.mesh.corners(f);
    faces.push_back(std::vector<int>(corners.begin(), corners.end()));
  }
  const Ordered file{{"plico_project", kVersion},
                     {"name", project.name},
                     {"mesh", {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}}},
                     {"folds", set_entries(project.forest.is_fold)},
                     {"locked", set_entries(project.locked)}};
  return file.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

Project read_project(std::string_view text, const std::string& name) {
  const json parsed = parse_json(text, name, "project");
  return project_of(Value(parsed, "project", name));
}

}  // namespace plico
