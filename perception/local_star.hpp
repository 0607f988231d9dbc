#pragma once

#include <vector>

#include "core/star.hpp"
#include "perception/gateways.hpp"

namespace asterism {

/// When two gateways are one path.
struct LocalStarOptions {
  double slack_rad = 0.30;    ///< a ray this far off another gateway still crosses it
  double max_bend_rad = 0.6;  ///< a path's two gateways face away from each other within this
};

/// A place's arms as its gateways ground them.                                    [BMK10, §5.1.2]
struct LocalStar {
  Star star;
  std::vector<std::size_t> arm_of_gateway = {};  ///< arm of `star` that leads out of each gateway
};

/// The star that gateways ground: arms clockwise, from the first ray clockwise of +x as seen from
/// the gateways' middle; labels a, b, ... in order of first arms. Two gateways are one path iff the
/// inward ray from each midpoint crosses the other. [BMK10, §5.1.2]
///
/// @param gateways  in one frame, m, m, rad
/// @pre  at least one gateway
LocalStar local_star(const std::vector<Gateway>& gateways, const LocalStarOptions& options = {});

/// Whether there are exactly two gateways, that form one path: the robot is on a path, not at a
/// place. [BMK10, §5.2]
bool is_on_path(const LocalStar& local);

}  // namespace asterism
