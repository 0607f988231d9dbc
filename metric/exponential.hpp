#pragma once

#include "core/pose_covariance.hpp"

namespace asterism {

/// The pose reached by moving evenly for one unit of time: Exp of the group of rigid motions.
Pose2 exponential(const SmallMotion& motion);

/// The motion that leads there, its turn in (-π, π]: the inverse of the above.
SmallMotion logarithm(const Pose2& pose);

/// How the logarithm of a pose changes with a small motion δ in the frame reached:
/// Log(Exp(motion) · Exp(δ)) = motion + J δ + O(δ²). J row by row.
/// @pre  |turn| < 2π
std::array<double, 9> logarithm_jacobian(const SmallMotion& motion);

/// Ad(a_from_b), row by row: the matrix by which seen_from() works.
std::array<double, 9> adjoint(const Pose2& a_from_b);

}  // namespace asterism
