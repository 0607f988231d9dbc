#include "perception/local_perceptual_map.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/room.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

double log_odds(const Grid& grid, Point2 at) {
  const Cell cell = grid.cell_at(at);
  return grid.contains(cell) ? static_cast<double>(grid.log_odds[grid.index(cell)]) : 0;
}

// One beam straight ahead.
Scan beam(double range_m, double max_range_m = 30) {
  return {.ranges_m = {range_m}, .laser = {.max_range_m = max_range_m}};
}

}  // namespace

TEST_CASE("a map begins unknown, the robot in its middle", "[perception]") {
  const int cells = GENERATE(300, 101);
  const LocalPerceptualMap map({.cells = cells});
  const Grid& grid = map.grid();
  CHECK(grid.width == cells);
  CHECK(grid.height == cells);
  CHECK(grid.cell_at({0.001, 0.001}) == Cell{cells / 2, cells / 2});
  CHECK(grid.log_odds == std::vector<float>(grid.log_odds.size(), 0.0F));
}

//   robot ........... #      free up to the wall, occupied there, unknown behind
//
TEST_CASE("a return marks its wall and what it came through", "[perception]") {
  const LpmOptions options;
  LocalPerceptualMap map(options);
  const double heading_rad = GENERATE(0.0, pi / 2, -pi / 2, pi, 0.3);
  CAPTURE(heading_rad);
  const Pose2 robot{0.05, 0.05, heading_rad};
  map.update(beam(5.0), robot);
  CHECK(log_odds(map.grid(), robot * Point2{5.0, 0}) == Approx(options.hit));
  for (const double before_m : {0.0, 1.0, 4.0}) {
    CHECK(log_odds(map.grid(), robot * Point2{before_m, 0}) == Approx(options.miss));
  }
  CHECK(log_odds(map.grid(), robot * Point2{5.3, 0}) == 0);
  CHECK(log_odds(map.grid(), robot * Point2{3, 0.5}) == 0);
}

TEST_CASE("a beam without a return says nothing", "[perception]") {
  LocalPerceptualMap map({});
  map.update(beam(30, 30), {});
  map.update(beam(31, 30), {});
  const Grid& grid = map.grid();
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const Cell cell{column, row};
      if (norm(grid.centre(cell)) < 0.5) continue;  // where the robot stands
      CAPTURE(column, row);
      REQUIRE(grid.log_odds[grid.index(cell)] == 0);
    }
  }
  CHECK(log_odds(grid, {0, 0}) < 0);
}

TEST_CASE("a wall seen flat has no gaps, a door has one", "[perception]") {
  // A wall 1 m to the left, seen ahead of the robot; a door is an opening in it.
  const double door_m = GENERATE(0.0, 1.0);
  Scan scan{.laser = {.first_beam_rad = 0.02, .beam_step_rad = 0.02, .max_range_m = 30}};
  for (std::size_t i = 0; i < 30; ++i) {
    const double sine = std::sin(scan.laser.beam_rad(i));
    const double along_m = std::cos(scan.laser.beam_rad(i)) / sine;
    const bool through = std::abs(along_m - 4) < door_m / 2;
    scan.ranges_m.push_back((through ? 2 : 1) / sine);
  }
  LocalPerceptualMap map({});
  map.update(scan, {});
  std::size_t gaps = 0;
  for (double x_m = 2.05; x_m < 6; x_m += 0.1) {
    const double wall =
        std::max(log_odds(map.grid(), {x_m, 0.95}), log_odds(map.grid(), {x_m, 1.05}));
    gaps += wall <= 0;
  }
  CAPTURE(door_m);
  if (door_m == 0) CHECK(gaps == 0);
  if (door_m > 0) CHECK(gaps >= 7);
}

TEST_CASE("a return from beyond the usable range frees space and marks no wall", "[perception]") {
  const LpmOptions options{.usable_range_m = 8};
  LocalPerceptualMap map(options);
  map.update(beam(12), {0.05, 0.05, 0});
  CHECK(log_odds(map.grid(), {7.5, 0.05}) == Approx(options.miss));
  for (const float value : map.grid().log_odds) CHECK(value <= 0);
  CHECK(log_odds(map.grid(), {8.5, 0.05}) == 0);
}

TEST_CASE("a return from outside the map frees the map up to its edge", "[perception]") {
  const LpmOptions options{.cells = 100};  // 5 m to each side
  LocalPerceptualMap map(options);
  map.update(beam(12), {0.05, 0.05, 0});
  CHECK(log_odds(map.grid(), {4.95, 0.05}) == Approx(options.miss));
  for (const float value : map.grid().log_odds) CHECK(value <= 0);
}

TEST_CASE("a scan taken outside the map changes nothing inside", "[perception]") {
  LocalPerceptualMap map({.cells = 100});
  map.update(beam(3), {40, 40, 0});
  CHECK(map.grid() == LocalPerceptualMap({.cells = 100}).grid());
}

TEST_CASE("log-odds stay within their bound, and what moved is forgotten", "[perception]") {
  const LpmOptions options;
  LocalPerceptualMap map(options);
  const Pose2 robot{0.05, 0.05, 0};
  for (int scan = 0; scan < 100; ++scan) map.update(beam(5.0), robot);
  CHECK(log_odds(map.grid(), {5.05, 0.05}) == Approx(options.bound));
  CHECK(log_odds(map.grid(), {2.05, 0.05}) == Approx(-options.bound));
  int scans = 0;
  while (log_odds(map.grid(), {5.05, 0.05}) > -0.3) {
    map.update(beam(7.0), robot);
    ++scans;
  }
  CHECK(scans == 8);  // (3.5 + 0.3) / 0.5 = 7.6
}

TEST_CASE("a cell counts once a scan, a return before a miss", "[perception]") {
  const LpmOptions options;
  LocalPerceptualMap map(options);
  Scan scan = beam(5.0);
  scan.ranges_m = {5.0, 5.0, 6.0, 5.0};  // all in one direction
  map.update(scan, {0.05, 0.05, 0});
  CHECK(log_odds(map.grid(), {5.05, 0.05}) == Approx(options.hit));
  CHECK(log_odds(map.grid(), {6.05, 0.05}) == Approx(options.hit));
  CHECK(log_odds(map.grid(), {3.05, 0.05}) == Approx(options.miss));
}

TEST_CASE("a room's walls are drawn where they are", "[perception]") {
  const Room room{.width_m = 9, .height_m = 5};
  LocalPerceptualMap map({});
  for (int turn = 0; turn < 8; ++turn) {
    const Pose2 robot{0.4, -0.6, wrapped(turn * pi / 4)};
    map.update(room.scan(robot, turn), robot);
  }
  const Grid& grid = map.grid();
  std::size_t walls = 0;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const float value = grid.log_odds[grid.index({column, row})];
      const double off_m = room.inside_by(grid.centre({column, row}));
      CAPTURE(column, row, value, off_m);
      if (value > 0.3F) {
        ++walls;
        REQUIRE(std::abs(off_m) <= 0.11);
      }
      if (off_m > 0.2) REQUIRE(value < -0.3F);
      if (off_m < -0.2) REQUIRE(value == 0);
    }
  }
  CHECK(walls > 200);  // 28 m of walls
}

TEST_CASE("scrolling by whole cells loses nothing inside", "[perception][property]") {
  RandomEngine random(1);
  for (int world = 0; world < 40; ++world) {
    LocalPerceptualMap map({.cells = 60 + static_cast<int>(below(3, random))});
    const Room room{.width_m = 4.1, .height_m = 3.1};  // walls amid cells
    const Pose2 robot{between(-1, 1, random), between(-1, 1, random), between(-pi, pi, random)};
    map.update(room.scan(robot, 0), robot);
    const Grid before = map.grid();
    const double far_m = world % 4 == 0 ? 20 : 4;
    const Point2 to{between(-far_m, far_m, random), between(-far_m, far_m, random)};
    map.scroll_to(to);
    const Grid& after = map.grid();
    CAPTURE(world, to.x_m, to.y_m);
    REQUIRE(after.cell_at(to) == Cell{after.width / 2, after.height / 2});
    // What both windows hold is the same, what came in is unknown.
    for (int row = 0; row < after.height; ++row) {
      for (int column = 0; column < after.width; ++column) {
        const Point2 centre = after.centre({column, row});
        REQUIRE(static_cast<double>(after.log_odds[after.index({column, row})]) ==
                log_odds(before, centre));
      }
    }
    // The frame stays: another look draws the same walls in the same cells.
    if (norm(to) > 1.5) continue;
    LocalPerceptualMap fresh({.cells = after.width});
    fresh.scroll_to(to);
    fresh.update(room.scan(robot, 0), robot);
    const bool equal = fresh.grid().log_odds == after.log_odds;
    REQUIRE(equal);
  }
}

TEST_CASE("a wall is known finer than its cell", "[perception]") {
  const LpmOptions options;
  LocalPerceptualMap map(options);
  const auto wall = [&]() -> const WallPoint& {
    return map.walls()[map.grid().index(map.grid().cell_at({5.05, 0.05}))];
  };
  CHECK(wall().returns == 0);
  for (const double range_m : {5.01, 5.02, 5.06}) map.update(beam(range_m), {0, 0.05, 0});
  CHECK(wall().returns == 3);
  CHECK(wall().mean.x_m == Approx(5.03));
  CHECK(wall().mean.y_m == Approx(0.05));
  map.scroll_to({3.2, -1.1});
  CHECK(wall().mean.x_m == Approx(5.03));
  // Once well known it does not drift any more.
  for (int scan = 0; scan < options.most_returns; ++scan) map.update(beam(5.03), {0, 0.05, 0});
  for (int scan = 0; scan < 50; ++scan) map.update(beam(5.09), {0, 0.05, 0});
  CHECK(wall().mean.x_m == Approx(5.03));
}

TEST_CASE("a map that changed has another version", "[perception]") {
  LocalPerceptualMap map({});
  const std::uint64_t before = map.version();
  map.scroll_to({0.09, 0.01});  // within the central cell
  CHECK(map.version() == before);
  map.scroll_to({1, 0});
  const std::uint64_t scrolled = map.version();
  CHECK(scrolled != before);
  map.update(beam(5), {});
  CHECK(map.version() != scrolled);
}

TEST_CASE("scrolling within the central cell moves nothing", "[perception]") {
  LocalPerceptualMap map({});
  map.update(beam(5), {});
  const Grid before = map.grid();
  map.scroll_to({0.09, 0.01});
  CHECK(map.grid() == before);
}

}  // namespace asterism
