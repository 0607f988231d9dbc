#pragma once

#include <array>

#include "core/pose2.hpp"

namespace asterism {

/// A small motion of the plane: ahead, to the left, counter-clockwise; m, m, rad.
using SmallMotion = std::array<double, 3>;

/// Covariance of an estimated pose a_from_b: that of the small motion, in b's frame, that leads
/// from the estimate to the truth, Log(estimate⁻¹ · truth). Row by row; m, m, rad.       [DESIGN
/// §12]
using PoseCovariance = std::array<double, 9>;

/// The same motion in another frame: Ad(a_from_b) · motion.
SmallMotion seen_from(const Pose2& a_from_b, const SmallMotion& in_b);

/// ... and its covariance: Ad(a_from_b) · C · Ad(a_from_b)ᵀ. With it, the covariance of the pose
/// a_from_b · b_from_c, both errors independent, is seen_from(c_from_b, C_b) + C_c.
PoseCovariance seen_from(const Pose2& a_from_b, const PoseCovariance& in_b);

}  // namespace asterism
