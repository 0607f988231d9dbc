#pragma once

#include <vector>

#include "core/grid.hpp"

namespace asterism {

/// What a grid says of a cell, by the thresholds of an occupancy map's file.
enum class Ground { free, unknown, wall };

/// Of cells beside the grid, too: unknown.
Ground ground_at(const Grid& grid, Cell cell);

/// How much of a line does not run over free cells.
struct NotFree {
  double wall_m = 0;
  double unknown_m = 0;
};

/// Of the straight line between two points of the grid's frame. Exact: cell by cell.
NotFree not_free(const Grid& grid, Point2 from, Point2 to);

/// Of a line through points.
NotFree not_free(const Grid& grid, const std::vector<Point2>& line);

/// A line that comes by a spot twice goes on there as it did the last time.
/// @param near_m  what counts as one spot
std::vector<Point2> without_loops(const Grid& grid, const std::vector<Point2>& line, double near_m);

/// A line whose parts over walls and unknown ground go round them, where a way over free cells, as
/// near as `reach_m`, leads from one end of the part to the other. Elsewhere it stays as it is.
std::vector<Point2> led_round(const Grid& grid, const std::vector<Point2>& line, double reach_m);

/// A line of fewer points, nowhere farther than that from the one given and no more over walls or
/// unknown ground than it: Douglas and Peucker's, with straight parts that keep to what is free.
std::vector<Point2> simplified(const Grid& grid, const std::vector<Point2>& line,
                               double tolerance_m);

/// The least way across a line from wall to wall, looked at every 0.1 m, up to 10 m to each side.
double least_width_m(const Grid& grid, const std::vector<Point2>& line);

}  // namespace asterism
