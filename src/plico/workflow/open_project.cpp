#include "plico/workflow/open_project.h"

#include <optional>
#include <utility>

#include "plico/io/mesh/mesh_file.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/text/file.h"
#include "plico/mesh/repair.h"

namespace plico {
namespace {

std::string without_folder_and_kind(const std::string& path) {
  const std::size_t slash = path.find_last_of("/\\");
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.find_last_of('.'));
}

Mesh repaired_mesh(MeshSource source, std::vector<std::string>& notes) {
  const CheckOptions strict{.planarity = kFlatPolygon, .self_intersections = false};
  Repaired repaired = repair(source.soup, {.level = RepairLevel::Safe, .planarity = kFlatPolygon});
  for (const std::string& sentence : repaired.done) notes.push_back("repaired: " + sentence);
  if (check_mesh(repaired.soup, strict).usable()) return Mesh(std::move(repaired.soup));
  return to_mesh(std::move(source), strict);  // throws, with the place in the file
}

OpenedProject project_of_net(const std::string& bytes, const std::string& name) {
  FoldFile file = read_fold(bytes, name);
  Mesh mesh = folded_mesh(file);
  attach_mesh(file.net, mesh);
  const FoldForest forest = forest_of(mesh, file.net);
  OpenedProject opened{new_project(without_folder_and_kind(name), std::move(mesh)), std::move(file.notes), true};
  apply_edit(opened.project, replacement(forest));
  return opened;
}

}  // namespace

ReplaceNet replacement(const FoldForest& forest) {
  ReplaceNet edit;
  for (std::size_t e = 0; e < forest.is_fold.size(); ++e)
    if (forest.is_fold[e]) edit.folds.push_back(static_cast<int>(e));
  return edit;
}

OpenedProject open_project(const std::string& bytes, const std::string& name) {
  const std::string kind = extension(name);
  if (kind == "plico") return {read_project(bytes, name), {}, true};
  if (kind == "fold") return project_of_net(bytes, name);
  OpenedProject opened;
  Mesh mesh = repaired_mesh(read_mesh_source(bytes, name), opened.notes);
  opened.project = new_project(without_folder_and_kind(name), std::move(mesh));
  return opened;
}

}  // namespace plico
