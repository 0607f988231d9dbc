#pragma once

#include <cstddef>
#include <span>

#include "core/grid.hpp"
#include "core/scan.hpp"
#include "core/trajectory.hpp"

namespace asterism {

/// How scans are drawn, and how large a map may be.
struct GlobalMapOptions {
  double resolution_m = 0.05;          ///< doubled until the map has no more than max_cells cells
  double usable_range_m = 20;          ///< farther returns say free up to here, and no more
  double clear_range_m = 1;            ///< no return says free up to here: glass and black walls
  double margin_m = 0.5;               ///< of the grid, round all that was seen
  std::size_t max_cells = 16'000'000;  ///< of the grid, as many as a picture may have pixels

  // A wall seen flat is missed more often than hit: one hit in four makes it.
  double hit = 1.2;    ///< log-odds that a return adds to its cell
  double miss = -0.4;  ///< log-odds that a return adds to each cell it came through
  double bound = 5;    ///< log-odds of the whole are cut to ±bound

  // Scans are drawn where there is something new to see and nothing is blurred.
  double redraw_m = 0.1;
  double redraw_rad = 0.1;
  double blurred_rad = 0.1;  ///< a scan since or until which the robot turned more is not drawn
  double blurred_rad_per_s = 0.5;  ///< and that only if it turned as fast as this, too
};

/// m*: the global map, the scans drawn from the poses of the trajectory.           [BMK10, §7.3.4]
/// [theory §12]
///
/// The grid is as large as what was seen; its axes are the layout's, its corner lies on a whole
/// multiple of its resolution, which is coarser than asked for where there were too many cells. A
/// cell counts once a scan, a return before a miss; hits and misses are counted, so the order of
/// the scans drawn does not matter. Takes 12 bytes a cell.
///
/// @param scans       ranges in m, in the laser's frame
/// @param trajectory  layout_from_robot at each scan
/// @return  log-odds in the layout's frame
/// @pre  one finite pose a scan, in the same order; at least one scan; sizes and log-odds positive
///       but `miss`, which is negative; max_cells at least 16
/// @throws std::invalid_argument if not
Grid global_map(std::span<const Scan> scans, const Trajectory& trajectory,
                const GlobalMapOptions& options = {});

}  // namespace asterism
