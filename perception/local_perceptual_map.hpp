#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "core/scan.hpp"

namespace asterism {

/// How large a local perceptual map is, and what a scan does to it.
struct LpmOptions {
  int cells = 300;  ///< columns, and rows
  double resolution_m = 0.10;
  double usable_range_m = 20;  ///< farther returns say free up to here, and no more

  double hit = 0.7;       ///< log-odds that a return adds to its cell
  double miss = -0.5;     ///< log-odds that a return adds to each cell it came through
  double bound = 3.5;     ///< log-odds never leave ±bound, so that what has moved is forgotten
  int most_returns = 20;  ///< later ones do not move a wall any more: walls do not drift
};

/// What a cell knows of the returns in it.
struct WallPoint {
  Point2 mean = {};  ///< of the returns, in the map's frame
  int returns = 0;
};

/// The bounded occupancy grid round the robot, m̃ in [BMK10, §4.1].
///
/// Its frame stays where the robot started and drifts with the localisation; the grid is the window
/// of that frame which `scroll_to` keeps round the robot, moved by whole cells. What scrolls off is
/// forgotten, what scrolls on is unknown. Time and space of an update do not depend on the past.
/// For one thread at a time; what is const may run side by side.
class LocalPerceptualMap {
 public:
  /// A map of which nothing is known, its central cell at the origin of its frame.
  explicit LocalPerceptualMap(const LpmOptions& options);

  /// Brings the window's central cell to the robot.
  /// @param robot  in the map's frame
  void scroll_to(Point2 robot);

  /// Draws a scan taken from this pose. A cell counts once a scan, a return before a miss.
  /// @param map_from_robot  m, m, rad
  void update(const Scan& scan, const Pose2& map_from_robot);

  /// The window, in the map's frame.
  const Grid& grid() const noexcept { return grid_; }
  /// The wall in each cell of the grid, finer than the cell.
  const std::vector<WallPoint>& walls() const noexcept { return walls_; }
  /// Differs whenever the grid does.
  std::uint64_t version() const noexcept { return version_; }
  /// What it was made with.
  const LpmOptions& options() const noexcept { return options_; }

 private:
  void trace(Cell from, Cell to);
  void draw_wall();
  void draw_footprint(Point2 robot);
  void add(Cell cell, double log_odds);
  void add_return(Cell cell, Point2 point);

  LpmOptions options_;
  Grid grid_;
  std::vector<WallPoint> walls_;
  std::uint64_t version_ = 0;
  std::vector<std::uint32_t> drawn_;  ///< number of the scan that touched the cell last
  std::uint32_t scan_ = 0;
  std::vector<Cell> ends_;         ///< working space of update
  std::vector<Point2> wall_ = {};  ///< working space of update: returns of beams side by side
};

}  // namespace asterism
