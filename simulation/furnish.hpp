#pragma once

#include "core/random.hpp"
#include "simulation/floor_plan.hpp"

namespace asterism {

/// What stands at the walls of a corridor, and how close.
struct FurnishOptions {
  double min_gap_m = 1;  ///< between one thing at the walls and the next
  double max_gap_m = 4;
  double clutter = 0.45;     ///< probability that a thing stands in the way; else it is a door
  double min_clear_m = 1.2;  ///< of a corridor's width, beside what stands in it
  double glass_doors = 0.1;  ///< share of the doors that are of glass
  double open_doors = 0.1;   ///< share of the doors that stand open to a room
};

/// A piece of corridor between two neighbouring places, without the places themselves.
struct Stretch {
  Point2 from;
  Point2 to;
  double width_m = 0;
};

/// Puts things along the walls of a stretch: cupboards, bins and pillars; doors in their niches,
/// shut, of glass, or open to a room, where no other room is in the way.
void furnish(const Stretch& stretch, const FurnishOptions& options, FloorPlan& plan,
             RandomEngine& engine);

}  // namespace asterism
