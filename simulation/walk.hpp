#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// How a walk goes on from a place. It never enters a blind stub.
enum class Policy {
  explore,  ///< at random, preferring gateways not used before and going on to turning round
  laps      ///< by the next gateway clockwise after the one entered by: round one face
};

/// How long a walk is, how it goes on, and what it tells.
struct WalkOptions {
  std::size_t travels = 20;
  Policy policy = Policy::explore;
  double unexplored = 4;     ///< weight of a gateway not used before, against 1
  double turn_around = 0.1;  ///< weight of the gateway entered by, against 1
  bool disguised = true;     ///< stars read from a random arm, with labels and signs of no meaning
};

/// Where to walk.
struct Route {
  PlaceId start;
  std::vector<PlaceArm> gateways;  ///< left by, in order
};

/// A trace and the true data association, places numbered by first visit. The true map is
/// make_map(trace, truth).
struct Walk {
  Trace trace;  ///< true_place: the place's number in the world
  std::vector<Arrival> truth;
};

/// A way from a random place.
/// @pre  the world has segments
Route random_route(const World& world, const WalkOptions& options, RandomEngine& engine);
/// The way to the given places in order.
/// @throws std::invalid_argument if two that follow one another are not joined by a segment
Route route_through(const World& world, std::span<const PlaceId> places);

/// What a robot sees and does that goes this way. The first visit does not say how it was entered.
/// @param disguised  see WalkOptions
Walk walk_along(const World& world, const Route& route, bool disguised, RandomEngine& engine);

/// Walks a random route.
/// @pre  the world has segments
Walk walk(const World& world, const WalkOptions& options, RandomEngine& engine);

}  // namespace asterism
