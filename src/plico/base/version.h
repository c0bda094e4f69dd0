// The version of the library and the program, as reports and files name it.
#pragma once
#include <string>

namespace plico {

std::string version();  // "0.1.0"

}  // namespace plico
