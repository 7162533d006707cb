// Angles in radians.
#pragma once

namespace continua {

inline constexpr double full_turn = 6.283185307179586;
inline constexpr double half_turn = full_turn / 2;
inline constexpr double quarter_turn = full_turn / 4;
inline constexpr double rad_per_deg = full_turn / 360;

}  // namespace continua
