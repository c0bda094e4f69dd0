// JSON from files of strangers: the library's errors become ours, with their place.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace plico {

// At most 100 levels deep. Throws InvalidInput "KIND/json", "KIND/depth" or "KIND/number" with name, line and column.
nlohmann::json parse_json(std::string_view bytes, const std::string& name, const std::string& kind);

}  // namespace plico
