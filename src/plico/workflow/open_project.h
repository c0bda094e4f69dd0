// From a file of any kind that holds a shape to a project: a project itself, a net with its folded form, or a mesh.
#pragma once
#include <string>
#include <vector>

#include "plico/project/project.h"

namespace plico {

struct OpenedProject {
  Project project;
  std::vector<std::string> notes;  // what was repaired or assumed, one sentence each
  bool has_net = false;            // the file had folds; a mesh has none yet
};

// `name` is the file's, for its kind and for messages. Meshes are repaired as commands do (safe repairs). Throws
// InvalidInput for what cannot be read or has no folded form.
OpenedProject open_project(const std::string& bytes, const std::string& name);

// The edges that a net keeps as folds, as the edit that makes them so.
ReplaceNet replacement(const FoldForest& forest);

}  // namespace plico
