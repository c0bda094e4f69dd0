// What to try after an error that does not say it by itself.
#pragma once
#include <string>

#include "plico/base/error.h"

namespace plico::jobs {

// A job that ended in an error.
struct Attempt {
  std::string job;    // "craft"; may be empty
  std::string input;  // the file it was to read; may be empty
};

// The error's own suggestion; else one command for errors of its code, which shows the place in the file where there is
// one ("sed -n 17p bunny.obj"). Empty for errors that no file and no option leads to.
std::string remedy(const Error& error, const Attempt& attempt);

}  // namespace plico::jobs
