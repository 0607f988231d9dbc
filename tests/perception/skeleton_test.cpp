#include "perception/shortest_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ideal_world.hpp"

namespace asterism {
namespace {

// Boxes of walls and of unknown space, from chair legs to desks, anywhere in the grid.
void clutter(Grid& grid, std::size_t boxes, RandomEngine& random) {
  const auto columns = static_cast<std::size_t>(grid.width);
  for (; boxes > 0; --boxes) {
    const int left = static_cast<int>(below(columns, random));
    const int low = static_cast<int>(below(columns, random));
    const int wide = 1 + static_cast<int>(below(25, random));
    const int high = 1 + static_cast<int>(below(25, random));
    const float what = chance(0.7, random) ? 3.5F : 0.0F;
    for (int row = low; row < std::min(low + high, grid.height); ++row) {
      for (int column = left; column < std::min(left + wide, grid.width); ++column) {
        grid.log_odds[grid.index({column, row})] = what;
      }
    }
  }
}

// Pieces of the pruned skeleton.
std::size_t pieces(const Skeleton& skeleton) {
  std::vector<bool> seen(skeleton.points.size(), false);
  std::size_t count = 0;
  for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
    if (seen[i] || !skeleton.is_critical(i)) continue;
    ++count;
    std::vector<std::size_t> reached{i};
    seen[i] = true;
    while (!reached.empty()) {
      const std::size_t at = reached.back();
      reached.pop_back();
      for (const std::size_t next : skeleton.points[at].critical) {
        if (seen[next]) continue;
        seen[next] = true;
        reached.push_back(next);
      }
    }
  }
  return count;
}

bool holds(const std::vector<std::size_t>& all, std::size_t one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

void check_laws(const FreeSpace& space, const Skeleton& skeleton, const SkeletonOptions& options) {
  std::size_t leaves = 0;
  for (std::size_t i = 0; i < skeleton.points.size(); ++i) {
    const SkeletonPoint& point = skeleton.points[i];
    CAPTURE(i, point.cell.column, point.cell.row);
    REQUIRE(space.is_free(point.cell));
    REQUIRE(point.radius_m == space.clearance(point.cell));
    REQUIRE(point.radius_m >= options.min_gateway_width_m / 2);
    for (const std::size_t next : point.neighbours) {
      REQUIRE(skeleton.points[next].neighbours.has(i));
    }
    for (const std::size_t next : point.critical) {
      REQUIRE(point.neighbours.has(next));
      REQUIRE(skeleton.points[next].critical.has(i));
    }
    if (point.critical.size() != 1) continue;
    ++leaves;
    REQUIRE((holds(skeleton.exits, i) || holds(skeleton.dead_ends, i)));
  }
  REQUIRE(std::is_sorted(skeleton.exits.begin(), skeleton.exits.end()));
  for (const std::size_t exit : skeleton.exits) {
    REQUIRE((skeleton.is_critical(exit) || skeleton.dead_ends == skeleton.exits));
  }
  REQUIRE(pieces(skeleton) <= 1);
  if (skeleton.exits.size() > 1) REQUIRE(leaves >= 1);
}

Cell middle(const Grid& grid) { return {grid.width / 2, grid.height / 2}; }

}  // namespace

TEST_CASE("the pruned skeleton is connected and ends at exits", "[perception][property]") {
  RandomEngine random(1);
  const SkeletonOptions options;
  std::size_t exits = 0;
  for (int round = 0; round < 5; ++round) {
    for (const IdealWorld& world : ideal_worlds(between(1.6, 3.5, random))) {
      const double angle_rad = between(0, 2 * std::numbers::pi, random);
      for (const std::size_t boxes : {0U, 10U, 60U, 150U}) {
        Grid grid = drawn(turned(world, angle_rad));
        clutter(grid, boxes, random);
        CAPTURE(world.name, round, angle_rad, boxes);
        const FreeSpace space = free_space(grid);
        const Skeleton found = skeleton(space, middle(grid), options);
        check_laws(space, found, options);
        exits += found.exits.size();
      }
    }
  }
  CHECK(exits > 200);
}

// Lines along a diagonal are what thinning eats from their ends on.
TEST_CASE("every corridor seen has its exit, whichever way it runs", "[perception][property]") {
  RandomEngine random(4);
  const bool diagonal = GENERATE(false, true);
  for (int round = 0; round < 20; ++round) {
    const double width_m = between(1.6, 3.5, random);
    for (const IdealWorld& world : ideal_worlds(width_m)) {
      const double angle_rad = diagonal ? std::numbers::pi / 4 + between(-0.06, 0.06, random)
                                        : between(0, 2 * std::numbers::pi, random);
      const Grid grid = drawn(turned(world, angle_rad));
      CAPTURE(world.name, width_m, angle_rad);
      CHECK(skeleton(free_space(grid), middle(grid)).exits.size() == world.corridors.size());
    }
  }
}

TEST_CASE("an exit that was lost once is found", "[perception]") {
  const Grid grid = drawn(turned(ideal_worlds(1.8544)[2], 0.7340180213));
  const FreeSpace space = free_space(grid);
  const Skeleton found = skeleton(space, middle(grid));
  CHECK(found.exits.size() == 4);
  check_laws(space, found, {});
}

TEST_CASE("the laws hold in a hall full of clutter too", "[perception][property]") {
  RandomEngine random(2);
  const SkeletonOptions options;
  std::size_t most = 0;
  for (int world = 0; world < 60; ++world) {
    // Free up to the grid's edge, beyond which all is unknown.
    Grid grid{.width = 120, .height = 120, .resolution_m = 0.1};
    grid.log_odds.assign(120 * 120, -3.5F);
    clutter(grid, 5 + below(60, random), random);
    CAPTURE(world);
    const FreeSpace space = free_space(grid);
    const Skeleton found = skeleton(space, middle(grid), options);
    check_laws(space, found, options);
    most = std::max(most, found.exits.size());
  }
  CHECK(most > 2);
}

TEST_CASE("narrow branches are cut", "[perception]") {
  // A corridor of 2 m with a side branch as wide as asked for, to a cell's width.
  const double side_m = GENERATE(0.6, 0.8, 1.2, 1.6);
  IdealWorld world{.corridors = {{.heading_rad = 0, .width_m = 2},
                                 {.heading_rad = std::numbers::pi, .width_m = 2},
                                 {.heading_rad = std::numbers::pi / 2, .width_m = side_m}}};
  const Grid grid = drawn(world);
  const FreeSpace space = free_space(grid);
  const SkeletonOptions options{.min_gateway_width_m = 1.0};
  CAPTURE(side_m);
  CHECK(skeleton(space, middle(grid), options).exits.size() == (side_m > 1.0 ? 3 : 2));
}

TEST_CASE("a room without a way out has no exits", "[perception]") {
  Grid grid{.width = 100, .height = 100, .resolution_m = 0.1};
  grid.log_odds.assign(100 * 100, 3.5F);
  for (int row = 20; row < 80; ++row) {
    for (int column = 20; column < 80; ++column) grid.log_odds[grid.index({column, row})] = -3.5F;
  }
  const FreeSpace space = free_space(grid);
  const Skeleton found = skeleton(space, middle(grid));
  CHECK_FALSE(found.points.empty());
  CHECK(found.exits.empty());
  check_laws(space, found, {});

  grid.log_odds.assign(100 * 100, 0.0F);
  CHECK(skeleton(free_space(grid), middle(grid)).points.empty());
}

TEST_CASE("shortest paths are those of relaxing every step again and again",
          "[perception][property]") {
  RandomEngine random(3);
  Grid grid = drawn(ideal_worlds(2.5)[2]);
  clutter(grid, 60, random);
  const Skeleton found = skeleton(free_space(grid), middle(grid));
  REQUIRE(found.exits.size() > 1);
  const std::size_t start = found.exits.front();
  const ShortestPaths paths =
      shortest_paths(found, {start}, std::vector<bool>(found.points.size(), true));
  std::vector<double> length(found.points.size(), std::numeric_limits<double>::infinity());
  length[start] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < found.points.size(); ++i) {
      for (const std::size_t next : found.points[i].neighbours) {
        const Cell a = found.points[i].cell;
        const Cell b = found.points[next].cell;
        const double there = length[i] + std::hypot(a.column - b.column, a.row - b.row);
        if (there < length[next] - 1e-9) {
          length[next] = there;
          changed = true;
        }
      }
    }
  }
  for (std::size_t i = 0; i < length.size(); ++i) {
    CAPTURE(i);
    REQUIRE(std::isfinite(length[i]) == std::isfinite(paths.length[i]));
    if (std::isfinite(length[i])) REQUIRE(paths.length[i] == Approx(length[i]).margin(1e-6));
  }
}

}  // namespace asterism
