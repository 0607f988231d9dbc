#include "simulation/building.hpp"

#include <numbers>
#include <stdexcept>
#include <utility>

namespace asterism {
namespace {

Star mirrored(const Star& star) {
  std::vector<Arm> arms;
  for (std::size_t i = star.size(); i-- > 0;) arms.push_back(star.arm(i));
  return Star(std::move(arms));
}

World mirrored(const World& world) {
  const auto mirror = [&](PlaceArm end) {
    const std::size_t arms = world.places[end.place.index()].star.size();
    return PlaceArm{end.place, arms - 1 - end.arm};
  };
  World result;
  for (const World::Place& place : world.places)
    result.places.push_back({{place.position.x_m, -place.position.y_m}, mirrored(place.star)});
  for (const auto& [gateway, reached] : world.segments)
    result.segments.emplace(mirror(gateway), mirror(reached));
  return result;
}

}  // namespace

std::vector<double> arm_headings_rad(const World& world, PlaceId place) {
  const auto& [position, star] = world.places.at(place.index());
  std::vector<double> result;
  for (std::size_t arm = 0; arm < star.size(); ++arm) {
    const auto ahead = world.segments.find({place, arm});
    const auto behind = world.segments.find({place, star.opposite(arm)});
    if (ahead == world.segments.end() && behind == world.segments.end())
      throw std::invalid_argument("found a local-path without a segment at place " +
                                  std::to_string(place.index()) + "; expected one or two");
    const bool is_ahead = ahead != world.segments.end();
    const PlaceId other = (is_ahead ? ahead : behind)->second.place;
    const Point2 way = world.places[other.index()].position - position;
    result.push_back(wrapped(direction(way) + (is_ahead ? 0 : std::numbers::pi)));
  }
  return result;
}

Building moved(Building building, const Pose2& there_from_here) {
  for (World::Place& place : building.world.places)
    place.position = there_from_here * place.position;
  for (Wall& wall : building.walls) {
    wall.from = there_from_here * wall.from;
    wall.to = there_from_here * wall.to;
  }
  return building;
}

Building mirrored(const Building& building) {
  Building result{building.name, mirrored(building.world), building.place_radius_m, {}};
  const auto mirror = [](Point2 point) { return Point2{point.x_m, -point.y_m}; };
  for (const Wall& wall : building.walls)
    result.walls.push_back({mirror(wall.from), mirror(wall.to), wall.is_glass});
  return result;
}

}  // namespace asterism
