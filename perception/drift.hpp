#pragma once

#include "core/pose_covariance.hpp"

namespace asterism {

/// How far a pose that was followed step by step may have drifted from the first step on. All is
/// told in the frame the poses are in, so what happened between two steps is the difference.
struct Drift {
  PoseCovariance by_chance = {};  ///< errors of single steps, which cancel out
  SmallMotion by_wheels = {};     ///< the way that only the wheels tell of: their scale adds up
};

/// Standard deviations.
struct DriftOptions {
  double wheel_scale = 0.03;        ///< deviation of the wheels' scale
  double position_noise_m = 0.006;  ///< of any one pose in the map round it
  double heading_noise_rad = 0.0006;
};

/// A pose, and what has drifted up to it.
struct DriftingPose {
  Pose2 map_from_robot = {};
  Drift drift = {};
};

/// Covariance of the pose reached, `after`, in the frame of the pose left, `before`.
PoseCovariance covariance_between(const DriftingPose& before, const DriftingPose& after,
                                  const DriftOptions& options = {});

/// The drift after one more step that ends at this pose, in whose frame the step's errors are.
Drift drifted(const Drift& before, const Pose2& map_from_robot, const PoseCovariance& by_chance,
              const SmallMotion& by_wheels);

}  // namespace asterism
