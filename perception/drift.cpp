#include "perception/drift.hpp"

#include <cstddef>

namespace asterism {

PoseCovariance covariance_between(const DriftingPose& before, const DriftingPose& after,
                                  const DriftOptions& options) {
  const Pose2 after_from_map = inverse(after.map_from_robot);
  PoseCovariance by_chance = {};
  for (std::size_t i = 0; i < by_chance.size(); ++i) {
    by_chance[i] = after.drift.by_chance[i] - before.drift.by_chance[i];
  }
  SmallMotion by_wheels = {};
  for (std::size_t i = 0; i < by_wheels.size(); ++i) {
    by_wheels[i] = after.drift.by_wheels[i] - before.drift.by_wheels[i];
  }
  const double position = options.position_noise_m * options.position_noise_m;
  const double heading = options.heading_noise_rad * options.heading_noise_rad;
  const PoseCovariance at_end{position, 0, 0, 0, position, 0, 0, 0, heading};

  PoseCovariance sum = seen_from(after_from_map, by_chance);
  const PoseCovariance at_start = seen_from(after_from_map * before.map_from_robot, at_end);
  const SmallMotion scale = seen_from(after_from_map, by_wheels);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const std::size_t at = 3 * row + column;
      sum[at] += at_start[at] + at_end[at] +
                 options.wheel_scale * options.wheel_scale * scale[row] * scale[column];
    }
  }
  return sum;
}

Drift drifted(const Drift& before, const Pose2& map_from_robot, const PoseCovariance& by_chance,
              const SmallMotion& by_wheels) {
  Drift after = before;
  const PoseCovariance chance = seen_from(map_from_robot, by_chance);
  const SmallMotion wheels = seen_from(map_from_robot, by_wheels);
  for (std::size_t i = 0; i < chance.size(); ++i) after.by_chance[i] += chance[i];
  for (std::size_t i = 0; i < wheels.size(); ++i) after.by_wheels[i] += wheels[i];
  return after;
}

}  // namespace asterism
