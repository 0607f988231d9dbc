#pragma once

#include "core/scan.hpp"

namespace asterism {

/// A rectangular room, its middle at the origin, its walls along the axes.
struct Room {
  double width_m = 8;
  double height_m = 6;

  /// What a laser of 360 beams, one a degree, sees from a pose in the room, without noise.
  Scan scan(const Pose2& room_from_robot, long long number) const;
  /// How far inside the nearest wall a point lies; negative: outside.
  double inside_by(Point2 point) const;
};

}  // namespace asterism
