// The studio reads no pictures: shapes keep their colours, textures are told and left out.
#include "plico/io/text/read_picture.h"

#include <fmt/core.h>

#include "plico/base/error.h"

namespace plico {

Picture read_picture(std::string_view, const std::string& name) {
  throw InvalidInput("picture/format", fmt::format("the picture {} is left out: the studio reads no pictures", name),
                     name, "use the plico program");
}

}  // namespace plico
