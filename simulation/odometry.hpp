#pragma once

#include "core/pose2.hpp"
#include "core/random.hpp"

namespace asterism {

/// How wrong the wheels are: all standard deviations.
struct OdometryOptions {
  double distance_share = 0.05;                      ///< of a travel's length
  double heading_rad_per_travel = 0.08726646259972;  ///< 5°, gathered while driving
  double turn_share = 0.005;  ///< of what is turned in place, more of it more
  double step_share = 0.02;   ///< of every single step and turn
};

/// Where the wheels say the robot is. What a travel adds to the error is drawn as it begins and
/// grows evenly with the way: wheels that are worn, a floor that is soft. For one thread at a time.
class Odometry {
 public:
  /// @param start  odom_from_robot to begin with
  Odometry(const OdometryOptions& options, const Pose2& start, RandomEngine engine)
      : options_(options), odom_from_robot_(start), engine_(engine) {}

  /// A travel of this length begins.
  void begin_travel(double length_m);
  /// The robot has truly moved.
  /// @param before_from_after  the robot's new frame in its old one
  void move(const Pose2& before_from_after);

  /// Where the wheels say the robot is now.
  const Pose2& odom_from_robot() const noexcept { return odom_from_robot_; }

 private:
  OdometryOptions options_;
  Pose2 odom_from_robot_;
  RandomEngine engine_;
  double distance_scale_ = 1;
  double turn_scale_ = 1;
  double drift_rad_per_m_ = 0;
};

}  // namespace asterism
