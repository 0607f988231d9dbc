#pragma once

#include <span>

#include "core/layout.hpp"

namespace asterism {

/// Where a layout begins, and what of it is asked for.
struct LayoutOptions {
  std::span<const Pose2> start = {};  ///< poses to begin with, of the first places at least
  bool with_covariances = true;
};

/// Layout of a map: the place poses that agree best with its displacements.
///
///   χ* = argmin_χ Σ_k ‖ Log(λ_k⁻¹ · χ_i⁻¹ · χ_j) ‖²_Σk,   χ_0 = identity     [BMK10, §7.3.2]
///
/// by Levenberg-Marquardt. A place that `start` does not tell of begins where the least uncertain
/// chain of displacements puts it. A place's covariance is that of the small motion in its own
/// frame, by the curvature at the optimum.
///
/// @param places         at least one
/// @param displacements  λ_k, Σ_k: place j in the frame of place i, m, m, rad; Σ_k in the frame of
///                       the place reached
/// @return  n poses, layout_from_place, the first the identity; headings in (-π, π]
/// @throws std::invalid_argument if they do not join all places, one names no place, joins a place
///         to itself, is not finite, or its covariance is not positive definite; or if they differ
///         so much in size that numbers overflow
Layout lay_out(std::size_t places, std::span<const PlaceDisplacement> displacements,
               const LayoutOptions& options = {});

}  // namespace asterism
