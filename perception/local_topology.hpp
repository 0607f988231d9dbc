#pragma once

#include <optional>
#include <span>

#include "perception/local_star.hpp"

namespace asterism {

/// Those of each step.
struct LocalTopologyOptions {
  FreeSpaceOptions free_space = {};
  SkeletonOptions skeleton = {};
  LocalStarOptions star = {};
};

/// What a grid says of the place round the robot, with every step on the way. [BMK10, §5]
struct LocalTopology {
  FreeSpace space = {};
  Skeleton skeleton = {};
  std::optional<Neighbourhood> neighbourhood = {};  ///< nothing: no way out
  std::optional<LocalStar> star = {};               ///< nothing: no gateway
};

/// Free space, skeleton, gateways and star of a grid, in this order.                  [theory §11]
///
/// @param robot   in the grid's frame, m
/// @param driven  where the robot drove, in the grid's frame, m
LocalTopology local_topology(const Grid& grid, Point2 robot,
                             const LocalTopologyOptions& options = {},
                             std::span<const Point2> driven = {});

}  // namespace asterism
