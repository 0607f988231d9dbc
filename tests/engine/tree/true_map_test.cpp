#include <algorithm>

#include "planarity/euler.hpp"
#include "simulation/drive.hpp"
#include "simulation/office_building.hpp"
#include "simulation/ring_building.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

bool contains(const std::vector<Association>& sorted, const Association& map) {
  return std::binary_search(sorted.begin(), sorted.end(), map);
}

}  // namespace

TEST_CASE("the true map is never dropped, no map comes twice, planar ones are among all",
          "[engine][property]") {
  for (unsigned seed = 0; seed < 2'000; ++seed) {
    const Walk walked = seeded_walk(seed, 4 + seed % 7);
    INFO(to_keep(seed, walked.trace));
    const auto all = maps_of(tree_of(walked.trace, false));
    const auto planar = maps_of(tree_of(walked.trace, true));
    CHECK(contains(all, walked.truth));
    CHECK(contains(planar, walked.truth));
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
    CHECK(std::adjacent_find(planar.begin(), planar.end()) == planar.end());
    CHECK(std::includes(all.begin(), all.end(), planar.begin(), planar.end()));
  }
}

TEST_CASE("the true map of a long walk is never dropped where it must be planar",
          "[engine][property]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Walk walked = seeded_walk(seed, 13 + seed % 4);
    INFO(to_keep(seed, walked.trace));
    CHECK(contains(maps_of(tree_of(walked.trace, true)), walked.truth));
  }
}

TEST_CASE("the true map of a drive through a building is never dropped", "[engine][property]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    RandomEngine engine(seed);
    const bool is_ring = seed % 10 == 0;
    const Building building = is_ring ? ring_building(engine) : office_building({}, engine);
    const Route route = is_ring ? ring_route(building.world)
                                : random_route(building.world, {.travels = 10}, engine);
    const Drive drive(building, route, {}, seed);
    const auto& [trace, truth] = drive.truth();
    INFO(to_keep(seed, trace));
    CHECK(contains(maps_of(tree_of(trace, false)), truth));
    CHECK(contains(maps_of(tree_of(trace, true)), truth));
    if (is_ring) CHECK(minimal_of(tree_of(trace, true)) == std::vector<Association>{truth});
  }
}

TEST_CASE("the planar maps after each visit are those of all that pass the Euler count",
          "[engine][planarity][property]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 7).trace;
    INFO(to_keep(seed, trace));
    MapTree all({.axioms = shipped_with()});
    MapTree planar({.axioms = shipped_with(), .planar = true});
    for (const Visit& visit : trace.visits) {
      REQUIRE(all.extend(visit) == MapTree::Growth::complete);
      REQUIRE(planar.extend(visit) == MapTree::Growth::complete);
      std::vector<Association> expected = maps_of(all);
      std::erase_if(expected,
                    [&](const Association& map) { return !is_planar(make_map(all.trace(), map)); });
      CHECK(maps_of(planar) == expected);
    }
  }
}

TEST_CASE("a map has half its places' arms less its segments for paths",
          "[engine][preference][property]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 8).trace;
    INFO(to_keep(seed, trace));
    for (const Association& association : maps_of(tree_of(trace, false))) {
      const TopologicalMap map = make_map(trace, association);
      std::size_t arms = 0;
      for (const auto& place : map.places) arms += place.star.size();
      CHECK(map.paths.size() == arms / 2 - map.segments.size());
    }
  }
}
