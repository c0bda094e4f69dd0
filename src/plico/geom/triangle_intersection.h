// Do triangles in space meet? Decided exactly; touching is meeting.
#pragma once
#include <array>

#include "plico/base/vec.h"

namespace plico {

using Triangle3 = std::array<Vec3, 3>;  // three points that are not on one line

// Does the closed segment p q meet the closed triangle?
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Triangle3& triangle);

// Do two closed triangles meet?
bool triangles_meet(const Triangle3& s, const Triangle3& t);

// Do triangles with s[0] = t[0] meet anywhere else?
bool triangles_meet_beyond_corner(const Triangle3& s, const Triangle3& t);

// Do triangles with s[0] = t[0] and s[1] = t[1] meet anywhere off that edge, that is, lie on each other?
bool triangles_meet_beyond_edge(const Triangle3& s, const Triangle3& t);

}  // namespace plico
