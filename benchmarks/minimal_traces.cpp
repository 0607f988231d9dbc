#include "benchmarks/minimal_traces.hpp"

#include <fmt/format.h>

#include <cmath>

#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"

namespace asterism {
namespace {

World world_of(const GrowingWalk& walk, RandomEngine& engine) {
  if (walk.in == GrowingWalk::In::grid)
    return grid_world({.width = walk.size, .height = walk.size, .missing = 0, .stubs = 0}, engine);
  const CorridorOptions usual;
  const double area = static_cast<double>(walk.size) / static_cast<double>(usual.corridors);
  return corridor_world(
      {.corridors = walk.size, .side_m = usual.side_m * std::sqrt(area), .min_places = walk.size},
      engine);
}

}  // namespace

Trace make_trace(const GrowingWalk& growing, std::uint64_t seed) {
  RandomEngine engine(seed);
  const World world = world_of(growing, engine);
  Trace trace = walk(world, {.travels = growing.travels}, engine).trace;
  trace.name = growing.in == GrowingWalk::In::grid
                   ? fmt::format("{0} × {0}, {1} travels", growing.size, growing.travels)
                   : fmt::format("{} corridors, {} travels", growing.size, growing.travels);
  return trace;
}

}  // namespace asterism
