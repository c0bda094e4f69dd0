#include "plico/base/error.h"

namespace plico {

void assertion_failed(const char* condition, const char* file, int line) {
  throw std::logic_error(fmt::format("internal error: {} does not hold ({}:{})", condition, file, line));
}

}  // namespace plico
