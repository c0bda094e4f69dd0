#include "read_mesh.h"

#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/repair.h"

namespace plico::cli {
Command& add_repair_option(Command& command, std::string& repair) {
  return command.choice("--repair",
                        "safe joins corners that coincide, cuts polygons that are not flat, drops faces without area, "
                        "turns faces to agree; full also changes the shape where it must",
                        repair, {"safe", "full", "none"});
}

Mesh read_mesh(const std::string& path, const std::string& repair, Session& session) {
  MeshSource source = read_mesh_source(session.read(path), path);
  const CheckOptions strict{.planarity = kFlatPolygon, .self_intersections = false};
  if (repair == "none") return to_mesh(std::move(source), strict);
  const RepairOptions how{.level = repair == "full" ? RepairLevel::Full : RepairLevel::Safe, .planarity = kFlatPolygon};
  Repaired repaired = plico::repair(source.soup, how);
  for (const std::string& sentence : repaired.done) session.say("repaired: " + sentence);
  session.report()["repairs"] = repaired.done;
  const CheckReport report = check_mesh(repaired.soup, strict);
  if (report.usable()) return Mesh(std::move(repaired.soup));
  // In the file as it is the error has a place; after a repair its numbers are no longer those of the file.
  if (repaired.done.empty()) return to_mesh(std::move(source), strict);
  const Problem& error = report.problems.front();
  throw InvalidInput(error.code, error.message + ", after what was repaired", error.where,
                     repair == "safe" ? "add --repair full, which may change the shape" : "plico check " + path);
}

}  // namespace plico::cli
