#pragma once

#include <array>

#include "core/pose2.hpp"

namespace asterism {

/// A small motion of the plane: ahead, to the left, counter-clockwise; m, m, rad.
using SmallMotion = std::array<double, 3>;

/// Covariance of an estimated pose a_from_b: that of the small motion, in b's frame, that leads
/// from the estimate to the truth, Log(estimate⁻¹ · truth). Row by row; m, m, rad.
///                                                                                    [theory §12]
using PoseCovariance = std::array<double, 9>;

/// Covariance of a pose as well known along as across, the heading by itself: variances in m²,
/// rad².
constexpr PoseCovariance diagonal(double position_m2, double heading_rad2) {
  return {position_m2, 0, 0, 0, position_m2, 0, 0, 0, heading_rad2};
}

/// Whether nine numbers, row by row, are finite, symmetric and positive semi-definite, up to
/// rounding (1e-9). Judged on the correlations, so that metres and radians of any size count alike.
bool is_covariance(const std::array<double, 9>& numbers);

/// A small motion told in frame b, told in frame a: Ad(a_from_b) · motion.
SmallMotion seen_from(const Pose2& a_from_b, const SmallMotion& in_b);

/// Covariance of a small motion told in frame b, told in frame a: Ad(a_from_b) · C · Ad(a_from_b)ᵀ.
/// With it, the covariance of the pose a_from_b · b_from_c, both errors independent, is
/// seen_from(c_from_b, C_b) + C_c.
PoseCovariance seen_from(const Pose2& a_from_b, const PoseCovariance& in_b);

}  // namespace asterism
