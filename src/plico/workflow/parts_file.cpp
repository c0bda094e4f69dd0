#include "plico/workflow/parts_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "plico/base/error.h"
#include "plico/io/pattern/fold_pieces.h"
#include "plico/mesh/measures.h"
#include "plico/segment/seams.h"
#include "plico/workflow/kit_motion.h"

namespace plico {
namespace {

using Json = nlohmann::json;

constexpr const char* kPartsKey = "plico:parts";
constexpr const char* kSeamKey = "edges_plico:seam";
constexpr const char* kJointsKey = "plico:joints";

Json part_motion_json(const ProvenPart& part) {
  if (!part.motion) return nullptr;
  const PathProof& proof = part.motion->proof;
  return {{"kind", name(part.motion->method)}, {"verdict", name(proof.verdict)}, {"clearance", proof.clearance}};
}

Json size_of_net(const Unfolding& net) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : net.sheet.vertices) box.extend(p);
  return {box.sizes().x(), box.sizes().y()};
}

Json neighbors_json(const std::vector<SeamLength>& seams, int part) {
  Json list = Json::array();
  for (const SeamLength& seam : seams)
    if (seam.a == part || seam.b == part)
      list.push_back({{"part", seam.a == part ? seam.b : seam.a}, {"length", seam.length}});
  return list;
}

// Null where nothing of another part is glued.
Json seams_json(const Mesh& mesh, const Kit& result) {
  Json list = Json::array();
  for (int number : seams_of(mesh, result)) list.push_back(number > 0 ? Json(number) : Json());
  return list;
}

// Facets that are glued face to face; parts and faces by number.
Json joints_key(const std::vector<Joint>& joints) {
  Json list = Json::array();
  for (const Joint& joint : joints) {
    Json polygon = Json::array();
    for (const Vec3& p : joint.polygon) polygon.push_back({p.x(), p.y(), p.z()});
    list.push_back({{"parts", {joint.first, joint.second}},
                    {"faces", {joint.first_face, joint.second_face}},
                    {"polygon", std::move(polygon)}});
  }
  return list;
}

// What each piece of the net is called.
std::vector<std::string> piece_titles(const Kit& kit) {
  std::vector<std::string> titles(kit.net.num_parts());
  for (std::size_t i = 0; i < kit.pieces.size(); ++i)
    for (std::size_t k = 0; k < kit.pieces[i].size(); ++k)
      titles[kit.pieces[i][k]] =
          kit.pieces[i].size() == 1 ? kit.parts.names[i] : fmt::format("{}.{}", kit.parts.names[i], k + 1);
  return titles;
}

// Who reads the file may fold by it, so motions that are not proven stay out.
std::vector<std::optional<FoldingPath>> proven_paths(const Mesh& mesh, const Kit& kit) {
  std::vector<std::optional<FoldingPath>> paths = paths_of_pieces(mesh, kit, pieces_of(kit.net));
  for (std::size_t i = 0; i < kit.part.size(); ++i)
    for (int piece : kit.pieces[i])
      if (paths[piece] && kit.part[i].motion->proof.verdict != PathVerdict::Free) paths[piece].reset();
  return paths;
}

void add_motions(FoldFile& file, const Mesh& mesh, const Kit& kit) {
  const std::vector<std::optional<FoldingPath>> paths = proven_paths(mesh, kit);
  if (paths.size() > 1)
    set_pieces(file, piece_titles(kit), paths);
  else if (!paths.empty() && paths[0])
    set_path(file, linkage_of(kit.net), *paths[0]);
}

[[noreturn]] void refuse_claim(const std::string& what, const std::string& where) {
  throw InvalidInput("fold/parts", what, where);
}

std::vector<int> integers(const Json& list, const std::string& where) {
  if (!list.is_array()) refuse_claim("a list of numbers is missing or something else", where);
  std::vector<int> values;
  for (const Json& value : list) {
    if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() > 1e9)
      refuse_claim(fmt::format("a number is {}, must be an index", value.dump()), where);
    values.push_back(value.get<int>());
  }
  return values;
}

// The value under a key of an object, as it is; null where there is none.
Json value_in(const Json& object, const char* key) { return object.is_object() ? object.value(key, Json()) : Json(); }

Vec3 point_of(const Json& row, const std::string& where) {
  const bool is_point = row.is_array() && row.size() == 3 &&
                        std::all_of(row.begin(), row.end(), [](const Json& x) { return x.is_number(); });
  if (!is_point) refuse_claim("a corner must be three numbers", where);
  return {row[0].get<double>(), row[1].get<double>(), row[2].get<double>()};
}

// Two numbers under `key`.
std::pair<int, int> pair_of(const Json& joint, const char* key, const std::string& where) {
  const std::vector<int> two = integers(value_in(joint, key), fmt::format("{}.{}", where, key));
  if (two.size() != 2) refuse_claim("a joint has two sides", fmt::format("{}.{}", where, key));
  return {two[0], two[1]};
}

std::vector<JointClaim> joint_claims(const Json& list) {
  if (!list.is_array()) refuse_claim("plico:joints is not an array", kJointsKey);
  std::vector<JointClaim> joints;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string where = fmt::format("{}[{}]", kJointsKey, i);
    JointClaim& joint = joints.emplace_back();
    std::tie(joint.first_face, joint.second_face) = pair_of(list[i], "faces", where);
    std::tie(joint.first, joint.second) = pair_of(list[i], "parts", where);
    const Json polygon = value_in(list[i], "polygon");
    if (!polygon.is_array()) refuse_claim("a joint has no polygon", where);
    for (const Json& corner : polygon) joint.polygon.push_back(point_of(corner, where + ".polygon"));
  }
  return joints;
}

const std::string* value_of(const FoldFile& file, const std::string& key) {
  for (const auto& [name, value] : file.other)
    if (name == key) return &value;
  return nullptr;
}

}  // namespace

Json parts_json(const Mesh& mesh, const Kit& result) {
  const std::vector<std::vector<FaceId>> faces = faces_of_parts(result.parts);
  const std::vector<SeamLength> seams = seam_lengths(mesh, result.parts);
  const std::vector<int> step = assembly_steps(mesh, result.parts, result.joints);
  Json list = Json::array();
  for (int i = 0; i < result.parts.num_parts(); ++i) {
    const ProvenPart& part = result.part[i];
    list.push_back({{"id", i},
                    {"name", result.parts.names[i]},
                    {"faces", std::vector<int>(faces[i].begin(), faces[i].end())},
                    {"area", surface_area(part.shape.mesh)},
                    {"pieces", result.pieces[i]},
                    {"size", size_of_net(part.net)},
                    {"neighbors", neighbors_json(seams, i)},
                    {"step", step[i]},
                    {"proven", part.proven()},
                    {"motion", part_motion_json(part)}});
    if (!result.mirror.empty()) list.back()["mirror"] = result.mirror[i] < 0 ? Json() : Json(result.mirror[i]);
  }
  return list;
}

FoldFile parts_file(const Mesh& mesh, const Kit& result) {
  FoldFile file = fold_file(mesh, result.net);
  file.other.emplace_back(kSeamKey, seams_json(mesh, result).dump());
  if (!result.joints.empty()) file.other.emplace_back(kJointsKey, joints_key(result.joints).dump());
  file.other.emplace_back(kPartsKey, parts_json(mesh, result).dump());
  add_motions(file, mesh, result);
  return file;
}

FoldFile part_motion_file(const ProvenPart& part) {
  FoldFile file = fold_file(part.shape.mesh, part.net);
  if (part.motion) set_path(file, linkage_of(part.net), part.motion->path);
  return file;
}

std::vector<int> seams_of(const Mesh& mesh, const Kit& kit) {
  const std::vector<int> number = seam_numbers(mesh, kit.parts);
  std::vector<int> of_sheet;
  for (int e : kit.net.mesh_edge) of_sheet.push_back(number[e]);
  return of_sheet;
}

std::vector<PartTitle> part_titles(const std::vector<std::string>& names, const std::vector<std::vector<int>>& pieces) {
  std::size_t count = 0;
  for (const std::vector<int>& of_part : pieces) count += of_part.size();
  std::vector<PartTitle> titles(count);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < pieces[i].size(); ++k) {
      const int piece = pieces[i][k];
      if (piece < 0 || piece >= static_cast<int>(count) || !titles[piece].id.empty())
        refuse_claim(fmt::format("piece {} is of no part, or of two", piece),
                     fmt::format("{}[{}].pieces", kPartsKey, i));
      const bool is_id = names[i].size() <= 2 && !names[i].empty();
      titles[piece] = {is_id ? names[i] : part_name(static_cast<int>(i)), is_id ? "" : names[i]};
      if (pieces[i].size() > 1) titles[piece].id += fmt::format(".{}", k + 1);
    }
  return titles;
}

std::vector<Joint> joints_of(const PartsClaim& claim, const Mesh& mesh) {
  for (const Defect& defect : verify_joints(mesh, claim.joints))
    throw InvalidInput(defect.code, defect.message, kJointsKey, "plico verify says all that is wrong");
  std::vector<Joint> joints;
  for (const JointClaim& joint : claim.joints) {
    for (int part : {joint.first, joint.second})
      if (part < 0 || part >= static_cast<int>(claim.pieces.size()) || claim.pieces[part].empty())
        throw InvalidInput("fold/joints",
                           fmt::format("joint {} is of part {}, of which there is no piece", joints.size() + 1, part),
                           fmt::format("{}[{}]", kJointsKey, joints.size()));
    joints.push_back({joint.first, joint.second, joint.first_face, joint.second_face, joint.polygon});
  }
  return joints;
}

std::optional<PartsClaim> parts_claim(const FoldFile& file) {
  const std::string* text = value_of(file, kPartsKey);
  if (!text) return std::nullopt;
  const Json list = Json::parse(*text);
  if (!list.is_array()) refuse_claim("plico:parts is not an array", kPartsKey);
  PartsClaim claim;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string where = fmt::format("{}[{}]", kPartsKey, i);
    const Json& part = list[i];
    if (!part.is_object() || !part.value("name", Json()).is_string()) refuse_claim("a part has no name", where);
    claim.names.push_back(part["name"].get<std::string>());
    claim.faces.push_back(integers(part.value("faces", Json()), where + ".faces"));
    claim.pieces.push_back(integers(part.value("pieces", Json()), where + ".pieces"));
    claim.steps.push_back(integers(Json::array({part.value("step", Json(0))}), where + ".step")[0]);
    const Json motion = value_in(part, "motion");
    claim.folds.push_back(value_in(motion, "verdict") == Json("free"));
  }
  if (const std::string* joints = value_of(file, kJointsKey)) claim.joints = joint_claims(Json::parse(*joints));
  for (const FoldPiece& piece : file.pieces) claim.alone.push_back({piece.title, piece.path.has_value()});
  claim.seam.assign(file.net.sheet.edges.size(), 0);
  if (const std::string* numbers = value_of(file, kSeamKey)) {
    Json seam = Json::parse(*numbers);
    if (seam.is_array())
      for (Json& number : seam)
        if (number.is_null()) number = 0;
    claim.seam = integers(seam, kSeamKey);
  }
  return claim;
}

}  // namespace plico
