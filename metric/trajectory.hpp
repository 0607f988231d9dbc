#pragma once

#include <cstddef>
#include <span>

#include "core/trajectory.hpp"

namespace asterism {

/// Where local localisation says the robot was at a scan: in one frame, which drifts.
struct LocalPose {
  double stamp_s = 0;
  Pose2 map_from_robot = {};
};

/// Where the layout says the robot was at a scan: [x_{i,0}]_{m*} = χ ⊕ L_i.     [BMK10, §7.3.3]
struct Anchor {
  std::size_t scan = 0;  ///< index into the local poses
  Pose2 layout_from_robot = {};
};

/// H(x): the whole way driven, fitted to the anchors; one pose a local pose, in their order.
///                                                                    [BMK10, §7.3.3] [theory §12]
///
/// The result is exact at the anchors. Before the first and after the last the way is moved
/// rigidly with it. Each travel between two anchors is moved rigidly to the first, then bent and
/// stretched until it ends at the second: the heading's discrepancy is spread in proportion to the
/// way driven and turned so far, each turn moving all that comes later; the offset that is left is
/// spread in proportion to the way. So a travel driven backwards has the same poses, and no step is
/// lengthened by more than the offset.
///
/// @param driven   map_from_robot at each scan, the map drifting
/// @param anchors  layout_from_robot at some scans
/// @return  layout_from_robot at each scan
/// @pre  at least one anchor, scans ascending and among the local poses
/// @throws std::invalid_argument otherwise
Trajectory fit_trajectory(std::span<const LocalPose> driven, std::span<const Anchor> anchors);

}  // namespace asterism
