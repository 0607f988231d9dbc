#include "simulation/world.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <set>

namespace asterism {
namespace {

/// One direction of a corridor, leaving a point.
struct Departure {
  Point2 direction;
  Arm arm;
  std::optional<std::size_t> reached;  ///< the next place, a point, if any
};

Point2 reversed(Point2 direction) { return {-direction.x_m, -direction.y_m}; }

/// Clockwise as seen from above, from north.
bool is_clockwise_before(Point2 a, Point2 b) {
  const auto in_west = [](Point2 d) { return d.x_m < 0 || (d.x_m == 0 && d.y_m < 0); };
  if (in_west(a) != in_west(b)) return in_west(b);
  return cross(a, b) < 0;
}

/// For each point: how many corridors leave it, and in how many directions.
std::vector<bool> places_among(std::size_t points, const std::vector<Corridor>& corridors) {
  std::vector<std::size_t> met(points);
  std::vector<std::size_t> gateways(points);
  for (const auto& corridor : corridors) {
    for (std::size_t i = 0; i < corridor.points.size(); ++i) {
      ++met[corridor.points[i]];
      if (i > 0 || corridor.stub_at_start) ++gateways[corridor.points[i]];
      if (i + 1 < corridor.points.size() || corridor.stub_at_end) ++gateways[corridor.points[i]];
    }
  }
  std::vector<bool> result;
  for (std::size_t p = 0; p < points; ++p)
    result.push_back(met[p] > 1 || (met[p] == 1 && gateways[p] == 1));
  return result;
}

using Departures = std::vector<std::vector<Departure>>;  ///< [point]: clockwise from north

Departures departures(std::size_t points, const std::vector<Corridor>& corridors) {
  const std::vector<bool> is_place = places_among(points, corridors);
  Departures result(points);
  for (const auto& [label, direction, along, stub_at_start, stub_at_end] : corridors) {
    std::vector<std::size_t> stops;
    std::copy_if(along.begin(), along.end(), std::back_inserter(stops),
                 [&](std::size_t point) { return is_place[point]; });
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const bool goes_on = stops[i] != along.back() || stub_at_end;
      const bool goes_back = stops[i] != along.front() || stub_at_start;
      std::optional<std::size_t> next;
      std::optional<std::size_t> previous;
      if (i + 1 < stops.size()) next = stops[i + 1];
      if (i > 0) previous = stops[i - 1];
      result[stops[i]].push_back({direction, {label, '+', goes_on}, next});
      result[stops[i]].push_back({reversed(direction), {label, '-', goes_back}, previous});
    }
  }
  for (auto& around : result)
    std::sort(around.begin(), around.end(), [](const Departure& a, const Departure& b) {
      return is_clockwise_before(a.direction, b.direction);
    });
  return result;
}

std::set<std::size_t> reachable(const Departures& from, std::size_t start) {
  std::set<std::size_t> reached{start};
  for (std::vector<std::size_t> open{start}; !open.empty();) {
    const std::size_t point = open.back();
    open.pop_back();
    for (const auto& departure : from[point])
      if (departure.reached && reached.insert(*departure.reached).second)
        open.push_back(*departure.reached);
  }
  return reached;
}

std::set<std::size_t> largest_part(const Departures& from) {
  std::set<std::size_t> largest;
  std::set<std::size_t> done;
  for (std::size_t point = 0; point < from.size(); ++point) {
    if (from[point].empty() || done.contains(point)) continue;
    const std::set<std::size_t> part = reachable(from, point);
    done.insert(part.begin(), part.end());
    if (part.size() > largest.size()) largest = part;
  }
  return largest;
}

}  // namespace

World make_world(const std::vector<Point2>& points, const std::vector<Corridor>& corridors) {
  const Departures from = departures(points.size(), corridors);
  World world;
  std::map<std::size_t, PlaceId> place_at;
  for (const std::size_t point : largest_part(from)) {
    std::vector<Arm> arms;
    for (const auto& departure : from[point]) arms.push_back(departure.arm);
    place_at.emplace(point, world.places.size());
    world.places.push_back({points[point], Star(std::move(arms))});
  }
  for (const auto& [point, place] : place_at) {
    const Star& star = world.places[place.index()].star;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Departure& departure = from[point][i];
      if (!departure.reached) continue;
      const PlaceId reached = place_at.at(*departure.reached);
      const char back = departure.arm.sign == '+' ? '-' : '+';
      const auto entered = world.places[reached.index()].star.find(departure.arm.label + back);
      world.segments.emplace(PlaceArm{place, i}, PlaceArm{reached, entered.value()});
    }
  }
  assert(paths_are_straight(world));
  return world;
}

bool paths_are_straight(const World& world) {
  for (const auto& segment : world.segments) {
    std::set<PlaceId> met{segment.first.place};
    for (auto next = world.segments.find(segment.first); next != world.segments.end();) {
      const PlaceArm reached = next->second;
      if (!met.insert(reached.place).second) return false;
      const Star& star = world.places[reached.place.index()].star;
      next = world.segments.find({reached.place, star.opposite(reached.arm)});
    }
  }
  return true;
}

}  // namespace asterism
