#pragma once

#include <optional>
#include <vector>

#include "perception/skeleton.hpp"

namespace asterism {

/// The line across free space where a place's neighbourhood ends: centred at `middle`, `width_m`
/// long, normal to its outward heading.
struct Gateway {
  Point2 middle = {};
  double outward_rad = 0;
  double width_m = 0;  ///< 2 r_m
};

/// The neighbourhood the robot is in: discs of free space round its junctions, and the gateways
/// where it ends.                                                                 [BMK10, §5.1.1]
struct Neighbourhood {
  std::vector<std::size_t> core = {};  ///< F: skeleton points, of radius r_f each; without a
                                       ///< junction the one nearest the robot
  std::vector<Gateway> gateways = {};  ///< in the grid's frame
  double unknown_border = 0;           ///< share of the core's border that is unknown space
};

/// The neighbourhood that holds the robot: F, then from each way out of it the first constriction.
///                                                                              [BMK10, §5.1.1]
///
/// @param robot  in the grid's frame, m
/// @return  nothing if there is no exit: the skeleton has no critical branch
std::optional<Neighbourhood> neighbourhood(const FreeSpace& space, const Skeleton& skeleton,
                                           Point2 robot);
/// The core F alone of the neighbourhood that holds the robot, in ascending order; empty: no exit.
/// Where cores are equal, so are the neighbourhoods.
std::vector<std::size_t> core(const FreeSpace& space, const Skeleton& skeleton, Point2 robot);

}  // namespace asterism
