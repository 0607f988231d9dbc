#include "planarity/euler.hpp"

#include <set>

#include "planarity/boyer_myrvold.hpp"
#include "tests/planarity/random_map.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {
PlaceArm gateway(std::size_t place, std::size_t arm) { return {PlaceId(place), arm}; }

/// Places without visits or paths: planarity asks for no more.
TopologicalMap map_of(std::size_t place_count, const std::string& star,
                      std::vector<TopologicalMap::Segment> segments) {
  TopologicalMap map;
  for (std::size_t p = 0; p < place_count; ++p)
    map.places.push_back({Star::parse(star), VisitId(p)});
  map.segments = std::move(segments);
  return map;
}

//  0 --- 1      arms north, east, south, west
//  |     |
//  3 --- 2
TopologicalMap square() {
  return map_of(4, "v+1 h+1 v-1 h-1",
                {{gateway(0, 1), gateway(1, 3)},
                 {gateway(0, 2), gateway(3, 0)},
                 {gateway(1, 2), gateway(2, 0)},
                 {gateway(2, 3), gateway(3, 1)}});
}
}  // namespace

TEST_CASE("a square has an inside and an outside", "[planarity]") {
  const std::vector<std::vector<PlaceArm>> expected{
      {gateway(0, 1), gateway(1, 2), gateway(2, 3), gateway(3, 0)},
      {gateway(0, 2), gateway(3, 1), gateway(2, 0), gateway(1, 3)}};
  CHECK(faces(square()) == expected);
  CHECK(is_planar(square()));
}

TEST_CASE("a map without segments is planar and has no faces to walk round", "[planarity]") {
  const TopologicalMap lone = map_of(1, "a+1 a-0", {});
  CHECK(faces(lone).empty());
  CHECK(is_planar(lone));
}

//  0 === 1      two segments that leave both places clockwise in the same order would have to cross
TEST_CASE("the order of the stars decides, not the graph alone", "[planarity]") {
  const std::string cross = "v+1 h+1 v-1 h-1";
  const TopologicalMap nested = map_of(2, cross,
                                       {{gateway(0, 0), gateway(1, 1)},
                                        {gateway(0, 1), gateway(1, 0)},
                                        {gateway(0, 2), gateway(1, 3)}});
  const TopologicalMap twisted = map_of(2, cross,
                                        {{gateway(0, 0), gateway(1, 0)},
                                         {gateway(0, 1), gateway(1, 1)},
                                         {gateway(0, 2), gateway(1, 2)}});
  CHECK(is_planar(nested));
  CHECK_FALSE(is_planar(twisted));
  CHECK(is_planar_graph(twisted));
}

TEST_CASE("five places, each joined to each, are planar in no order", "[planarity]") {
  std::vector<TopologicalMap::Segment> all;
  for (std::size_t p = 0; p < 5; ++p)
    for (std::size_t q = p + 1; q < 5; ++q) all.push_back({gateway(p, q - 1), gateway(q, p)});
  const TopologicalMap map = map_of(5, "v+1 h+1 v-1 h-1", all);
  CHECK_FALSE(is_planar(map));
  CHECK_FALSE(is_planar_graph(map));
}

TEST_CASE("planar with its stars is planar without them; each gateway has one face",
          "[planarity][property]") {
  std::size_t rejected = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const TopologicalMap map =
        random_map(seed, {.most_places = 12, .most_local_paths = 3, .is_planar = seed % 2 == 0});
    CAPTURE(seed);
    if (!is_planar(map)) ++rejected;
    CHECK((!is_planar(map) || is_planar_graph(map)));
    std::size_t steps = 0;
    std::set<PlaceArm> seen;
    for (const auto& face : faces(map)) {
      steps += face.size();
      seen.insert(face.begin(), face.end());
    }
    CHECK(steps == 2 * map.segments.size());
    CHECK(seen.size() == steps);
  }
  CHECK(rejected > 50);
}
