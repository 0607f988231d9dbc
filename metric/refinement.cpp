#include "metric/refinement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/squared.hpp"
#include "metric/chi_squared.hpp"
#include "metric/global_map.hpp"
#include "metric/layout.hpp"
#include "metric/layout_residual.hpp"
#include "metric/matrix3.hpp"
#include "metric/wall_fit.hpp"

namespace asterism {
namespace {

constexpr std::array reaches_m{1.0, 0.5};  // how far off the start may be, by turns
constexpr double start_m = 0.5;            // deviation of the start
constexpr double start_rad = 0.1;
constexpr double loose_m = 5;  // where walls leave a direction open, a fit says no more than this
constexpr double loose_rad = 1;
constexpr std::size_t fewest_walls = 100;
constexpr double contradiction_tail = 1e-3;  // fits whose χ² is rarer than that are left out
constexpr int most_rounds = 10;

PoseCovariance covariance(const WallFit& fit, const RefinementOptions& options) {
  RowMajor3 information = matrix(fit.information);
  information.diagonal() +=
      Eigen::Vector3d(1 / squared(loose_m), 1 / squared(loose_m), 1 / squared(loose_rad));
  const RowMajor3 inverse = information.inverse();
  PoseCovariance result = numbers((inverse + inverse.transpose()) / 2);
  for (const std::size_t i : {0U, 4U}) result[i] += squared(options.shared_m);
  result[8] += squared(options.shared_rad);
  return result;
}

double misfit(const PlaceDisplacement& fit, std::span<const Pose2> poses) {
  return LayoutResidual(fit.displacement)(poses[fit.from.index()], poses[fit.to.index()])
      .residual.squaredNorm();
}

}  // namespace

// Where one map lies in another's frame, by their walls.
struct Refinement::Fit {
  PlaceDisplacement displacement;
};

Refinement::Refinement(std::span<const Scan> scans, std::span<const LocalPose> driven,
                       const RefinementOptions& options)
    : scans_(scans), driven_(driven), options_(options) {
  if (scans.empty() || scans.size() != driven.size())
    throw std::invalid_argument("there is not a pose a scan");
  way_m_.push_back(0);
  turned_rad_.push_back(0);
  maps_.push_back(0);
  for (std::size_t scan = 1; scan < driven.size(); ++scan) {
    const Pose2 step = inverse(driven[scan - 1].map_from_robot) * driven[scan].map_from_robot;
    way_m_.push_back(way_m_.back() + norm(step.position()));
    turned_rad_.push_back(turned_rad_.back() + std::abs(step.heading_rad));
    if (way_m_[scan] - way_m_[maps_.back()] >= options.every_m) maps_.push_back(scan);
  }
  walls_.resize(maps_.size());
}

// Of the map drawn by the scans round one, in the frame of the robot there.
const PlaceWalls& Refinement::walls(std::size_t map) {
  if (!walls_[map]) {
    const std::size_t middle = maps_[map];
    const auto way = [&](double at_m) {
      return static_cast<std::size_t>(std::ranges::lower_bound(way_m_, at_m) - way_m_.begin());
    };
    const std::size_t first = way(way_m_[middle] - options_.reach_m);
    const std::size_t last = std::max(middle + 1, way(way_m_[middle] + options_.reach_m));
    const Pose2 robot_from_map = inverse(driven_[middle].map_from_robot);
    Trajectory poses;
    for (std::size_t scan = first; scan < last; ++scan)
      poses.push_back({driven_[scan].stamp_s, robot_from_map * driven_[scan].map_from_robot});
    const Grid grid =
        global_map(scans_.subspan(first, last - first), poses,
                   {.resolution_m = options_.cell_m, .usable_range_m = options_.range_m});
    walls_[map].emplace(grid, options_.range_m);
  }
  return *walls_[map];
}

// Of all maps that lie near to one another, the robot having been away in between.
std::vector<Refinement::Fit> Refinement::fits(std::span<const Pose2> poses, double reach_m) {
  std::vector<Fit> result;
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t j = 0; way_m_[maps_[i]] - way_m_[maps_[j]] > 2 * options_.reach_m; ++j) {
      const double away_m = norm(poses[i].position() - poses[j].position());
      if (away_m <= options_.near_m) near.emplace_back(away_m, j);
    }
    std::ranges::sort(near);
    near.resize(std::min(near.size(), options_.neighbours));
    for (const auto& [away_m, j] : near) {
      if (std::min(walls(i).pieces().size(), walls(j).pieces().size()) < fewest_walls) continue;
      const Pose2 start = inverse(poses[j]) * poses[i];
      const WallFit fit =
          fit_walls(walls(j), walls(i), start,
                    diagonal(1 / squared(start_m), 1 / squared(start_rad)), {.reach_m = reach_m});
      const Pose2 moved = inverse(start) * fit.first_from_second;
      if (fit.matched_walls < options_.least_matched || norm(moved.position()) > reach_m) continue;
      result.push_back({{PlaceId(j), PlaceId(i),
                         make_displacement(fit.first_from_second, covariance(fit, options_))}});
    }
  }
  return result;
}

std::vector<Pose2> Refinement::solve(std::span<const Pose2> start, std::vector<Fit> fits) const {
  std::vector<PlaceDisplacement> way;
  for (std::size_t i = 1; i < maps_.size(); ++i) {
    const std::size_t before = maps_[i - 1];
    const std::size_t after = maps_[i];
    const Pose2 moved = inverse(driven_[before].map_from_robot) * driven_[after].map_from_robot;
    const double way_m = way_m_[after] - way_m_[before];
    const double turned_rad = turned_rad_[after] - turned_rad_[before];
    way.push_back(
        {PlaceId(i - 1), PlaceId(i),
         make_displacement(
             moved, diagonal(squared(options_.any_m) + way_m * squared(options_.per_m),
                             squared(options_.any_rad) + way_m * squared(options_.per_m_rad) +
                                 turned_rad * squared(options_.per_rad_rad)))});
  }
  std::vector<Pose2> poses(start.begin(), start.end());
  const double most = chi_squared_of_tail(contradiction_tail, 3);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<PlaceDisplacement> all = way;
    for (const Fit& fit : fits) all.push_back(fit.displacement);
    poses =
        lay_out(maps_.size(), all, {.start = poses, .with_covariances = false}).layout_from_place;
    const auto contradicts = [&](const Fit& fit) { return misfit(fit.displacement, poses) > most; };
    if (std::erase_if(fits, contradicts) == 0) break;
  }
  return poses;
}

Trajectory Refinement::operator()(const Trajectory& start) {
  if (start.size() != driven_.size())
    throw std::invalid_argument("the trajectory has not a pose a scan");
  std::vector<Pose2> poses;
  for (const std::size_t scan : maps_) poses.push_back(start[scan].layout_from_robot);
  for (const double reach_m : reaches_m) {
    std::vector<Fit> found = fits(poses, reach_m);
    if (found.empty()) return start;
    poses = solve(poses, std::move(found));
  }
  std::vector<Anchor> anchors;
  for (std::size_t i = 0; i < maps_.size(); ++i) anchors.push_back({maps_[i], poses[i]});
  return fit_trajectory(driven_, anchors);
}

}  // namespace asterism
