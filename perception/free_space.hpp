#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.hpp"
#include "perception/bit_rows.hpp"

namespace asterism {

/// What is known of a cell.
enum class Occupancy : std::uint8_t { unknown, free, occupied };

/// What a grid says of space: each cell free, occupied or unknown, and how far the nearest cell is
/// that is not free. Cells outside the grid are unknown.
struct FreeSpace {
  Grid frame = {};  ///< size, resolution and pose of the grid; holds no values
  BitRows free = {};
  BitRows occupied = {};
  /// From the middle of each free cell to the nearest other cell's rim; 0 where not free.
  std::vector<float> clearance_m = {};

  /// Whether a cell is free; none outside the grid is.
  bool is_free(Cell cell) const { return free.has(cell); }
  /// What is known of a cell; outside the grid nothing.
  Occupancy at(Cell cell) const {
    return is_free(cell)        ? Occupancy::free
           : occupied.has(cell) ? Occupancy::occupied
                                : Occupancy::unknown;
  }
  /// r_p of [BMK10, §5.1.1], m; 0 where not free.
  double clearance(Cell cell) const {
    return frame.contains(cell) ? static_cast<double>(clearance_m[frame.index(cell)]) : 0;
  }
};

/// What counts as known, and what stands in the way but is no wall.
struct FreeSpaceOptions {
  double known = 0.3;         ///< log-odds from which a cell is known, either way
  double island_max_m = 1.0;  ///< extent up to which what stands in free space is no wall
};

/// Islands, occupied or unknown cells wholly surrounded by free ones and at most island_max_m
/// across, are taken out: people, legs of chairs, cells between beams.  [theory §11] [BMK10,
/// §5.1.1]
FreeSpace free_space(const Grid& grid, const FreeSpaceOptions& options = {});

/// Squared distance, in cells, from each set cell's middle to the middle of the nearest that is not
/// set, those outside the picture among them; 0 where not set. Exact, in linear time [FH12]. Row by
/// row, as a grid.
std::vector<float> squared_distances(const BitRows& picture);

}  // namespace asterism
