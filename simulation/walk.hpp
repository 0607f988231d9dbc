#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "core/random.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// How a walk goes on from a place. It never enters a blind stub.
enum class Policy {
  explore,  ///< at random, preferring gateways not used before and going on to turning round
  laps      ///< by the next gateway clockwise after the one entered by: round one face
};

struct WalkOptions {
  std::size_t travels = 20;
  Policy policy = Policy::explore;
  double unexplored = 4;     ///< weight of a gateway not used before, against 1
  double turn_around = 0.1;  ///< weight of the gateway entered by, against 1
  bool disguised = true;     ///< stars read from a random arm, with labels and signs of no meaning
};

/// A trace and the true data association, places numbered by first visit. The true map is
/// make_map(trace, truth).
struct Walk {
  Trace trace;  ///< true_place: the place's number in the world
  std::vector<Arrival> truth;
};

/// Walks from a random place. The first visit does not say how it was entered.
/// @pre  the world has segments
Walk walk(const World& world, const WalkOptions& options, RandomEngine& engine);

/// Visits the given places in order.
/// @throws std::invalid_argument if two that follow one another are not joined by a segment
Walk walk_through(const World& world, std::span<const PlaceId> places, bool disguised,
                  RandomEngine& engine);

}  // namespace asterism
