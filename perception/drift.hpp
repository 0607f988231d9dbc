#pragma once

#include "core/pose_covariance.hpp"

namespace asterism {

/// How far a pose that was followed step by step may have drifted from the first step on. All is
/// told in the frame the poses are in, so what happened between two steps is the difference.
struct Drift {
  PoseCovariance by_chance = {};  ///< errors of single steps, which cancel out
  SmallMotion by_wheels = {};     ///< the way that only the wheels tell of: their scale adds up
  SmallMotion by_bends = {};      ///< turned by one radian a metre driven: what bends a map adds up
};

/// Standard deviations, but for one. Set by simulated drives, whose true poses are known, and by
/// how well the loops of a real one close.
struct DriftOptions {
  double wheel_scale = 0.05;        ///< of the wheels on a travel, as simulated odometry draws it
  double bend_rad_per_m = 0.0003;   ///< by which a map grows bent: walls are not as they are drawn
  double position_noise_m = 0.006;  ///< of any one pose in the map round it
  double heading_noise_rad = 0.0006;
  double lean_rad = 0.06;   ///< of a wall as drawn from noisy returns, to and fro
  double scans_alike = 25;  ///< not a deviation: how many scans see the same walls
};

/// A pose, and what has drifted up to it.
struct DriftingPose {
  Pose2 map_from_robot = {};
  Drift drift = {};
};

/// Covariance of the pose reached, `after`, in the frame of the pose left, `before`: of a small
/// motion in the frame reached, m, m, rad.                                            [theory §11]
PoseCovariance covariance_between(const DriftingPose& before, const DriftingPose& after,
                                  const DriftOptions& options = {});

/// What of a step only the wheels tell: all of it along a bare corridor, little where walls across
/// the way hold the robot. These hold it for many scans, so that what each says adds up; walls
/// along the way, leaning, only seem to.
///
/// @param fit      covariance of the pose that the step was found to end at
/// @param motion   before_from_after by the wheels, m, m, rad
/// @param sigma_m  deviation of its position that the fit was told
/// @return  in the frame of the pose the step ends at
SmallMotion left_to_wheels(const PoseCovariance& fit, const Pose2& motion, double sigma_m,
                           const DriftOptions& options = {});

/// What one step adds to a drift, in the frame of the pose it ends at.
struct StepDrift {
  PoseCovariance by_chance = {};
  SmallMotion by_wheels = {};
  double driven_m = 0;
};

/// The drift after one more step, which ends at this pose.
///
/// @param before          since the first step, in the map's frame, as is what is returned
/// @param map_from_robot  where the step ends
/// @param step            in the frame of the robot there
Drift drifted(const Drift& before, const Pose2& map_from_robot, const StepDrift& step);

}  // namespace asterism
