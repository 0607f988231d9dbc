#include "perception/drift.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/plane_covariance.hpp"
#include "core/squared.hpp"

namespace asterism {
namespace {

SmallMotion difference(const SmallMotion& a, const SmallMotion& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

PoseCovariance covariance_between(const DriftingPose& before, const DriftingPose& after,
                                  const DriftOptions& options) {
  const Pose2 after_from_map = inverse(after.map_from_robot);
  PoseCovariance by_chance = {};
  for (std::size_t i = 0; i < by_chance.size(); ++i) {
    by_chance[i] = after.drift.by_chance[i] - before.drift.by_chance[i];
  }
  const PoseCovariance at_end =
      diagonal(squared(options.position_noise_m), squared(options.heading_noise_rad));

  PoseCovariance sum = seen_from(after_from_map, by_chance);
  const PoseCovariance at_start = seen_from(after_from_map * before.map_from_robot, at_end);
  const SmallMotion scale =
      seen_from(after_from_map, difference(after.drift.by_wheels, before.drift.by_wheels));
  const SmallMotion bend =
      seen_from(after_from_map, difference(after.drift.by_bends, before.drift.by_bends));
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const std::size_t at = 3 * row + column;
      sum[at] += at_start[at] + at_end[at] +
                 options.wheel_scale * options.wheel_scale * scale[row] * scale[column] +
                 options.bend_rad_per_m * options.bend_rad_per_m * bend[row] * bend[column];
    }
  }
  return sum;
}

SmallMotion left_to_wheels(const PoseCovariance& fit, const Pose2& motion, double sigma_m,
                           const DriftOptions& options) {
  const double driven_m = norm(motion.position());
  if (driven_m == 0) return {};
  // Of each step the fit leaves its covariance, in units of the wheels', to them.
  const double variance = sigma_m * sigma_m;
  SmallMotion left = {};
  for (std::size_t i = 0; i < left.size(); ++i)
    left[i] = (fit[3 * i] * motion.x_m + fit[3 * i + 1] * motion.y_m) / variance;
  const double of_step = std::hypot(left[0], left[1]) / driven_m;
  if (of_step == 0) return {};
  // The walls' information along the way and across it, in units of the wheels'.
  const PlaneCovariance position{fit[0], fit[1], fit[4]};
  const double least = (position.middle() - position.half()) / variance;
  const double along = std::max(0.0, 1 / of_step - 1 - std::pow(options.lean_rad, 2) / least);
  const double of_way = 1 / (1 + options.scans_alike * along);
  for (double& part : left) part *= of_way / of_step;
  return left;
}

Drift drifted(const Drift& before, const Pose2& map_from_robot, const StepDrift& step) {
  Drift after = before;
  const PoseCovariance chance = seen_from(map_from_robot, step.by_chance);
  const SmallMotion wheels = seen_from(map_from_robot, step.by_wheels);
  const SmallMotion bend = seen_from(map_from_robot, SmallMotion{0, 0, step.driven_m});
  for (std::size_t i = 0; i < chance.size(); ++i) after.by_chance[i] += chance[i];
  for (std::size_t i = 0; i < wheels.size(); ++i) {
    after.by_wheels[i] += wheels[i];
    after.by_bends[i] += bend[i];
  }
  return after;
}

}  // namespace asterism
