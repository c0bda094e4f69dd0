// Options that are a number or a share of one.
#pragma once
#include <string>

namespace plico::jobs {

// "12" is 12, "12%" that of `whole`. Throws InvalidOption naming the option.
double share_or_number(const std::string& option, const std::string& word, double whole);

}  // namespace plico::jobs
