#include "core/pose_covariance.hpp"

#include <cmath>
#include <cstddef>

namespace asterism {

bool is_covariance(const std::array<double, 9>& c) {
  constexpr double rounding = 1e-9;
  const auto deviation = [&](std::size_t i) { return std::sqrt(c[4 * i]); };
  for (const double number : c)
    if (!std::isfinite(number)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!(c[4 * i] >= 0)) return false;
  // Each of the principal minors must not be negative.
  std::array<double, 3> correlation{};  // of (0, 1), (0, 2), (1, 2)
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const double above = c[3 * i + j];
      const double below = c[3 * j + i];
      const double scale = deviation(i) * deviation(j);
      if (std::abs(above - below) > rounding * scale) return false;
      if (std::abs(above) > (1 + rounding) * scale) return false;
      correlation[i + j - 1] = scale > 0 ? above / scale : 0;
    }
  }
  const auto [r, s, t] = correlation;
  return 1 + 2 * r * s * t - r * r - s * s - t * t >= -rounding;
}

SmallMotion seen_from(const Pose2& a_from_b, const SmallMotion& in_b) {
  const double c = std::cos(a_from_b.heading_rad);
  const double s = std::sin(a_from_b.heading_rad);
  const auto [ahead_m, left_m, turn_rad] = in_b;
  return {c * ahead_m - s * left_m + a_from_b.y_m * turn_rad,
          s * ahead_m + c * left_m - a_from_b.x_m * turn_rad, turn_rad};
}

PoseCovariance seen_from(const Pose2& a_from_b, const PoseCovariance& in_b) {
  // Columns first, then rows; the upper half is copied to the lower, so that rounding keeps it
  // even.
  std::array<SmallMotion, 3> half{};
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] = seen_from(a_from_b, SmallMotion{in_b[i], in_b[3 + i], in_b[6 + i]});
  }
  PoseCovariance result{};
  for (std::size_t row = 0; row < 3; ++row) {
    const SmallMotion whole =
        seen_from(a_from_b, SmallMotion{half[0][row], half[1][row], half[2][row]});
    for (std::size_t column = row; column < 3; ++column) {
      result[3 * row + column] = whole[column];
      result[3 * column + row] = whole[column];
    }
  }
  return result;
}

}  // namespace asterism
