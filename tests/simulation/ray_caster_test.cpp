#include "simulation/ray_caster.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "core/random.hpp"
#include "simulation/office_building.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

/// Distances are metres, computed in two ways from coordinates below 100 m.
constexpr double tolerance_m = 1e-7;

/// The nearest wall on a beam, wall by wall: each end's angle off the beam says whether it is met,
/// the ratio of their distances from the beam where.
std::optional<double> nearest_m(const std::vector<Wall>& walls, Point2 from, Point2 direction,
                                double max_m) {
  std::optional<double> best;
  for (const Wall& wall : walls) {
    const double a_aside_m = cross(direction, wall.from - from);
    const double b_aside_m = cross(direction, wall.to - from);
    if (a_aside_m * b_aside_m > 0 || a_aside_m == b_aside_m) continue;
    const double share = a_aside_m / (a_aside_m - b_aside_m);
    const Point2 met = wall.from + share * (wall.to - wall.from);
    const double along_m = dot(met - from, direction);
    if (along_m >= 0 && along_m <= max_m && (!best || along_m < *best)) best = along_m;
  }
  return best;
}

void check_beam(const RayCaster& caster, const std::vector<Wall>& walls, Point2 from,
                double heading_rad, double max_m) {
  const Point2 direction = unit_vector(heading_rad);
  const auto hit = caster.cast(from, direction, max_m);
  const auto expected = nearest_m(walls, from, direction, max_m);
  INFO("from " << from.x_m << ' ' << from.y_m << " heading " << heading_rad);
  REQUIRE(hit.has_value() == expected.has_value());
  if (hit) CHECK(std::abs(hit->distance_m - *expected) < tolerance_m);
}

}  // namespace

TEST_CASE("a beam ends at the nearest of all walls", "[simulation][laser][property]") {
  const auto seed = GENERATE(range(0U, 20U));
  RandomEngine engine(seed);
  std::vector<Wall> walls;
  for (int i = 0; i < 150; ++i) {
    const Point2 from{between(-20, 20, engine), between(-20, 20, engine)};
    const double length_m = chance(0.2, engine) ? 25 : between(0.05, 4, engine);
    const double heading_rad = between(0, 2 * std::numbers::pi, engine);
    walls.push_back({from, from + length_m * unit_vector(heading_rad)});
  }
  const RayCaster caster(walls);
  for (int i = 0; i < 500; ++i) {  // from outside the walls, too
    const Point2 from{between(-40, 40, engine), between(-40, 40, engine)};
    const double heading_rad = between(-4, 4, engine);
    check_beam(caster, walls, from, heading_rad, chance(0.5, engine) ? 100 : 6);
  }
}

TEST_CASE("beams along the axes and along cells are cast like any other", "[simulation][laser]") {
  const std::vector<Wall> walls{
      {{0, 0}, {4, 0}}, {{4, 0}, {4, 3}}, {{4, 3}, {0, 3}}, {{0, 3}, {0, 0}}};
  const RayCaster caster(walls);
  for (const double x_m : {0.5, 1.0, 2.0, 3.5}) {
    for (const double y_m : {0.5, 1.0, 2.0}) {
      const auto range_m = [&](Point2 way) { return caster.cast({x_m, y_m}, way, 10)->distance_m; };
      CHECK(range_m({1, 0}) == 4 - x_m);
      CHECK(range_m({-1, 0}) == x_m);
      CHECK(range_m({0, 1}) == 3 - y_m);
      CHECK(range_m({0, -1}) == y_m);
    }
  }
  CHECK_FALSE(caster.cast({1, 1}, {1, 0}, 2.9).has_value());
  CHECK_FALSE(caster.cast({-1, 1}, {-1, 0}, 10).has_value());
  CHECK(caster.cast({-1, 1}, {1, 0}, 10)->distance_m == 1);
}

TEST_CASE("no beam leaves a building, however it is turned", "[simulation][laser][property]") {
  const auto seed = GENERATE(range(0U, 20U));
  RandomEngine engine(seed);
  const Building building = moved(office_building({}, engine), {3, -7, between(-4, 4, engine)});
  const RayCaster caster(building.walls);
  for (const World::Place& place : building.world.places)
    for (int i = 0; i < 200; ++i) {
      const Point2 from = place.position + 0.5 * unit_vector(i);
      const double heading_rad = between(-4, 4, engine);
      check_beam(caster, building.walls, from, heading_rad, 200);
      CHECK(caster.cast(from, unit_vector(heading_rad), 200).has_value());
    }
}

TEST_CASE("nothing is hit where there are no walls", "[simulation][laser]") {
  CHECK_FALSE(RayCaster({}).cast({0, 0}, {1, 0}, 100).has_value());
}
