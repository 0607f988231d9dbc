#include "benchmarks/traces.hpp"

#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"

namespace asterism {

Trace make_trace(const BenchmarkTrace& benchmark) {
  RandomEngine engine(benchmark.seed);
  const World world = grid_world({.width = 4, .height = 4, .missing = 0.1, .stubs = 0.1}, engine);
  Trace trace = walk(world, {.travels = benchmark.travels}, engine).trace;
  trace.name = benchmark.name;
  return trace;
}

}  // namespace asterism
