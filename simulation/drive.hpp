#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/scan.hpp"
#include "core/topological_map.hpp"
#include "simulation/building.hpp"
#include "simulation/laser.hpp"
#include "simulation/motion.hpp"
#include "simulation/odometry.hpp"
#include "simulation/people.hpp"
#include "simulation/walk.hpp"

namespace asterism {

/// How the robot drives, what it senses with, and who is in its way.
struct DriveOptions {
  MotionOptions motion = {};
  LaserOptions laser = {};
  OdometryOptions odometry = {};
  std::size_t people = 2;
  bool disguised = true;  ///< of the true trace: see WalkOptions
};

/// A robot that drives along a route through a building and scans: what it senses, and the truth.
/// Odometry is right at the first scan, in the building's frame, and drifts from there.
///
/// Deterministic; what one sense draws does not depend on the others. For one thread at a time.
class Drive {
 public:
  /// @param seed  of all that is drawn
  /// @pre  the building's world has segments, and the route keeps to them
  Drive(const Building& building, const Route& route, const DriveOptions& options,
        std::uint64_t seed);
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  /// The next scan; nothing after the last.
  std::optional<Scan> next();

  /// Where the robot truly is at every scan.
  const std::vector<Pose2>& world_from_robot() const noexcept { return motion_.world_from_robot; }
  /// The true trace: visits with stars as the world has them, arms entered and left by, `scans`
  /// while the robot is at the place, exact displacements. And the true map.
  const Walk& truth() const noexcept { return truth_; }

 private:
  void add_measures();

  Building building_;
  DriveOptions options_;
  RandomEngine engine_;
  RayCaster walls_;
  Motion motion_;
  Walk truth_;
  People people_;
  Odometry odometry_;
  RandomEngine laser_engine_;
  std::size_t scan_ = 0;
  std::size_t travel_ = 0;
};

}  // namespace asterism
