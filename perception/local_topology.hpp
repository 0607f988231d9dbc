#pragma once

#include <optional>

#include "perception/local_star.hpp"

namespace asterism {

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

LocalTopology local_topology(const Grid& grid, Point2 robot,
                             const LocalTopologyOptions& options = {});

}  // namespace asterism
