#include <algorithm>

#include "tests/engine/seeded_walk.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

const std::vector<std::string> optional_axioms{"", "one_segment", "one_crossing"};

BruteForceOptions brute_force(bool planar, const std::string& optional) {
  return {.planar = planar,
          .one_segment = optional == "one_segment",
          .one_crossing = optional == "one_crossing"};
}

MapTree::Options options(bool planar, const std::string& optional, Check check) {
  return {.theory = {.axioms = shipped_with(optional), .planar = planar}, .check = check};
}

}  // namespace

TEST_CASE("the tree holds the maps of all partitions and arms, tested whole",
          "[engine][reference][property]") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 3 + seed % 2).trace;
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true})
      CHECK(maps_of(tree_of(trace, planar)) == every_map(trace, {.planar = planar}));
  }
}

TEST_CASE("the tree holds the maps of brute force after every visit",
          "[engine][reference][property]") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = seeded_walk(seed, 5 + seed % 5).trace;
    INFO(to_keep(seed, trace));
    for (const bool planar : {false, true})
      for (const std::string& optional : optional_axioms) {
        INFO((planar ? "planar " : "all ") << optional);
        const auto levels = every_map_by_visit(trace, brute_force(planar, optional));
        const MapTree tree = tree_of(trace, options(planar, optional, Check::native));
        CHECK(maps_of(tree) == levels.back());
        std::vector<std::uint64_t> sizes;
        for (const auto& level : levels) sizes.push_back(level.size());
        CHECK(std::equal(sizes.begin(), sizes.end(), tree.per_visit().begin(),
                         tree.per_visit().end()));
      }
  }
}

TEST_CASE("an optional axiom leaves a part of the maps", "[engine][axioms][property]") {
  std::size_t dropped = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const Trace trace = seeded_walk(seed, 6 + seed % 7).trace;
    INFO(to_keep(seed, trace));
    const bool planar = seed % 2 == 0;
    const auto shipped = maps_of(tree_of(trace, planar));
    for (const char* const optional : {"one_segment", "one_crossing"}) {
      const auto fewer = maps_of(tree_of(trace, options(planar, optional, Check::native)));
      CHECK(std::includes(shipped.begin(), shipped.end(), fewer.begin(), fewer.end()));
      dropped += shipped.size() - fewer.size();
    }
  }
  CHECK(dropped > 50);
}
