// The option --figure FILE.svg of bench programs that draw one.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>

namespace plico::bench {

// Takes it out of the arguments; empty when it is not given.
inline std::string figure_of(int& argc, char** argv) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string_view(argv[i]) == "--figure") {
      const std::string path = argv[i + 1];
      std::move(argv + i + 2, argv + argc, argv + i);
      argc -= 2;
      return path;
    }
  return {};
}

}  // namespace plico::bench
