#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "core/scan.hpp"

namespace asterism {

struct LpmOptions {
  int cells = 300;  ///< columns, and rows
  double resolution_m = 0.10;
  double usable_range_m = 20;  ///< farther returns say free up to here, and no more

  double hit = 0.7;       ///< log-odds that a return adds to its cell
  double miss = -0.5;     ///< ... and to each cell it came through
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
class LocalPerceptualMap {
 public:
  explicit LocalPerceptualMap(const LpmOptions& options);

  /// Brings the window's central cell to the robot.
  void scroll_to(Point2 robot);

  /// Draws a scan taken from this pose. A cell counts once a scan, a return before a miss.
  void update(const Scan& scan, const Pose2& map_from_robot);

  const Grid& grid() const noexcept { return grid_; }
  /// Of each cell of the grid, finer than the cell.
  const std::vector<WallPoint>& walls() const noexcept { return walls_; }
  /// Differs whenever the grid does.
  std::uint64_t version() const noexcept { return version_; }
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
  std::vector<Point2> wall_ = {};  ///< returns of beams side by side, the same
};

}  // namespace asterism
