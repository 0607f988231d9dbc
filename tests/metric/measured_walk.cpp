#include "tests/metric/measured_walk.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "metric/exponential.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/metric/random_layout.hpp"

namespace asterism {
namespace {

constexpr double gateway_out_m = 2;  // from a place's middle to its gateways

}  // namespace

MeasuredWalk measured_walk(std::size_t travels, double scale, RandomEngine& random,
                           std::size_t width) {
  const World world = grid_world({.width = width, .height = width}, random);
  Walk walked = walk(world, {.travels = travels, .disguised = false}, random);
  MeasuredWalk result{std::move(walked.trace), std::move(walked.truth), {}};
  for (Visit& visit : result.trace.visits) {
    const PlaceId place(std::stoul(visit.true_place.value()));
    const auto position = [&](PlaceId of) { return world.places[of.index()].position; };
    const Point2 somewhere{between(-1, 1, random), between(-1, 1, random)};
    const Point2 at = position(place) + somewhere;
    result.world_from_visit.push_back(
        {at.x_m, at.y_m, between(-std::numbers::pi, std::numbers::pi, random)});
    for (std::size_t arm = 0; arm < visit.star.size(); ++arm) {
      const auto leads = world.segments.find({place, arm});
      if (leads == world.segments.end()) continue;
      const double heading_rad = direction(position(leads->second.place) - position(place));
      const Point2 middle = position(place) + gateway_out_m * unit_vector(heading_rad);
      const Pose2 seen =
          inverse(result.world_from_visit.back()) * Pose2{middle.x_m, middle.y_m, heading_rad};
      visit.gateways.push_back({visit.star.name(arm), seen.x_m, seen.y_m, seen.heading_rad, 2.0});
    }
  }
  for (std::size_t k = 1; k < result.trace.visits.size(); ++k) {
    const PoseCovariance covariance = any_covariance(scale, random);
    const Pose2 moved = inverse(result.world_from_visit[k - 1]) * result.world_from_visit[k] *
                        exponential(drawn_from(covariance, random));
    result.trace.visits[k].displacement = make_displacement(moved, covariance);
  }
  return result;
}

Trace measured_backwards(const Trace& trace) {
  Trace back = trace;
  std::ranges::reverse(back.visits);
  for (std::size_t k = 0; k < back.visits.size(); ++k) {
    Visit& visit = back.visits[k];
    std::swap(visit.entered_by, visit.left_by);
    visit.displacement.reset();
    if (k == 0) continue;
    const Displacement& there = *trace.visits[trace.visits.size() - k].displacement;
    const Pose2 moved = there.left_from_reached();
    visit.displacement = make_displacement(inverse(moved), seen_from(moved, there.covariance));
  }
  return back;
}

Trace measured_in_mirror(const Trace& trace) {
  Trace mirror = trace;
  for (Visit& visit : mirror.visits) {
    std::vector<Arm> arms;
    for (std::size_t i = visit.star.size(); i-- > 0;) arms.push_back(visit.star.arm(i));
    const auto mirrored = [&](std::optional<std::size_t>& arm) {
      if (arm) arm = visit.star.size() - 1 - *arm;
    };
    mirrored(visit.entered_by);
    mirrored(visit.left_by);
    visit.star = Star(std::move(arms));
    for (MeasuredGateway& gateway : visit.gateways) {
      gateway.y_m = -gateway.y_m;
      gateway.heading_rad = -gateway.heading_rad;
    }
    if (!visit.displacement) continue;
    visit.displacement->y_m = -visit.displacement->y_m;
    visit.displacement->heading_rad = -visit.displacement->heading_rad;
    for (const std::size_t i : {1U, 2U, 3U, 6U})
      visit.displacement->covariance[i] = -visit.displacement->covariance[i];
  }
  return mirror;
}

Trace measured_turned(const Trace& trace, double angle_rad) {
  Trace turned = trace;
  const Pose2 robot_from_visit{0, 0, angle_rad};
  const Pose2 visit_from_robot = inverse(robot_from_visit);
  for (Visit& visit : turned.visits) {
    for (MeasuredGateway& gateway : visit.gateways) {
      const Pose2 seen = visit_from_robot * gateway.visit_from_gateway();
      gateway = {gateway.arm, seen.x_m, seen.y_m, seen.heading_rad, gateway.width_m};
    }
    if (visit.displacement)
      visit.displacement = make_displacement(
          visit_from_robot * visit.displacement->left_from_reached() * robot_from_visit,
          seen_from(visit_from_robot, visit.displacement->covariance));
  }
  return turned;
}

}  // namespace asterism
