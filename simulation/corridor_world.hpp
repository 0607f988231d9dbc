#pragma once

#include <cstddef>

#include "core/random.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// How many corridors are drawn, where, and how they end.
struct CorridorOptions {
  std::size_t corridors = 12;  ///< to draw; one that finds no room is left out
  double side_m = 60;          ///< of the square in which their middles lie
  double min_length_m = 30;
  double max_length_m = 70;
  double clearance_m = 3;      ///< between crossings, and of ends from other corridors
  double ends_crossing = 0.4;  ///< probability that a corridor ends at its last crossing
  double ends_blind = 0.1;     ///< that it goes on beyond it as a blind stub; else to a dead end
  std::size_t min_places = 5;  ///< of the part that is kept
};

/// Straight corridors at random angles, crossing two at a time. Local-path c3 is of corridor 3.
/// Coordinates in m, x to the east, y to the north.
///
/// @throws std::invalid_argument if no such world was found in a thousand draws
World corridor_world(const CorridorOptions& options, RandomEngine& engine);

}  // namespace asterism
