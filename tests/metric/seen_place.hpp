#pragma once

#include "core/grid.hpp"
#include "core/random.hpp"
#include "tests/support/ideal_world.hpp"

namespace asterism {

/// Place map of an ideal world without a hall, from a visit that was there in the world.
Grid seen_from_visit(const IdealWorld& world, const Pose2& world_from_visit);

/// The same as a robot might have seen it: single cells wrong, boxes that stood there this time
/// only, people who walked by, and corners it never looked into.
Grid seen_badly(Grid place_map, RandomEngine& random);

/// Somewhere near a place's middle, facing anywhere.
Pose2 any_visit(RandomEngine& random);

/// A motion of `most_m` and `most_rad` at most.
Pose2 any_motion(double most_m, double most_rad, RandomEngine& random);

}  // namespace asterism
