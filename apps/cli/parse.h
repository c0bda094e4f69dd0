// Reads a command line by a table of options.
#pragma once
#include <string>
#include <vector>

#include "command.h"

namespace plico::cli {

// One option or positional as it was given; a flag has the value "true".
struct Given {
  const Option* option = nullptr;
  std::string value;
};

// Sets every option of `table` that `words` give, in the table's order, and returns them; the result points into the
// table. "--name=value", "-nvalue", "-vv" and "--" mean what they mean elsewhere; "-" is a value. Throws InvalidOption
// on unknown options (with the nearest known one), missing values and bad values (naming the option).
std::vector<Given> parse(const Command& command, const std::vector<Option>& table,
                         const std::vector<std::string>& words);

}  // namespace plico::cli
