#pragma once

#include <cstddef>
#include <vector>

#include "core/pose2.hpp"

namespace asterism {

/// How the beams of a range finder lie. Beam i points first_beam_rad + i · beam_step_rad from the
/// laser's own +x, counter-clockwise.
struct LaserLayout {
  double first_beam_rad = 0;
  double beam_step_rad = 0;
  double max_range_m = 0;  ///< a range of this or more is no return: free so far, no obstacle seen
  Pose2 robot_from_laser = {};

  /// Where a beam points: from the laser's +x, counter-clockwise.
  double beam_rad(std::size_t beam) const {
    return first_beam_rad + static_cast<double>(beam) * beam_step_rad;
  }
};

/// One turn of a range finder, and where the wheels say the robot stood.
///
/// Readers guarantee: at least one range, all finite and not negative; finite pose and stamp.
/// Stamps may run backwards; the order of the log rules.
struct Scan {
  long long number = 0;  ///< position in the log, from 0
  double stamp_s = 0;
  Pose2 odom_from_robot = {};
  std::vector<double> ranges_m = {};
  LaserLayout laser = {};
};

}  // namespace asterism
