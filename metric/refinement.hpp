#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/scan.hpp"
#include "metric/place_walls.hpp"
#include "metric/trajectory.hpp"

namespace asterism {

/// Which local maps are fitted to each other, and how much the way driven yields to them.
struct RefinementOptions {
  double every_m = 3;          ///< driven from one local map to the next
  double reach_m = 4;          ///< a local map is drawn by scans from so far before to so far after
  double range_m = 12;         ///< it is drawn by returns no farther than this
  double cell_m = 0.1;         ///< it is drawn in cells of this size
  double near_m = 3;           ///< maps no farther apart, that share no scan, are fitted
  std::size_t neighbours = 6;  ///< at most so many are fitted to one map, the nearest
  double least_matched = 0.6;  ///< share of the walls that must match

  // Deviations of the way driven between two maps: of any, and a root of a metre, or of a radian.
  double any_m = 0.02;
  double any_rad = 0.003;
  double per_m = 0.03;
  double per_m_rad = 0.004;
  double per_rad_rad = 0.01;

  // Deviations that all walls of two maps share.
  double shared_m = 0.02;
  double shared_rad = 0.003;
};

/// Refines a trajectory where the robot came by again, at a place or between two: local maps along
/// the way that show the same walls are fitted to each other, beginning where the trajectory puts
/// them, and the way driven yields to all fits together. Fits that contradict the others are left
/// out.
///                                                           [BMK10, §7.3.4] [LM97]
/// For one thread at a time: it keeps the local maps it has drawn.
class Refinement {
 public:
  /// @param driven  one pose a scan; both outlive this
  /// @throws std::invalid_argument if there are not as many, or none
  Refinement(std::span<const Scan> scans, std::span<const LocalPose> driven,
             const RefinementOptions& options = {});

  /// The trajectory that all fits and the way driven agree on best.
  ///
  /// @param start  a pose a pose driven, off by less than PlaceWalls::reach_m where the robot came
  ///               by again
  /// @return  the start refined; the same where the robot never came by again. The pose at the
  ///          first map stays.
  Trajectory operator()(const Trajectory& start);

 private:
  struct Fit;

  std::vector<Fit> fits(std::span<const Pose2> poses, double reach_m);
  std::vector<Pose2> solve(std::span<const Pose2> start, std::vector<Fit> fits) const;
  const PlaceWalls& walls(std::size_t map);

  std::span<const Scan> scans_;
  std::span<const LocalPose> driven_;
  RefinementOptions options_;
  std::vector<double> way_m_;       ///< driven up to each scan
  std::vector<double> turned_rad_;  ///< turned up to each scan
  std::vector<std::size_t> maps_;   ///< the scan in the middle of each local map
  std::vector<std::optional<PlaceWalls>> walls_;
};

}  // namespace asterism
