#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/scan.hpp"
#include "simulation/ray_caster.hpp"

namespace asterism {

/// What a laser is like: 180 beams to the front, a degree apart, unless told otherwise.
struct LaserOptions {
  LaserLayout layout = {
      .first_beam_rad = -std::numbers::pi / 2, .beam_step_rad = radians(1), .max_range_m = 80};
  std::size_t beams = 180;
  double noise_m = 0.02;          ///< standard deviation of a range
  double missing = 0.01;          ///< probability that a beam does not return
  double missing_at_glass = 0.9;  ///< probability that a beam which meets glass does not return
  double quantum_m = 0.01;        ///< ranges are told in whole ones of these; 0: as they are
};

/// Someone who stands in the way.
struct Person {
  Point2 position;
  double radius_m = 0.25;
};

/// The ranges that the laser tells at a place, one a beam, m. No return is the maximum range.
std::vector<double> ranges_m(const RayCaster& walls, std::span<const Person> people,
                             const Pose2& world_from_laser, const LaserOptions& options,
                             RandomEngine& engine);

}  // namespace asterism
