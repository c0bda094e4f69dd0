// How commands tell about the proof of a motion.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "plico/verify/net.h"
#include "plico/verify/path.h"

namespace plico::jobs {

nlohmann::json defects_json(const std::vector<Defect>& defects);  // [{"code", "message"}]
nlohmann::json motion_json(const PathProof& proof);
std::string motion_line(const PathProof& proof);  // one line for people
std::string loops_line(const LoopReport& loops);  // how well a sheet with loops stays closed

}  // namespace plico::jobs
