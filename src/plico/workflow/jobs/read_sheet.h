// How commands read, and write, what is flat: nets, crease patterns and motions, of every kind we know.
#pragma once
#include <string>
#include <vector>

#include "plico/io/pattern/fold.h"
#include "plico/io/pattern/imported_pattern.h"
#include "plico/workflow/jobs/job.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

// Says on standard error, and in the report, what reading changed or assumed.
FoldFile read_sheet(const std::string& path, Session& session, const DrawingOptions& drawing = {});

// --merge and --flatten.
void add_drawing_options(Job& job, DrawingOptions& drawing);

// Where a command that writes FOLD files writes: session.outputs("-"), refused when a name asks for another kind.
std::vector<std::string> fold_outputs(const Session& session);

// Writes the file to each path, with how it was made in it.
void write_fold_files(FoldFile file, const std::vector<std::string>& paths, Session& session);

}  // namespace plico::jobs
