#pragma once

#include <cmath>
#include <numbers>

namespace asterism {

/// An angle brought into (-π, π], rad.
inline double wrapped(double angle_rad) {
  const double turned = std::remainder(angle_rad, 2 * std::numbers::pi);
  return turned == -std::numbers::pi ? std::numbers::pi : turned;
}

/// An angle told in degrees, in radians.
constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace asterism
