// Options of some bench programs: --figure FILE.svg of those that draw one.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>

namespace plico::bench {

// Takes an option with its value out of the arguments; empty when it is not given.
inline std::string option_of(std::string_view option, int& argc, char** argv) {
  for (int i = 1; i + 1 < argc; ++i)
    if (argv[i] == option) {
      const std::string value = argv[i + 1];
      std::move(argv + i + 2, argv + argc, argv + i);
      argc -= 2;
      return value;
    }
  return {};
}

inline std::string figure_of(int& argc, char** argv) { return option_of("--figure", argc, argv); }

}  // namespace plico::bench
