#include "engine/minimal_search.hpp"

#include "engine/map_tree.hpp"
#include "engine/minimal_models.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

std::vector<std::vector<Arrival>> listed(const Trace& trace, bool planar) {
  MapTree tree({.planar = planar});
  tree.extend(trace.visits);
  return minimal_models(tree);
}

std::vector<std::vector<Arrival>> searched(const Trace& trace, bool planar) {
  MinimalSearch search({.planar = planar});
  search.extend(trace.visits);
  REQUIRE(search.run() == MinimalSearch::Outcome::complete);
  return search.models();
}

TEST_CASE("the search finds the minimal models that the tree lists", "[engine][property]") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomEngine engine(seed);
    const World world = seed % 2 == 0 ? grid_world({.width = 3 + seed % 3, .height = 3}, engine)
                                      : corridor_world({.corridors = 5 + seed % 4}, engine);
    const Trace trace = walk(world, {.travels = 8 + seed % 9}, engine).trace;
    for (const bool planar : {false, true}) {
      CAPTURE(seed, planar);
      CHECK(searched(trace, planar) == listed(trace, planar));
    }
  }
}

}  // namespace
}  // namespace asterism
