#pragma once

#include "core/driven_way.hpp"
#include "core/grid.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/trajectory.hpp"

namespace asterism {

/// The lines along which the robot drove the segments of a map.
///
/// Each runs from where the robot was at the first visit to one place to where it was at the first
/// visit to the other, along one travel, without its loops. Where the trajectory leads over a wall
/// of the global map or over unknown ground, the line goes round if there is a free way within some
/// 2 m. It is simplified to 0.05 m, but not into a wall. Of several travels the line that crosses
/// less wall is taken, then the one over less unknown ground, then the smoother: the one that turns
/// less.
///
/// @param map         of the trace or of its first visits
/// @param trajectory  layout_from_robot at each scan
/// @param global_map  in the layout's frame
/// @pre  each explained visit tells its scans, which are among those of the trajectory
DrivenWays driven_ways(const Trace& trace, const TopologicalMap& map, const Trajectory& trajectory,
                       const Grid& global_map);

}  // namespace asterism
