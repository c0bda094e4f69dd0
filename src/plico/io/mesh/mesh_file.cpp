#include "plico/io/mesh/mesh_file.h"

#include "plico/base/error.h"
#include "plico/io/mesh/gltf.h"
#include "plico/io/mesh/obj.h"
#include "plico/io/mesh/off.h"
#include "plico/io/mesh/ply.h"
#include "plico/io/mesh/stl.h"
#include "plico/io/text/file.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

MeshSource read_as(std::string_view bytes, MeshFormat format, const std::string& name) {
  switch (format) {
    case MeshFormat::Obj:
      return read_obj(bytes, name);
    case MeshFormat::Off:
      return read_off(bytes, name);
    case MeshFormat::Stl:
      return read_stl(bytes, name);
    case MeshFormat::Ply:
      return read_ply(bytes, name);
    case MeshFormat::Gltf:
      return read_gltf(bytes, name);
  }
  return {};
}

// OBJ has no mark of its own: the first word of its first line that is not a comment.
bool looks_like_obj(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) return false;
  TextScanner scan(bytes, {});
  if (!scan.more()) return false;
  const std::string_view word = scan.word();
  for (std::string_view keyword : {"v", "vn", "vt", "f", "o", "g", "s", "mtllib", "usemtl"})
    if (word == keyword) return true;
  return false;
}

}  // namespace

std::string_view name(MeshFormat format) {
  constexpr std::string_view kNames[] = {"OBJ", "OFF", "STL", "PLY", "glTF"};
  return kNames[static_cast<int>(format)];
}

std::optional<MeshFormat> mesh_format_of(const std::string& path) {
  const std::string ext = extension(path);
  if (ext == "obj") return MeshFormat::Obj;
  if (ext == "off") return MeshFormat::Off;
  if (ext == "stl") return MeshFormat::Stl;
  if (ext == "ply") return MeshFormat::Ply;
  if (ext == "glb" || ext == "gltf") return MeshFormat::Gltf;
  return {};
}

std::optional<MeshFormat> sniff_mesh_format(std::string_view bytes) {
  if (is_binary_stl(bytes)) return MeshFormat::Stl;
  if (is_glb(bytes)) return MeshFormat::Gltf;
  const std::string_view first = bytes.substr(0, bytes.find_first_of(" \t\r\n"));
  if (first == "ply") return MeshFormat::Ply;
  if (first == "solid") return MeshFormat::Stl;
  const std::size_t off = first.find("OFF");  // after at most three letters, before a count when that is glued to it
  if (off <= 3 && first.find_first_not_of("0123456789", off + 3) == std::string_view::npos) return MeshFormat::Off;
  if (looks_like_obj(bytes)) return MeshFormat::Obj;
  return {};
}

PolygonSoup read_mesh(std::string_view bytes, MeshFormat format) { return read_as(bytes, format, "input").soup; }

MeshSource read_mesh_source(std::string_view bytes, const std::string& name) {
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw InvalidInput("read/empty", fmt::format("{} is empty", name), name);
  const auto sniffed = sniff_mesh_format(bytes);
  const auto format = mesh_format_of(name) ? mesh_format_of(name) : sniffed;
  if (!format)
    throw InvalidInput("read/format",
                       fmt::format("{} is none of OBJ, OFF, STL, PLY and glTF, by name or contents", name), name,
                       "save the mesh as OBJ");
  try {
    return read_as(bytes, *format, name);
  } catch (const InvalidInput& error) {
    if (!sniffed || sniffed == format || !error.suggestion().empty()) throw;
    throw InvalidInput(error.code(), error.what(), error.where(),
                       fmt::format("rename the file: it looks like {}", plico::name(*sniffed)));
  }
}

MeshSource read_mesh_file(const std::string& path) { return read_mesh_source(read_file(path), path); }

std::string place_of(const MeshSource& source, const Problem& problem) {
  const auto& places = problem.faces.empty() ? source.point_place : source.face_place;
  const auto& elements = problem.faces.empty() ? problem.vertices : problem.faces;
  if (elements.empty() || elements[0] >= static_cast<int>(places.size())) return source.name;
  return source.place(places[elements[0]]);
}

Mesh to_mesh(MeshSource source, const CheckOptions& options) {
  const CheckReport report = check_mesh(source.soup, options);
  if (report.usable()) return Mesh(std::move(source.soup));
  const Problem& first = report.problems.front();
  const std::string place = place_of(source, first);
  throw InvalidInput(first.code, first.message, first.where.empty() ? place : place + ": " + first.where,
                     first.suggestion.empty() ? "" : fmt::format("{} {}", first.suggestion, source.name));
}

Mesh load_mesh(const std::string& path) { return to_mesh(read_mesh_file(path)); }

std::string write_mesh(const PolygonSoup& soup, MeshFormat format) {
  switch (format) {
    case MeshFormat::Obj:
      return write_obj(soup);
    case MeshFormat::Off:
      return write_off(soup);
    case MeshFormat::Stl:
      return write_stl(soup);
    case MeshFormat::Ply:
      return write_ply(soup);
    case MeshFormat::Gltf:
      throw InvalidOption("meshes are not written as glTF", "write OBJ, OFF, STL or PLY");
  }
  return {};
}

}  // namespace plico
