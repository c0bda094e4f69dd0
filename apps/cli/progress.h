// Progress of long work, on standard error.
#pragma once
#include <memory>
#include <string>

#include "plico/base/run.h"

namespace plico::cli {

// `style` is bar (one line, redrawn), plain (a line now and then), json (one object a line), none, or auto: bar on a
// terminal, else none. Null for none. The bar erases itself when destroyed.
std::unique_ptr<Progress> make_progress(const std::string& style);

}  // namespace plico::cli
