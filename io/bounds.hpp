#pragma once

#include <limits>
#include <string>

#include "core/pose2.hpp"

namespace asterism {

/// What a number of a file may be: between two whole numbers, above 0, or any that is finite.
struct Bounds {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();

  bool contain(double value) const { return value >= low && value <= high; }
};
inline constexpr Bounds above_0{std::numeric_limits<double>::min()};
inline constexpr Bounds position_bounds_m{-1e7, 1e7};   ///< so that cells stay countable
inline constexpr Bounds heading_bounds_rad{-1e6, 1e6};  ///< in any number of turns

/// Throws std::invalid_argument "what: found ...; expected ..." unless the pose is in the bounds of
/// those that are read.
void require_writable(const Pose2& pose, const std::string& what);

}  // namespace asterism
