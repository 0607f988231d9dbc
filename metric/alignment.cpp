#include "metric/alignment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/squared.hpp"
#include "metric/chi_squared.hpp"
#include "metric/exponential.hpp"
#include "metric/gauss_newton.hpp"
#include "metric/wall_fit.hpp"

namespace asterism {
namespace {

constexpr int most_steps = 10;
constexpr double done_motion = 1e-6;
constexpr std::size_t fewest_walls = 30;
// Without a gateway in common a visit was somewhere at the place, facing anywhere.
constexpr double somewhere_m = 2;
constexpr double anywhere_rad = 1;

// Moving the visit by a small motion in its frame moves a point of it along `direction` so much.
Eigen::Vector3d along(const Pose2& place_from_visit, Point2 in_visit, Point2 direction) {
  const Point2 in_visit_frame = Pose2{0, 0, -place_from_visit.heading_rad} * direction;
  return {in_visit_frame.x_m, in_visit_frame.y_m, cross(in_visit, in_visit_frame)};
}

struct GatewayError {
  double aside_m;
  double ahead_m;
  double turned_rad;
};

GatewayError error(const Pose2& place_from_visit, const MeasuredGateway& first,
                   const MeasuredGateway& second) {
  const Point2 off = place_from_visit * second.middle() - first.middle();
  const Point2 out = unit_vector(first.heading_rad);
  return {cross(out, off), dot(out, off),
          wrapped(place_from_visit.heading_rad + second.heading_rad - first.heading_rad)};
}

}  // namespace

PlaceAlignments::PlaceAlignments(const Trace& trace, std::vector<std::optional<Grid>> place_maps,
                                 const AlignmentOptions& options)
    : trace_(trace),
      place_maps_(std::move(place_maps)),
      options_(options),
      walls_(trace.visits.size()) {
  place_maps_.resize(trace.visits.size());
}

const Alignment& PlaceAlignments::operator()(VisitId first, VisitId visit, std::size_t entered) {
  const auto [entry, fresh] = known_.try_emplace({first.index(), visit.index(), entered},
                                                 Alignment{visit, PlaceId(first.index())});
  if (fresh) entry->second = align(pairs(first, visit, entered), first, visit);
  return entry->second;
}

const PlaceWalls* PlaceAlignments::walls(VisitId visit) {
  std::optional<PlaceWalls>& walls = walls_[visit.index()];
  const std::optional<Grid>& map = place_maps_[visit.index()];
  if (!walls && map) walls.emplace(*map, options_.radius_m);
  return walls ? &*walls : nullptr;
}

std::vector<PlaceAlignments::GatewayPair> PlaceAlignments::pairs(VisitId first, VisitId visit,
                                                                 std::size_t entered) const {
  const Visit& one = trace_.visits[first.index()];
  const Visit& other = trace_.visits[visit.index()];
  const std::size_t arms = one.star.size();
  const std::size_t turned = entered + arms - other.entered_by.value_or(0);
  std::vector<GatewayPair> result;
  for (const MeasuredGateway& gateway : other.gateways) {
    for (std::size_t arm = 0; arm < arms; ++arm) {
      if (other.star.name(arm) != gateway.arm) continue;
      const std::string name = one.star.name((arm + turned) % arms);
      const auto same = std::ranges::find(one.gateways, name, &MeasuredGateway::arm);
      if (same != one.gateways.end()) result.push_back({*same, gateway});
    }
  }
  return result;
}

Alignment PlaceAlignments::align(const std::vector<GatewayPair>& pairs, VisitId first,
                                 VisitId visit) {
  Alignment result{visit, PlaceId(first.index())};
  if (pairs.empty()) {
    result.covariance = diagonal(squared(somewhere_m), squared(anywhere_rad));
    return result;
  }
  // To begin with: turned as the gateways are on average, and moved.
  Point2 turned = {};
  for (const auto& [one, other] : pairs)
    turned = turned + unit_vector(one.heading_rad - other.heading_rad);
  Pose2 pose{0, 0, direction(turned)};
  Point2 moved = {};
  for (const auto& [one, other] : pairs) moved = moved + one.middle() - pose * other.middle();
  moved = (1.0 / static_cast<double>(pairs.size())) * moved;
  pose = {moved.x_m, moved.y_m, pose.heading_rad};

  Matrix3 curvature;
  for (int i = 0; i < most_steps; ++i) {
    GaussNewton equations;
    for (const auto& [one, other] : pairs) {
      const Point2 at = other.middle();
      const Point2 out = unit_vector(one.heading_rad);
      const GatewayError off = error(pose, one, other);
      equations.add(along(pose, at, left_of(out)), off.aside_m, 1 / squared(options_.aside_m));
      equations.add(along(pose, at, out), off.ahead_m, 1 / squared(options_.ahead_m));
      equations.add({0, 0, 1}, off.turned_rad, 1 / squared(options_.heading_rad));
    }
    curvature = equations.curvature;
    const Eigen::Vector3d motion = curvature.ldlt().solve(equations.slope);
    pose = pose * exponential({motion[0], motion[1], motion[2]});
    if (motion.norm() < done_motion) break;
  }

  const PlaceWalls* const of_first = walls(first);
  const PlaceWalls* const of_visit = walls(visit);
  const bool has_walls = of_first != nullptr && of_visit != nullptr &&
                         of_first->pieces().size() >= fewest_walls &&
                         of_visit->pieces().size() >= fewest_walls;
  if (has_walls) {
    const WallFit fit = fit_walls(*of_first, *of_visit, pose, numbers(curvature));
    pose = fit.first_from_second;
    curvature += matrix(fit.information);
    result.matched_walls = fit.matched_walls;
  }
  result.place_from_visit = pose;
  Matrix3 covariance = curvature.inverse();
  if (has_walls)
    covariance.diagonal() += Eigen::Vector3d(squared(options_.shared_m), squared(options_.shared_m),
                                             squared(options_.shared_rad));
  result.covariance = numbers(covariance);
  Misfit& misfit = result.misfit;
  for (const auto& [one, other] : pairs) {
    const GatewayError off = error(pose, one, other);
    misfit.chi_squared += squared(off.aside_m / options_.aside_m) +
                          squared(off.ahead_m / options_.ahead_m) +
                          squared(off.turned_rad / options_.heading_rad);
  }
  misfit.degrees_of_freedom = 3 * pairs.size() - (has_walls ? 0 : 3);
  misfit.tail_probability = chi_squared_tail(misfit.chi_squared, misfit.degrees_of_freedom);
  return result;
}

}  // namespace asterism
