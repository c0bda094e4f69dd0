// How commands read what is flat: nets, crease patterns and motions, of every kind we know.
#pragma once
#include <string>
#include <vector>

#include "plico/io/pattern/fold.h"
#include "session.h"

namespace plico::cli {

// Says on standard error, and in the report, what reading changed or assumed.
FoldFile read_sheet(const std::string& path, Session& session);

// Where a command that writes FOLD files writes: session.outputs("-"), refused when a name asks for another kind.
std::vector<std::string> fold_outputs(const Session& session);

}  // namespace plico::cli
