#include "simulation/world.hpp"

#include <set>

#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

//     0---1---2---3        h: 0 1 2 3, beyond 3 a blind stub
//         |                v: 4 1, from south to north
//         4
TEST_CASE("a place is where corridors cross, bend or end", "[simulation]") {
  const World world = make_world({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, -1}},
                                 {{"h", {1, 0}, {0, 1, 2, 3}, false, true},  //
                                  {"v", {0, 1}, {4, 1}}});
  REQUIRE(world.places.size() == 3);  // 2 and 3 are passed straight through
  CHECK(world.places[0].star == Star::parse("h+1 h-0"));
  CHECK(world.places[1].star == Star::parse("v+0 h+1 v-1 h-1"));
  CHECK(world.places[2].star == Star::parse("v+1 v-0"));
  const PlaceArm stub{PlaceId(1), 1};
  CHECK_FALSE(world.segments.contains(stub));
  CHECK(world.segments.size() == 4);
  CHECK(world.segments.at({PlaceId(0), 0}) == PlaceArm{PlaceId(1), 3});
}

//     0---1
//         |
//     3---2
TEST_CASE("where two corridors end in one corner, both have an arm without gateway",
          "[simulation]") {
  const World world =
      make_world({{0, 0}, {1, 0}, {1, -1}, {0, -1}},
                 {{"top", {1, 0}, {0, 1}}, {"side", {0, 1}, {2, 1}}, {"bottom", {1, 0}, {3, 2}}});
  REQUIRE(world.places.size() == 4);
  CHECK(world.places[1].star == Star::parse("side+0 top+0 side-1 top-1"));
  CHECK(world.places[2].star == Star::parse("side+1 bottom+0 side-0 bottom-1"));
}

TEST_CASE("arms stand clockwise whatever the angle", "[simulation]") {
  const World world = make_world({{0, 0}, {1, 3}, {-1, -3}, {3, -1}, {-3, 1}},
                                 {{"steep", {1, 3}, {2, 0, 1}}, {"flat", {3, -1}, {4, 0, 3}}});
  CHECK(world.places.front().star == Star::parse("steep+1 flat+1 steep-1 flat-1"));
}

TEST_CASE("of separate parts the largest stays", "[simulation]") {
  const World world =
      make_world({{0, 0}, {1, 0}, {0, 5}, {1, 5}, {1, 6}},
                 {{"a", {1, 0}, {0, 1}}, {"b", {1, 0}, {2, 3}}, {"c", {0, 1}, {3, 4}}});
  REQUIRE(world.places.size() == 3);
  CHECK(world.places.front().position.y_m == 5);
}

TEST_CASE("a whole grid has a place at every point but on its rim's sides", "[simulation]") {
  RandomEngine engine(1);
  const World world = grid_world({.width = 3, .height = 3, .missing = 0, .stubs = 0}, engine);
  REQUIRE(world.places.size() == 9);
  CHECK(world.segments.size() == 24);
  CHECK(world.places[0].star == Star::parse("v+0 h+1 v-1 h-0"));
  CHECK(world.places[4].star == Star::parse("v+1 h+1 v-1 h-1"));
  CHECK(world.places[5].star == Star::parse("v+1 h+0 v-1 h-1"));
}

namespace {

void check_world(const World& world) {
  CHECK(paths_are_straight(world));
  CHECK(world.segments.size() >= 2);
  std::set<PlaceId> joined;
  for (const auto& [gateway, reached] : world.segments) {
    joined.insert(gateway.place);
    CHECK(world.segments.at(reached) == gateway);
    CHECK(gateway.place != reached.place);
    CHECK(world.places.at(gateway.place.index()).star.has_gateway(gateway.arm));
  }
  CHECK(joined.size() == world.places.size());
  for (const auto& place : world.places) {
    std::size_t gateways = 0;
    for (std::size_t arm = 0; arm < place.star.size(); ++arm)
      if (place.star.has_gateway(arm)) ++gateways;
    const bool is_passed_straight = place.star.size() == 2 && gateways == 2;
    CHECK_FALSE(is_passed_straight);
  }
}

}  // namespace

TEST_CASE("a random world is joined up, its paths straight, its places real",
          "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 300U));
  RandomEngine engine(seed);
  check_world(grid_world({.width = 2 + seed % 5, .height = 2 + seed % 4}, engine));
  check_world(corridor_world({.corridors = 3 + seed % 8}, engine));
}

TEST_CASE("a world that cannot be is refused", "[simulation]") {
  RandomEngine engine(1);
  CHECK_THROWS_AS(grid_world({.width = 1, .height = 1}, engine), std::invalid_argument);
  CHECK_THROWS_AS(corridor_world({.corridors = 1}, engine), std::invalid_argument);
}
