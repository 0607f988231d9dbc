#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/pose_covariance.hpp"
#include "perception/local_perceptual_map.hpp"

namespace asterism {

/// How well returns lie on walls.
struct ScanFitOptions {
  double reach_m = 0.3;   ///< a return farther from every wall belongs to none
  double sigma_m = 0.02;  ///< deviation of a return from its wall
  double outlier = 3;     ///< so many deviations off, a return counts a quarter
  double unknown = 0.2;   ///< cost of a return amid unknown cells, where 1 is that amid free ones
  int most_steps = 20;
};

/// Fits the returns of a scan to the walls of a map, finer than its cells: the wall of a cell is
/// the mean of its returns, and points along the walls of the cells round it. Distances across the
/// wall count, those along it hardly; where the walls round have no direction, all do.
///
///   pose* = argmin Σ_i ρ(dᵢᵀ M_w dᵢ) + ρ(eᵀ Q e),
///   dᵢ: from wall w to return i,   e = Log(odometry⁻¹ pose)
///
/// by Gauss-Newton with the nearest walls found anew at each step; ρ(x) = k² x / (k² + x). Threads
/// may fit at once while none draws.
class ScanFit {
 public:
  /// Knows no walls yet: see draw.
  explicit ScanFit(const ScanFitOptions& options) : options_(options) {}

  /// Takes over the map's walls.
  void draw(const LocalPerceptualMap& map);

  /// Where a scan fits best, and how well.
  struct Fit {
    Pose2 map_from_robot = {};
    PoseCovariance covariance = {};  ///< inverse of the curvature at the optimum
    double cost = 0;
    double matched = 0;  ///< share of the returns that found a wall
  };
  /// The pose from which returns lie on the walls best, near where it starts.
  ///
  /// @param returns      in the robot's frame, m; at least one
  /// @param start        map_from_robot to begin with
  /// @param by_odometry  map_from_robot as the wheels tell it
  /// @param odometry_information  diagonal of Q, in the robot's frame; positive
  Fit fit(std::span<const Point2> returns, const Pose2& start, const Pose2& by_odometry,
          const SmallMotion& odometry_information) const;

 private:
  struct Wall {
    Point2 mean = {};
    std::array<double, 3> information = {};  ///< M_w: xx, xy, yy
  };
  // Gauss-Newton's equations: curvature · motion = slope.
  struct Equations {
    PoseCovariance curvature = {};
    SmallMotion slope = {};
    double cost = 0;
    std::size_t matched = 0;
  };

  const Wall* nearest(Point2 in_map) const;
  bool is_unknown(Point2 in_map) const;
  Equations equations(std::span<const Point2> returns, const Pose2& map_from_robot) const;

  ScanFitOptions options_;
  Grid frame_ = {};  ///< the map's, without its cells
  std::vector<int> wall_of_cell_;
  std::vector<Wall> walls_;
};

}  // namespace asterism
