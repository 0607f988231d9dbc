#pragma once

#include <cstddef>

#include "core/random.hpp"
#include "simulation/building.hpp"
#include "simulation/furnish.hpp"

namespace asterism {

/// How large an office block is, how its corridors run, and what stands in them.
struct OfficeOptions {
  std::size_t columns = 4;  ///< of the grid on which corridors meet
  std::size_t rows = 3;
  double missing = 0.25;  ///< probability that two neighbouring points have no corridor
  double min_pitch_m = 12;
  double max_pitch_m = 18;
  double min_width_m = 1.6;  ///< of the corridors
  double max_width_m = 3.5;
  double halls = 0.15;  ///< probability that where three or four corridors meet is a round hall
  double blind_stubs = 0.1;  ///< probability that a corridor goes on, blind, where it ends
  std::size_t min_places = 5;
  FurnishOptions furnish = {};
};

/// Corridors that meet at right angles, each of one width, on a grid of uneven pitch; from one
/// place to the next there are 8 m of corridor or more.
///
/// @throws std::invalid_argument if the pitch does not leave that much, or no such building was
///         found in a thousand draws
Building office_building(const OfficeOptions& options, RandomEngine& engine);

}  // namespace asterism
