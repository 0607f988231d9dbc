#pragma once

#include <cstddef>

#include "core/random.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// How large a grid is, and what of it is missing.
struct GridOptions {
  std::size_t width = 4;   ///< points from west to east
  std::size_t height = 4;  ///< points from north to south
  double pitch_m = 10;
  double missing = 0.2;        ///< probability that two neighbouring points have no corridor
  double stubs = 0.1;          ///< probability of a blind stub, where a point has no corridor
  std::size_t min_places = 2;  ///< of the part that is kept
};

/// Corridors on a grid, some missing, with some blind stubs. Local-paths v+ lead north, h+ east.
/// Points are numbered by rows, from the north-west. Coordinates in m, x to the east, y to the
/// north.
///
/// @throws std::invalid_argument if no such world was found in a thousand draws
World grid_world(const GridOptions& options, RandomEngine& engine);

}  // namespace asterism
