// Colour on terminals, for words that should catch the eye.
#pragma once
#include <string>
#include <string_view>

namespace plico::cli {

enum class Highlight { Error, Warning };

// The text in the colour of its kind when standard error is a terminal that has colours and NO_COLOR is not set; else
// as it is.
std::string highlighted(std::string_view text, Highlight kind);

}  // namespace plico::cli
