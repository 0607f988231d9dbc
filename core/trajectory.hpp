#pragma once

#include <vector>

#include "core/pose2.hpp"

namespace asterism {

/// Where the robot was at one time.
struct TimedPose {
  double stamp_s = 0;
  Pose2 layout_from_robot = {};

  friend bool operator==(const TimedPose&, const TimedPose&) = default;
};

/// Robot poses over time in the layout's frame, in the order of the log: stamps may run backwards.
using Trajectory = std::vector<TimedPose>;

}  // namespace asterism
