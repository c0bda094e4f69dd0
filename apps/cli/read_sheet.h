// How commands read what is flat: nets, crease patterns and motions, of every kind we know.
#pragma once
#include <string>

#include "plico/io/pattern/fold.h"
#include "session.h"

namespace plico::cli {

// Says on standard error, and in the report, what reading changed or assumed.
FoldFile read_sheet(const std::string& path, Session& session);

}  // namespace plico::cli
