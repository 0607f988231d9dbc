#include "simulation/walk.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

namespace asterism {
namespace {

/// The gateways of a place that lead somewhere, clockwise after arm `after`, which comes last.
std::vector<PlaceArm> ways_on(const World& world, PlaceArm after) {
  const Star& star = world.places[after.place.index()].star;
  std::vector<PlaceArm> result;
  for (std::size_t step = 1; step <= star.size(); ++step) {
    const PlaceArm gateway{after.place, star.clockwise(after.arm, step)};
    if (world.segments.contains(gateway)) result.push_back(gateway);
  }
  return result;
}

std::size_t weighted(const std::vector<double>& weights, RandomEngine& engine) {
  double left = uniform(engine) * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    if (left < weights[i]) return i;
    left -= weights[i];
  }
  return weights.size() - 1;
}

/// How one visit lists its star: from arm `first`, each local-path under a name of its own.
struct Listing {
  Star star;
  std::size_t first = 0;

  std::size_t position(std::size_t arm) const { return (arm + star.size() - first) % star.size(); }
};

Listing disguise(const Star& star, RandomEngine& engine) {
  const std::size_t size = star.size();
  const std::size_t first = below(size, engine);
  std::vector<std::string> names;
  for (char name = 'a'; names.size() < size / 2; ++name) names.emplace_back(1, name);
  for (std::size_t i = names.size(); i > 1; --i) std::swap(names[i - 1], names[below(i, engine)]);
  std::vector<Arm> arms(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t opposite = (star.opposite(star.clockwise(first, i)) + size - first) % size;
    arms[i].has_gateway = star.has_gateway(star.clockwise(first, i));
    if (opposite < i) continue;
    const bool is_swapped = chance(0.5, engine);
    arms[i].label = arms[opposite].label = names.back();
    arms[i].sign = is_swapped ? '-' : '+';
    arms[opposite].sign = is_swapped ? '+' : '-';
    names.pop_back();
  }
  return {Star(std::move(arms)), first};
}

}  // namespace

Route random_route(const World& world, const WalkOptions& options, RandomEngine& engine) {
  Route route{PlaceId(below(world.places.size(), engine)), {}};
  const std::size_t arms = world.places[route.start.index()].star.size();
  PlaceArm facing_away{route.start, below(arms, engine)};
  std::set<PlaceArm> used;
  for (std::size_t k = 0; k < options.travels; ++k) {
    const std::vector<PlaceArm> ways = ways_on(world, facing_away);
    std::size_t choice = 0;
    if (options.policy == Policy::explore) {
      std::vector<double> weights;
      for (const PlaceArm& way : ways) {
        const bool is_back = k > 0 && way == facing_away;
        weights.push_back(is_back ? options.turn_around
                                  : (used.contains(way) ? 1.0 : options.unexplored));
      }
      choice = weighted(weights, engine);
    }
    route.gateways.push_back(ways[choice]);
    facing_away = world.segments.at(ways[choice]);
    used.insert({ways[choice], facing_away});
  }
  return route;
}

Route route_through(const World& world, std::span<const PlaceId> places) {
  if (places.empty()) throw std::invalid_argument("found no places; expected at least one");
  Route route{places.front(), {}};
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const auto joins = [&](const auto& segment) {
      return segment.first.place == places[k] && segment.second.place == places[k + 1];
    };
    const auto segment = std::find_if(world.segments.begin(), world.segments.end(), joins);
    if (segment == world.segments.end())
      throw std::invalid_argument("found no segment from place " +
                                  std::to_string(places[k].index()) + " to place " +
                                  std::to_string(places[k + 1].index()) + "; expected one");
    route.gateways.push_back(segment->first);
  }
  return route;
}

Walk walk_along(const World& world, const Route& route, bool disguised, RandomEngine& engine) {
  Walk result;
  std::map<PlaceId, std::pair<PlaceId, std::size_t>> known;  ///< number and first arm listed
  std::optional<PlaceArm> entered;
  for (std::size_t k = 0; k <= route.gateways.size(); ++k) {
    const PlaceId place = entered ? entered->place : route.start;
    const Star& star = world.places[place.index()].star;
    const Listing seen = disguised ? disguise(star, engine) : Listing{star};
    Visit visit{.star = seen.star};
    visit.true_place = std::to_string(place.index());

    const auto [number, first_arm] =
        known.emplace(place, std::pair(PlaceId(known.size()), seen.first)).first->second;
    Arrival arrival{number, {}};
    if (entered) {
      visit.entered_by = seen.position(entered->arm);
      arrival.entered = (entered->arm + star.size() - first_arm) % star.size();
    }
    if (k < route.gateways.size()) {
      visit.left_by = seen.position(route.gateways[k].arm);
      entered = world.segments.at(route.gateways[k]);
    }
    result.trace.visits.push_back(std::move(visit));
    result.truth.push_back(arrival);
  }
  return result;
}

Walk walk(const World& world, const WalkOptions& options, RandomEngine& engine) {
  const Route route = random_route(world, options, engine);
  return walk_along(world, route, options.disguised, engine);
}

}  // namespace asterism
