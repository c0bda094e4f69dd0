// Reads a command line by a table of options.
#pragma once
#include <string>
#include <vector>

#include "plico/workflow/jobs/job.h"

namespace plico::cli {

using jobs::Given;
using jobs::Job;
using jobs::Option;

// Sets every option of `table` that `words` give, in the table's order, and returns them; the result points into the
// table. "--name=value", "-nvalue", "-vv" and "--" mean what they mean elsewhere; "-" is a value. Throws InvalidOption
// on unknown options (with the nearest known one), missing values and bad values (naming the option).
std::vector<Given> parse(const Job& job, const std::vector<Option>& table, const std::vector<std::string>& words);

}  // namespace plico::cli
