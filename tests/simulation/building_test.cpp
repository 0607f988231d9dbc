#include "simulation/building.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/office_building.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/ring_building.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

constexpr double rounding = 1e-9;  ///< metres or radians, after some turning

/// Within a share of what is expected.
bool is_near(double value, double expected, double share = 1e-6) {
  return std::abs(value - expected) <= share * std::abs(expected);
}

double length_m(const std::vector<Wall>& walls) {
  double result = 0;
  for (const Wall& wall : walls) result += norm(wall.to - wall.from);
  return result;
}

Building seeded_building(unsigned seed, RandomEngine& engine) {
  if (seed % 10 == 0) return ring_building(engine);
  return office_building({}, engine);
}

/// Each arm is clockwise of the one before it, once round in all, and opposite arms lead apart.
void check_headings(const Building& building) {
  for (std::size_t i = 0; i < building.world.places.size(); ++i) {
    const Star& star = building.world.places[i].star;
    const auto headings_rad = arm_headings_rad(building.world, PlaceId(i));
    double turned_rad = 0;
    for (std::size_t arm = 0; arm < star.size(); ++arm) {
      const double step_rad = headings_rad[arm] - headings_rad[star.clockwise(arm, 1)];
      turned_rad += step_rad - 2 * std::numbers::pi * std::floor(step_rad / (2 * std::numbers::pi));
      const double apart_rad = headings_rad[arm] - headings_rad[star.opposite(arm)];
      CHECK(std::abs(std::abs(wrapped(apart_rad)) - std::numbers::pi) < rounding);
    }
    CHECK(std::abs(turned_rad - 2 * std::numbers::pi) < rounding);
  }
}

/// A gateway leads to the next place or beyond a local map; what is none is seen to its end.
void check_openings(const Building& building) {
  constexpr double local_map_m = 15;  // from its middle to its edge
  const RayCaster walls(building.walls);
  for (std::size_t i = 0; i < building.world.places.size(); ++i) {
    const auto& [position, star] = building.world.places[i];
    const auto headings_rad = arm_headings_rad(building.world, PlaceId(i));
    for (std::size_t arm = 0; arm < star.size(); ++arm) {
      const auto hit = walls.cast(position, unit_vector(headings_rad[arm]), 200);
      REQUIRE(hit.has_value());
      const auto segment = building.world.segments.find({PlaceId(i), arm});
      if (segment != building.world.segments.end()) {
        const PlaceId reached = segment->second.place;
        CHECK(hit->distance_m > norm(building.world.places[reached.index()].position - position));
      } else if (star.has_gateway(arm)) {
        CHECK(hit->distance_m > local_map_m);
      } else {
        CHECK(hit->distance_m < 10);
      }
    }
  }
}

}  // namespace

//     +-----+
//   +-|.....|---+
//   | |     |   |     the dotted lines lie inside the other rectangle
//   +-|.....|---+
//     +-----+
TEST_CASE("rooms that overlap are one", "[simulation]") {
  FloorPlan plan;
  plan.rooms = {rectangle({0, 0}, {10, 0}, 2), rectangle({4, -3}, {4, 3}, 2)};
  constexpr double outline_m = 2 * 10 + 2 * 2 + 2 * 6 + 2 * 2 - 4 * 2;
  CHECK(std::abs(length_m(walls_of(plan)) - outline_m) < 1e-6);
  const RayCaster walls(walls_of(plan));
  CHECK(is_near(walls.cast({1, 0}, {1, 0}, 50)->distance_m, 9));
  CHECK(is_near(walls.cast({4, 0}, {0, 1}, 50)->distance_m, 3));

  plan.furniture = {disc({8, 0}, 0.5, 48)};
  plan.panes = {{{2, -1}, {2, 1}}};
  const RayCaster furnished(walls_of(plan));
  CHECK(is_near(furnished.cast({6, 0}, {1, 0}, 50)->distance_m, 1.5));
  CHECK(furnished.cast({1, 0}, {1, 0}, 50)->is_glass);
}

TEST_CASE("polygons overlap where they share inner points", "[simulation]") {
  const Polygon square = rectangle({0, 0}, {2, 0}, 2);
  CHECK(overlap(square, rectangle({1, 0}, {5, 0}, 0.1)));
  CHECK(overlap(square, rectangle({0.5, 0}, {1, 0}, 0.1)));
  CHECK_FALSE(overlap(square, rectangle({2, 0}, {5, 0}, 2)));  // one side in common
  CHECK_FALSE(overlap(square, disc({3, 2}, 1.3)));
  CHECK(overlap(square, disc({3, 2}, 1.5)));
}

TEST_CASE("a building's openings are the arms of its stars, clockwise", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 150U));
  RandomEngine engine(seed);
  const Building building = seeded_building(seed, engine);
  check_headings(building);
  check_openings(building);
  const Building turned = moved(building, {between(-50, 50, engine), 8, between(-4, 4, engine)});
  check_headings(turned);
  check_openings(turned);
  check_headings(mirrored(turned));
  check_openings(mirrored(turned));
}

TEST_CASE("from place to place there are 8 m of corridor, and room to pass",
          "[simulation][property]") {
  const auto seed = GENERATE(range(1U, 60U));
  RandomEngine engine(seed);
  const OfficeOptions options;
  const Building building = office_building(options, engine);
  const RayCaster walls(building.walls);
  for (const auto& [gateway, reached] : building.world.segments) {
    const Point2 from = building.world.places[gateway.place.index()].position;
    const Point2 way = building.world.places[reached.place.index()].position - from;
    const Point2 along = unit_towards({}, way);
    const Point2 left = left_of(along);
    int narrow = 0;  // points where the corridor runs, 0.1 m apart
    for (double at_m = 0; at_m < norm(way); at_m += 0.1) {
      const Point2 point = from + at_m * along;
      const double wide_m = walls.cast(point, left, 100)->distance_m +
                            walls.cast(point, -1.0 * left, 100)->distance_m;
      CHECK(wide_m >= options.furnish.min_clear_m - rounding);
      if (wide_m < options.max_width_m + 0.7) ++narrow;
    }
    CHECK(narrow >= 70);  // open doors let some beams pass
  }
}

TEST_CASE("a mirror reverses stars, two leave the building as it was", "[simulation][property]") {
  const auto seed = GENERATE(range(0U, 30U));
  RandomEngine engine(seed);
  const Building building = seeded_building(seed, engine);
  const Building mirror = mirrored(building);
  const Building again = mirrored(mirror);
  for (std::size_t i = 0; i < building.world.places.size(); ++i) {
    const auto& [position, star] = building.world.places[i];
    const auto& [mirror_position, mirror_star] = mirror.world.places[i];
    CHECK(again.world.places[i].star == star);
    CHECK(again.world.places[i].position == position);
    CHECK(mirror_position.y_m == -position.y_m);
    for (std::size_t arm = 0; arm < star.size(); ++arm)
      CHECK(mirror_star.arm(star.size() - 1 - arm) == star.arm(arm));
  }
  CHECK(again.world.segments == building.world.segments);
  CHECK(length_m(mirror.walls) == length_m(building.walls));
}

TEST_CASE("the ring has the stars it is drawn with", "[simulation]") {
  RandomEngine engine(1);
  const World world = ring_building(engine).world;
  REQUIRE(world.places.size() == 9);
  std::vector<std::string> stars;
  for (const World::Place& place : world.places) stars.push_back(place.star.text());
  CHECK(stars == std::vector<std::string>{
                     "up+0 top+1 up-1 top-1", "right+0 top+1 right-1 top-1",
                     "right+1 across+0 right-1 across-1", "right+1 bottom+0 right-0 bottom-1",
                     "up+1 bottom+1 up-0 bottom-1", "left+1 bottom+1 left-0 bottom-0",
                     "left+1 across+1 left-1 across-0", "left+0 top+1 left-1 top-1",
                     "up+1 across+1 up-1 across-1"});
  CHECK(world.segments.size() == 24);
}

TEST_CASE("an office whose corridors would be too short is refused", "[simulation]") {
  RandomEngine engine(1);
  CHECK_THROWS_AS(office_building({.min_pitch_m = 10}, engine), std::invalid_argument);
}
