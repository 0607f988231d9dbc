#include "drawing/quarter_turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "drawing/plane_drawing.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/drawing/drawing_check.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

using Points = std::vector<MapDrawing::Point>;

/// The points turned, stretched and moved.
Points laid_out(Points points, double turn_rad, double scale, MapDrawing::Point by) {
  for (MapDrawing::Point& point : points)
    point = {by.x + scale * (std::cos(turn_rad) * point.x - std::sin(turn_rad) * point.y),
             by.y + scale * (std::sin(turn_rad) * point.x + std::cos(turn_rad) * point.y)};
  return points;
}

double apart(const Points& one, const Points& other) {
  REQUIRE(one.size() == other.size());
  double most = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    most = std::max(most, std::hypot(one[i].x - other[i].x, one[i].y - other[i].y));
  return most;
}

}  // namespace

TEST_CASE("a drawing is turned the way its places lie, and not mirrored", "[planarity][property]") {
  RandomEngine random(1);
  for (int round = 0; round < 100; ++round) {
    const World world = grid_world({.width = 4, .height = 3}, random);
    const Walk seen = walk(world, {.travels = 4 + random() % 30}, random);
    const TopologicalMap map = make_map(seen.trace, seen.truth);
    const MapDrawing drawing = draw(map);
    const std::size_t turns = random() % 4;
    const double turn_rad = static_cast<double>(turns) * std::numbers::pi / 2;
    // Less than an eighth off, anywhere, of any size.
    const Points as =
        laid_out(drawing.places, turn_rad + between(-0.7, 0.7, random), between(0.1, 50, random),
                 {between(-99, 99, random), between(-99, 99, random)});
    const MapDrawing other = turned(drawing, as);
    const auto expected = [&](const Points& points) {
      return map.places.size() > 1 ? laid_out(points, turn_rad, 1, {}) : points;
    };
    CHECK(apart(other.places, expected(drawing.places)) < 1e-9);
    for (std::size_t i = 0; i < drawing.segments.size(); ++i)
      CHECK(apart(other.segments[i], expected(drawing.segments[i])) < 1e-9);
    for (std::size_t p = 0; p < drawing.arms.size(); ++p)
      CHECK(apart(other.arms[p], expected(drawing.arms[p])) < 1e-9);
    CHECK(fault_of_stars(map, other) == "");
  }
}

TEST_CASE("a drawing is turned by a point a place", "[planarity]") {
  MapDrawing drawing;
  drawing.places = {{0, 0}, {1, 0}};
  CHECK_THROWS_AS(turned(drawing, {{0, 0}}), std::invalid_argument);
  CHECK(apart(turned(drawing, {{5, 5}, {5, 7}}).places, {{0, 0}, {0, 1}}) == 0);
  CHECK(apart(turned(drawing, {{5, 5}, {5, 5}}).places, drawing.places) == 0);
}

}  // namespace asterism
