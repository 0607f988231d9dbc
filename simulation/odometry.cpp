#include "simulation/odometry.hpp"

namespace asterism {

void Odometry::begin_travel(double length_m) {
  distance_scale_ = 1 + options_.distance_share * normal(engine_);
  turn_scale_ = 1 + options_.turn_share * normal(engine_);
  drift_rad_per_m_ = options_.heading_rad_per_travel * normal(engine_) / length_m;
}

void Odometry::move(const Pose2& before_from_after) {
  const double step_scale = distance_scale_ + options_.step_share * normal(engine_);
  const double turn_step_scale = turn_scale_ + options_.step_share * normal(engine_);
  const Point2 step = step_scale * before_from_after.position();
  odom_from_robot_ =
      odom_from_robot_ * Pose2{step.x_m, step.y_m,
                               turn_step_scale * before_from_after.heading_rad +
                                   drift_rad_per_m_ * norm(before_from_after.position())};
}

}  // namespace asterism
