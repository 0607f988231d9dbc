#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/pose2.hpp"

namespace asterism {

/// A cell of a grid: column to the right (+x), row upwards (+y).
struct Cell {
  int column = 0;
  int row = 0;
  friend bool operator==(Cell, Cell) = default;
};

/// An occupancy grid: the logarithm of the odds that a cell holds an obstacle; 0 is unknown.
/// Row by row from the bottom, each from the left: log_odds[row · width + column].
struct Grid {
  int width = 0;   ///< columns
  int height = 0;  ///< rows
  double resolution_m = 0.1;
  Pose2 frame_from_grid = {};  ///< the grid's lower left corner and its axes, in its frame
  std::vector<float> log_odds = {};

  /// Whether a cell lies on the grid.
  bool contains(Cell cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width && cell.row < height;
  }
  /// Where the value of a cell stands in log_odds.   @pre contains(cell)
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(cell.column);
  }
  /// The cell round a point of the frame; it may lie outside the grid.
  Cell cell_at(Point2 in_frame) const {
    const Point2 point = inverse(frame_from_grid) * in_frame;
    return {static_cast<int>(std::floor(point.x_m / resolution_m)),
            static_cast<int>(std::floor(point.y_m / resolution_m))};
  }
  /// The middle of a cell, in the frame.
  Point2 centre(Cell cell) const {
    return frame_from_grid *
           Point2{(cell.column + 0.5) * resolution_m, (cell.row + 0.5) * resolution_m};
  }

  /// Calls `visit` with the cells at most so many rows and columns from one, as far as the grid
  /// goes: row by row from the bottom.
  template <class Visit>
  void for_each_round(Cell cell, int reach, Visit visit) const {
    const int last_row = std::min(height - 1, cell.row + reach);
    const int last_column = std::min(width - 1, cell.column + reach);
    for (int row = std::max(0, cell.row - reach); row <= last_row; ++row)
      for (int column = std::max(0, cell.column - reach); column <= last_column; ++column)
        visit(Cell{column, row});
  }

  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Size, resolution and pose of a grid, without its cells.
inline Grid frame_of(const Grid& grid) {
  return {.width = grid.width,
          .height = grid.height,
          .resolution_m = grid.resolution_m,
          .frame_from_grid = grid.frame_from_grid};
}

}  // namespace asterism
