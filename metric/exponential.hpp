#pragma once

#include <cmath>

#include "core/pose_covariance.hpp"

namespace asterism {

/// Below this turn the series of what follows are exact to rounding, and the quotients are not.
inline constexpr double small_turn_rad = 1e-4;

/// (turn / 2) / tan(turn / 2); 1 where nothing turns.
inline double half_turn_cotangent(double turn_rad) {
  if (std::abs(turn_rad) < small_turn_rad) return 1 - turn_rad * turn_rad / 12;
  return turn_rad / 2 / std::tan(turn_rad / 2);
}

/// The pose reached by moving evenly for one unit of time: Exp of the group of rigid motions.
///
/// @param motion  a unit of time; m, m, rad, its turn of any size
/// @return  in the frame of the start, heading in (-π, π]
Pose2 exponential(const SmallMotion& motion);

/// The motion that leads to a pose in one unit of time: Log, the inverse of exponential().
///
/// @return  m, m, rad, its turn in (-π, π]
SmallMotion logarithm(const Pose2& pose);

}  // namespace asterism
