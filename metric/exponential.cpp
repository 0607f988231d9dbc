#include "metric/exponential.hpp"

#include <cmath>

namespace asterism {
namespace {

// Below this turn the series is exact to rounding, and the quotients are not.
constexpr double kSmallTurn_rad = 1e-4;

// (turn / 2) / tan(turn / 2)
double half_turn_cotangent(double turn_rad) {
  if (std::abs(turn_rad) < kSmallTurn_rad) return 1 - turn_rad * turn_rad / 12;
  return turn_rad / 2 / std::tan(turn_rad / 2);
}

}  // namespace

Pose2 exponential(const SmallMotion& motion) {
  const auto [ahead_m, left_m, turn_rad] = motion;
  const bool small = std::abs(turn_rad) < kSmallTurn_rad;
  const double along = small ? 1 - turn_rad * turn_rad / 6 : std::sin(turn_rad) / turn_rad;
  const double across = small ? turn_rad / 2 : (1 - std::cos(turn_rad)) / turn_rad;
  return {along * ahead_m - across * left_m, across * ahead_m + along * left_m, wrapped(turn_rad)};
}

SmallMotion logarithm(const Pose2& pose) {
  const double turn_rad = wrapped(pose.heading_rad);
  const double c = half_turn_cotangent(turn_rad);
  return {c * pose.x_m + turn_rad / 2 * pose.y_m, c * pose.y_m - turn_rad / 2 * pose.x_m, turn_rad};
}

std::array<double, 9> logarithm_jacobian(const SmallMotion& motion) {
  const auto [ahead_m, left_m, turn_rad] = motion;
  const double c = half_turn_cotangent(turn_rad);
  // (1 - c) / turn, which goes to turn / 12.
  const double k = std::abs(turn_rad) < kSmallTurn_rad ? turn_rad / 12 : (1 - c) / turn_rad;
  return {c,
          -turn_rad / 2,
          left_m / 2 + k * ahead_m,  //
          turn_rad / 2,
          c,
          -ahead_m / 2 + k * left_m,  //
          0,
          0,
          1};
}

std::array<double, 9> adjoint(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.heading_rad);
  const double s = std::sin(a_from_b.heading_rad);
  return {c, -s, a_from_b.y_m, s, c, -a_from_b.x_m, 0, 0, 1};
}

}  // namespace asterism
