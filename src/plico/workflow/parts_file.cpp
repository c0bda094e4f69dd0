#include "plico/workflow/parts_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/mesh/measures.h"
#include "plico/segment/seams.h"

namespace plico {
namespace {

using Json = nlohmann::json;

constexpr const char* kPartsKey = "plico:parts";
constexpr const char* kSeamKey = "edges_plico:seam";

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
  file.other.emplace_back(kPartsKey, parts_json(mesh, result).dump());
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
  }
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
