#pragma once

#include "core/pose_covariance.hpp"
#include "metric/place_walls.hpp"

namespace asterism {

/// Where one map's frame is in another's, as known before or by the walls of both.
struct WallFit {
  Pose2 first_from_second = {};
  /// Inverse of the covariance by the walls alone; 0 along what the walls leave open.
  PoseCovariance information = {};
  double matched_walls = 0;  ///< share of the walls that either map knows of and the other has too
};

/// How well a bit of wall is known, and where to look for it.
struct WallFitOptions {
  /// Deviation of a bit of wall seen twice, its neighbours sharing much of it.
  double wall_m = 0.15;
  double reach_m = 1.0;  ///< to begin with, how far apart the same wall may be in both
};

/// Fits the walls of one map to those of another, from a start that is known so well already:
/// distances across the walls count, in the same direction only, the farther the less.
///
///   pose* = argmin ‖Log(start⁻¹ pose)‖² + Σ ρ(nᵀ(pose · p - q))²                 [BMK10, §7.3.1]
///
/// @param start        first_from_second, m, m, rad
/// @param information  of the start, in the second frame, row by row; positive definite
WallFit fit_walls(const PlaceWalls& first, const PlaceWalls& second, const Pose2& start,
                  const PoseCovariance& information, const WallFitOptions& options = {});

}  // namespace asterism
