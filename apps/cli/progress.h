// Progress of long work, on standard error.
#pragma once
#include <memory>
#include <string>

#include "plico/base/run.h"

namespace plico::cli {

// Progress that people see.
class ShownProgress : public Progress {
 public:
  virtual void erase() {}  // what would stand in the way of a line of text
};

// `style` is bar (one line, redrawn), plain (a line now and then), phases (a line for each phase, with the time it
// began at), json (one object a line), none, or auto: bar on a terminal, else none. Null for none. The bar erases
// itself when destroyed.
std::unique_ptr<ShownProgress> make_progress(const std::string& style);

}  // namespace plico::cli
