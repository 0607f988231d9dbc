#include "simulation/walk.hpp"

#include <algorithm>

#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

World random_world(unsigned seed, RandomEngine& engine) {
  if (seed % 2 == 0) return grid_world({}, engine);
  return corridor_world({}, engine);
}

std::vector<std::string> places(const Walk& walk) {
  std::vector<std::string> result;
  for (const Visit& visit : walk.trace.visits) result.push_back(visit.true_place.value());
  return result;
}

}  // namespace

TEST_CASE("the true map explains the walk, and is planar", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 500U));
  const auto policy = GENERATE(Policy::explore, Policy::laps);
  RandomEngine engine(seed);
  const World world = random_world(seed, engine);
  const Walk walked = walk(world, {.travels = 25, .policy = policy}, engine);
  CHECK_NOTHROW(require_valid(walked.trace));
  CHECK(walked.trace.visits.size() == 26);
  CHECK(is_consistent(walked.trace, walked.truth, {.planar = true}));
  CHECK(make_map(walked.trace, walked.truth).places.size() <= world.places.size());
}

TEST_CASE("the true map is among the maps of a walk", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 100U));
  RandomEngine engine(seed);
  const World world = random_world(seed, engine);
  const Walk walked = walk(world, {.travels = 8}, engine);
  const auto maps = every_map_by_visit(walked.trace, {.planar = true}).back();
  CHECK(std::binary_search(maps.begin(), maps.end(), walked.truth));
}

TEST_CASE("a disguise changes neither the walk nor the number of maps", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 100U));
  RandomEngine engine(seed);
  const World world = random_world(seed, engine);
  RandomEngine one = engine;
  RandomEngine other = engine;
  const Walk plain = walk(world, {.travels = 8, .disguised = false}, one);
  const Walk disguised = walk(world, {.travels = 8}, other);
  CHECK(places(plain) == places(disguised));
  CHECK(every_map_by_visit(plain.trace).back().size() ==
        every_map_by_visit(disguised.trace).back().size());
}

TEST_CASE("a walk is the same for the same seed, everywhere", "[simulation]") {
  RandomEngine engine(7);
  const World world = grid_world({}, engine);
  const Walk walked = walk(world, {.travels = 3}, engine);
  CHECK(places(walked) == std::vector<std::string>{"5", "4", "3", "7"});
  CHECK(walked.trace.visits.front().star.text() == "a+1 b+0 a-0 b-1");
}

//  0 - 1 - 2
//  |   |   |       laps go round the face of the first travel, clockwise by the outer one
//  3 - 4 - 5
TEST_CASE("laps go round one face", "[simulation]") {
  RandomEngine engine(GENERATE(range(0U, 20U)));
  const World world = grid_world({.width = 3, .height = 2, .missing = 0, .stubs = 0}, engine);
  const Walk walked = walk(world, {.travels = 24, .policy = Policy::laps}, engine);
  const auto visited = places(walked);
  const bool by_fours = std::equal(visited.begin() + 4, visited.end(), visited.begin());
  const bool by_sixes = std::equal(visited.begin() + 6, visited.end(), visited.begin());
  CHECK((by_fours || by_sixes));
}

TEST_CASE("a walk through given places visits them", "[simulation]") {
  RandomEngine engine(1);
  const World world = grid_world({.width = 2, .height = 2, .missing = 0, .stubs = 0}, engine);
  const std::vector<PlaceId> square{PlaceId(0), PlaceId(1), PlaceId(3), PlaceId(2), PlaceId(0)};
  const Walk walked = walk_along(world, route_through(world, square), false, engine);
  CHECK(places(walked) == std::vector<std::string>{"0", "1", "3", "2", "0"});
  CHECK(walked.truth.back() == Arrival{PlaceId(0), 2});
  CHECK(walked.truth[2] == Arrival{PlaceId(2), 0});

  const std::vector<PlaceId> diagonal{PlaceId(0), PlaceId(3)};
  CHECK_THROWS_AS(route_through(world, diagonal), std::invalid_argument);
  CHECK_THROWS_AS(route_through(world, {}), std::invalid_argument);
}
