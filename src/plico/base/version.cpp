#include "plico/base/version.h"

namespace plico {

std::string version() { return PLICO_VERSION; }

}  // namespace plico
