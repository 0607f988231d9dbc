#pragma once

#include <cstdint>
#include <vector>

#include "core/grid.hpp"

namespace asterism {

enum class Occupancy : std::uint8_t { unknown, free, occupied };

/// What a grid says of space: each cell free, occupied or unknown, and how far the nearest cell is
/// that is not free. Cells outside the grid are unknown.
struct FreeSpace {
  Grid frame = {};  ///< size, resolution and pose of the grid; holds no values
  std::vector<Occupancy> cells = {};
  std::vector<float> clearance_m =
      {};  ///< from a free cell's middle to the nearest other cell's rim

  Occupancy at(Cell cell) const {
    return frame.contains(cell) ? cells[frame.index(cell)] : Occupancy::unknown;
  }
  bool is_free(Cell cell) const { return at(cell) == Occupancy::free; }
  /// r_p of [BMK10, §5.1.1]; 0 where not free.
  double clearance(Cell cell) const {
    return frame.contains(cell) ? static_cast<double>(clearance_m[frame.index(cell)]) : 0;
  }
};

struct FreeSpaceOptions {
  double known = 0.3;         ///< log-odds from which a cell is known, either way
  double island_max_m = 1.0;  ///< extent up to which what stands in free space is no wall
};

/// Islands, occupied or unknown cells wholly surrounded by free ones and at most island_max_m
/// across, are taken out: people, legs of chairs, cells between beams.  [DESIGN §11] [BMK10,
/// §5.1.1]
FreeSpace free_space(const Grid& grid, const FreeSpaceOptions& options = {});

/// Squared distance, in cells, from each cell's middle to the nearest marked cell's middle; exact,
/// in linear time [FH12]. Where nothing is marked: above width² + height².
std::vector<float> squared_distances(const std::vector<std::uint8_t>& marked, int width,
                                     int height);

}  // namespace asterism
