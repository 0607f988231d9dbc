#pragma once

#include <array>
#include <vector>

#include "core/pose2.hpp"
#include "core/random.hpp"
#include "simulation/building.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/walk.hpp"

namespace asterism {

/// How fast and how near to things a robot drives.
struct MotionOptions {
  double step_s = 0.2;  ///< between two scans
  double speed_m_per_s = 0.5;
  double acceleration_m_per_s2 = 0.4;
  double turn_rad_per_s = 0.6;
  double max_stand_s = 4;        ///< before, and after, the look round
  double look_round_rad = 6.45;  ///< at every place: once round and a little more
  double side_m = 0.4;           ///< how near to a wall or a thing the robot's middle comes
};

/// Where a robot truly is at every scan of a drive.
struct Motion {
  std::vector<Pose2> world_from_robot;             ///< [scan]
  std::vector<std::array<std::size_t, 2>> visits;  ///< [visit]: first and last scan at the place
  std::vector<std::size_t> departures;             ///< [travel]: the scan from which it drives
  std::vector<double> travels_m;                   ///< [travel]: how far it drives
};

/// A robot that goes along a route: it stops at every place, near its middle, looks round, turns,
/// and drives on along the corridor, swaying a little and keeping clear of what stands in it.
Motion move_along(const Building& building, const RayCaster& walls, const Route& route,
                  const MotionOptions& options, RandomEngine& engine);

}  // namespace asterism
