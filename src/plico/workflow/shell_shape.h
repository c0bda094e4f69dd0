// Disjoint convex shells of a shape, judged; and what is written of them.
#pragma once
#include <string>
#include <vector>

#include "plico/convex/remesh.h"
#include "plico/convex/shells.h"
#include "plico/io/mesh/obj.h"
#include "plico/verify/shells.h"

namespace plico {

struct JudgedShells {
  Shells shells;
  ShellsVerdict verdict;  // judged to the end, even when the search was stopped
};

// disjoint_shells(), then verify_shells() on its triangles, planes, contacts and loss.
JudgedShells shell_shape(const std::vector<ShapePart>& parts, const ShellOptions& options, const Run& run);

struct JudgedRemeshing {
  Remeshing remeshing;
  ShellsVerdict verdict;  // against the shells as they were
};

// remesh(), then verify_remeshed_shells().
JudgedRemeshing remesh_shells(const Shells& shells, const RemeshOptions& options, const Run& run);

// One object a shell, named after its part.
std::vector<ObjObject> shell_objects(const std::vector<ShapePart>& parts, const Shells& shells);

}  // namespace plico
