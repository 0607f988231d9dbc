#pragma once

#include <vector>

#include "core/pose2.hpp"
#include "core/random.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A walk through a random grid of corridors, with what a robot would have measured on it.
struct MeasuredWalk {
  Trace trace;  ///< with displacements, a little off, and gateways, exact
  std::vector<Arrival> truth;
  std::vector<Pose2> world_from_visit;
};

/// @param scale  deviation of the displacements, m; their headings are off by a tenth of it, rad
/// @param width  of the grid, and its height: the larger, the less often a walk comes back
MeasuredWalk measured_walk(std::size_t travels, double scale, RandomEngine& random,
                           std::size_t width = 4);

/// The same walk the other way round, backwards in time.
Trace measured_backwards(const Trace& trace);
/// The same walk through a mirror.
Trace measured_in_mirror(const Trace& trace);
/// The same walk where a visit's frame is turned by this against the robot.
Trace measured_turned(const Trace& trace, double angle_rad);

}  // namespace asterism
