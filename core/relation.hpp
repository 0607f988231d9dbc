#pragma once

#include "core/pose2.hpp"

namespace asterism {

/// A surveyed motion: the pose of the robot at the second time in its frame at the first.
struct Relation {
  double first_stamp_s = 0;
  double second_stamp_s = 0;
  Pose2 first_from_second = {};

  friend bool operator==(const Relation&, const Relation&) = default;
};

}  // namespace asterism
