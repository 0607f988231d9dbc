#pragma once

#include <vector>

#include "core/pose2.hpp"

namespace asterism {

/// The line along which the robot drove a segment, and can again; in the layout's frame.
struct DrivenWay {
  std::vector<Point2> line = {};  ///< from the segment's first place to its second: two or more
  double length_m = 0;
  double width_m = 0;  ///< the least between the walls to its left and right
};

/// Those of a map.
struct DrivenWays {
  std::vector<Pose2> layout_from_place = {};  ///< [place]: of the robot, where ways meet
  std::vector<DrivenWay> of_segment = {};     ///< [segment]
};

}  // namespace asterism
