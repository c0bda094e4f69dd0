#include "plico/workflow/jobs/read_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/mesh/read_paint.h"
#include "plico/mesh/flat_regions.h"
#include "plico/mesh/repair.h"

namespace plico::jobs {
namespace {

// A net of so many faces is laid flat, judged and written in about this time.
constexpr double kSecondsAFace = 4e-5;

MeshSource read_source(const std::string& path, Session& session) { return read_mesh_source(session.read(path), path); }

Paint paint_of(const MeshSource& source, const std::string& path, Session& session) {
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  const auto beside = [&](const std::string& name) -> std::optional<std::string> {
    if (path == "-" || name.starts_with('/')) return {};
    try {
      return session.read(folder + name);
    } catch (const FileError&) {
      return {};
    }
  };
  PaintRead read = read_paint(source, beside);
  for (const std::string& note : read.notes) session.warn(note);
  return std::move(read.paint);
}

Mesh repaired_mesh(MeshSource source, const std::string& path, const std::string& repair, Session& session) {
  session.keep_time(kSecondsAFace * source.soup.num_faces());
  const CheckOptions strict{.planarity = kFlatPolygon, .self_intersections = false};
  if (repair == "none") return to_mesh(std::move(source), strict);
  const RepairOptions how{.level = repair == "full" ? RepairLevel::Full : RepairLevel::Safe, .planarity = kFlatPolygon};
  Repaired repaired = plico::repair(source.soup, how);
  for (const std::string& sentence : repaired.done) session.say("repaired: " + sentence);
  session.report()["repairs"] = repaired.done;
  const CheckReport report = check_mesh(repaired.soup, strict);
  if (report.usable()) return Mesh(std::move(repaired.soup));
  const Problem& error = report.problems.front();
  const std::string full = "add --repair full, which may change the shape";
  // In the file as it is the error has a place; after a repair its numbers are no longer those of the file.
  if (repaired.done.empty()) {
    if (repair != "safe" || error.code != "mesh/edge-faces") return to_mesh(std::move(source), strict);
    throw InvalidInput(error.code, error.message, fmt::format("{}: {}", place_of(source, error), error.where), full);
  }
  throw InvalidInput(error.code, error.message + ", after what was repaired", error.where,
                     repair == "safe" ? full : "plico check " + path);
}

}  // namespace

Job& add_repair_option(Job& job, std::string& repair) {
  return job.choice("--repair",
                    "safe joins corners that coincide, cuts polygons that are not flat, drops faces without area, "
                    "turns faces to agree; full also changes the shape where it must",
                    repair, {"safe", "full", "none"});
}

Mesh read_mesh(const std::string& path, const std::string& repair, Session& session) {
  return repaired_mesh(read_source(path, session), path, repair, session);
}

PaintedMesh read_painted_mesh(const std::string& path, const std::string& repair, Session& session) {
  MeshSource source = read_source(path, session);
  Paint paint = paint_of(source, path, session);
  return {repaired_mesh(std::move(source), path, repair, session), std::move(paint)};
}

Paint read_paint_of(const std::string& path, Session& session) {
  return paint_of(read_source(path, session), path, session);
}

void warn_of_many_faces(const Mesh& mesh, const std::string& path, Session& session) {
  if (mesh.num_faces() < kFarTooMany) return;
  const double times = mesh.num_faces() / double(kFarTooMany);
  const double seconds = 2 * times * times * std::sqrt(times);
  session.warn(fmt::format(
      "{} faces are far more than hands can fold, and a net of them takes about {}; try plico craft {} --faces 300",
      mesh.num_faces(), seconds < 100 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60),
      quoted(path)));
}

MeshFormat output_format(const std::string& path) {
  if (path == "-") return MeshFormat::Obj;
  if (const auto format = mesh_format_of(path); format && *format != MeshFormat::Gltf) return *format;
  throw InvalidOption(fmt::format("{} does not end in .obj, .off, .stl or .ply", path));
}

Mesh with_flat_regions_whole(Mesh mesh, Session& session) {
  const int faces = mesh.num_faces();
  Mesh whole = plico::with_flat_regions_whole(std::move(mesh));
  if (whole.num_faces() == faces) return whole;
  session.say(fmt::format("flat regions: {} faces are taken as {}", faces, whole.num_faces()));
  session.report()["flat_regions"] = {{"faces_before", faces}, {"faces", whole.num_faces()}};
  return whole;
}

Mesh read_mesh_of_net(const std::string& path, const std::string& repair, int panels, Session& session) {
  Mesh mesh = read_mesh(path, repair, session);
  if (mesh.num_faces() == panels) return mesh;
  Mesh whole = with_flat_regions_whole(mesh, session);
  return whole.num_faces() == panels ? whole : mesh;
}

}  // namespace plico::jobs
