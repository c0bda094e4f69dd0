// Quantities as people write them: "150mm", "6in", "30deg", "2m". A number without a unit is in the unit named first.
// All throw InvalidOption with examples when the text is not such a quantity or is not finite.
#pragma once
#include <string_view>

namespace plico {

double parse_length_mm(std::string_view text);  // mm, cm, m, in, ft; result in millimetres
double parse_angle(std::string_view text);      // deg, rad; result in radians
double parse_duration(std::string_view text);   // s, ms, m (minutes), h; result in seconds, not negative

// Millimetres in one mm, cm, m, in or ft.
double millimetres_per(std::string_view unit);

}  // namespace plico
