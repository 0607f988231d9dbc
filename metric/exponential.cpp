#include "metric/exponential.hpp"

namespace asterism {

Pose2 exponential(const SmallMotion& motion) {
  const auto [ahead_m, left_m, turn_rad] = motion;
  const bool small = std::abs(turn_rad) < small_turn_rad;
  const double along = small ? 1 - turn_rad * turn_rad / 6 : std::sin(turn_rad) / turn_rad;
  const double across = small ? turn_rad / 2 : (1 - std::cos(turn_rad)) / turn_rad;
  return {along * ahead_m - across * left_m, across * ahead_m + along * left_m, wrapped(turn_rad)};
}

SmallMotion logarithm(const Pose2& pose) {
  const double turn_rad = wrapped(pose.heading_rad);
  const double c = half_turn_cotangent(turn_rad);
  return {c * pose.x_m + turn_rad / 2 * pose.y_m, c * pose.y_m - turn_rad / 2 * pose.x_m, turn_rad};
}

}  // namespace asterism
