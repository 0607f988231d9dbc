#include "mapping/random_traces.hpp"

#include <fmt/format.h>

#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/ring_building.hpp"
#include "simulation/walk.hpp"

namespace asterism {
namespace {

World random_world(std::uint64_t seed, RandomEngine& engine) {
  switch (seed % 4) {
    case 0:
      return corridor_world({.corridors = 8, .ends_crossing = 0.6, .ends_blind = 0.3}, engine);
    case 1:
      return grid_world({.width = 3, .height = 2, .missing = 0.1, .stubs = 0.3}, engine);
    case 2:
      return grid_world({.width = 3, .height = 3}, engine);
    default:
      return corridor_world({}, engine);
  }
}

}  // namespace

Trace random_trace(std::uint64_t seed) {
  RandomEngine engine(seed);
  const World world = random_world(seed, engine);
  const Policy policy = seed % 7 == 0 ? Policy::laps : Policy::explore;
  const std::size_t travels = 4 + seed % 5;
  Trace trace =
      walk(world, {.travels = travels, .policy = policy, .turn_around = 0.3}, engine).trace;
  trace.name = fmt::format("random-world-{}", seed);
  return trace;
}

Trace ring_trace() {
  RandomEngine engine(0);  // of furniture, which no star shows
  const World ring = ring_building(engine).world;
  Trace trace = walk_along(ring, ring_route(ring), false, engine).trace;
  trace.name = "aces-like";
  return trace;
}

}  // namespace asterism
