#include "perception/free_space.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr float free_log_odds = -3.5F;
constexpr float wall_log_odds = 3.5F;

Grid filled(int width, int height, float value, double resolution_m = 0.1) {
  Grid grid{.width = width, .height = height, .resolution_m = resolution_m};
  grid.log_odds.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value);
  return grid;
}

void fill(Grid& grid, Cell low, int columns, int rows, float value) {
  for (int row = low.row; row < low.row + rows; ++row) {
    for (int column = low.column; column < low.column + columns; ++column) {
      grid.log_odds[grid.index({column, row})] = value;
    }
  }
}

// Exact in integers.
std::vector<float> brute_force(const BitRows& picture) {
  std::vector<float> squared;
  for (int row = 0; row < picture.height(); ++row) {
    for (int column = 0; column < picture.width(); ++column) {
      int least = INT_MAX;
      for (int other_row = -1; other_row <= picture.height(); ++other_row) {
        for (int other = -1; other <= picture.width(); ++other) {
          if (picture.has({other, other_row})) continue;
          const int right = column - other;
          const int up = row - other_row;
          least = std::min(least, right * right + up * up);
        }
      }
      squared.push_back(static_cast<float>(least));
    }
  }
  return squared;
}

}  // namespace

TEST_CASE("squared distances are those of brute force", "[perception][property]") {
  RandomEngine random(1);
  for (int picture = 0; picture < 600; ++picture) {
    // Every third is a single line, lying or standing.
    const int width = picture % 6 == 0 ? 1 : 1 + static_cast<int>(below(40, random));
    const int height = picture % 6 == 3 ? 1 : 1 + static_cast<int>(below(40, random));
    const double share = std::pow(uniform(random), 4);
    BitRows cells(width, height);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        if (!chance(share, random)) cells.set({column, row});
      }
    }
    CAPTURE(picture, width, height, share);
    REQUIRE(squared_distances(cells) == brute_force(cells));
  }
}

TEST_CASE("squared distances stay exact across a large picture", "[perception]") {
  constexpr int width = 601;
  constexpr int height = 599;
  BitRows cells(width, height);
  for (int row = 0; row < height; ++row) cells.set_run(row, 0, width);
  const std::vector<float> squared = squared_distances(cells);
  CHECK(squared.front() == 1);
  CHECK(squared[width - 1] == 1);
  CHECK(squared[299 * width + 300] == 300 * 300);
}

//   . . . . . . .
//   . # # . . . .      a pillar in free space, `side` cells wide
//   . # # . . . .
//   . . . . . . .
TEST_CASE("an island goes if it is surrounded and small", "[perception]") {
  const float what = GENERATE(wall_log_odds, 0.0F);
  const double resolution_m = GENERATE(0.05, 0.10);
  const int most = resolution_m == 0.05 ? 20 : 10;  // cells in a metre
  const FreeSpaceOptions options{.island_max_m = 1.0 + 1e-9};
  CAPTURE(what, resolution_m);

  for (const int side : {1, 5, most, most + 1, most + 5}) {
    CAPTURE(side);
    Grid grid = filled(60, 60, free_log_odds, resolution_m);
    // Deep enough not to be taken for a gap between beams.
    fill(grid, {20, 25}, std::max(side, 5), 8, what);
    const FreeSpace space = free_space(grid, options);
    CHECK(space.is_free({22, 28}) == (side <= most));

    // At the grid's edge it may go on.
    Grid edge = filled(60, 60, free_log_odds, resolution_m);
    fill(edge, {20, 0}, std::max(side, 5), 5, what);
    CHECK_FALSE(free_space(edge, options).is_free({22, 1}));
  }
}

TEST_CASE("an island is what touches by corners too, and is measured as one", "[perception]") {
  Grid grid = filled(60, 60, free_log_odds);
  for (int i = 0; i < 11; ++i) fill(grid, {20 + i, 20 + i}, 1, 1, wall_log_odds);  // 1.1 m across
  CHECK_FALSE(free_space(grid).is_free({25, 25}));
  grid.log_odds[grid.index({25, 25})] = free_log_odds;  // now two of 0.5 m
  CHECK(free_space(grid).is_free({24, 24}));
  CHECK(free_space(grid).is_free({26, 26}));
}

TEST_CASE("random islands go exactly if they are small", "[perception][property]") {
  RandomEngine random(2);
  for (int world = 0; world < 100; ++world) {
    Grid grid = filled(80, 80, free_log_odds);
    // One to a quarter of the grid, so that none touch.
    struct Island {
      Cell low;
      int columns, rows;
    };
    std::vector<Island> islands;
    for (const Cell corner : {Cell{2, 2}, Cell{42, 2}, Cell{2, 42}, Cell{42, 42}}) {
      const Cell low{corner.column + static_cast<int>(below(10, random)),
                     corner.row + static_cast<int>(below(10, random))};
      islands.push_back(
          {low, 1 + static_cast<int>(below(20, random)), 1 + static_cast<int>(below(20, random))});
      fill(grid, low, islands.back().columns, islands.back().rows, wall_log_odds);
    }
    const FreeSpace space = free_space(grid, {.island_max_m = 0.95});
    for (const auto& [low, columns, rows] : islands) {
      CAPTURE(world, columns, rows);
      REQUIRE(space.is_free(low) == (columns <= 9 && rows <= 9));
    }
  }
}

TEST_CASE("gaps between beams are filled, never through a wall", "[perception]") {
  Grid grid = filled(40, 40, free_log_odds);
  fill(grid, {0, 20}, 40, 3, 0.0F);  // three cells deep: the middle one has free ones two away
  CHECK(free_space(grid).is_free({20, 21}));
  fill(grid, {0, 20}, 40, 5, 0.0F);
  CHECK_FALSE(free_space(grid).is_free({20, 22}));
  Grid wall = filled(40, 40, 0.0F);
  fill(wall, {0, 0}, 40, 19, free_log_odds);
  fill(wall, {0, 19}, 40, 1, wall_log_odds);
  fill(wall, {0, 21}, 40, 19, free_log_odds);
  CHECK_FALSE(free_space(wall).is_free({20, 20}));
}

TEST_CASE("gaps are those found cell by cell", "[perception][property]") {
  RandomEngine random(3);
  for (int world = 0; world < 60; ++world) {
    Grid grid = filled(1 + static_cast<int>(below(140, random)), 30, 0.0F);
    const double free = uniform(random);
    for (float& log_odds : grid.log_odds) {
      log_odds = chance(free, random) ? free_log_odds : chance(0.2, random) ? wall_log_odds : 0.0F;
    }
    const auto is = [&](Cell cell, float what) {
      return grid.contains(cell) && grid.log_odds[grid.index(cell)] == what;
    };
    const auto free_towards = [&](Cell cell, int right, int up) {
      const Cell next{cell.column + right, cell.row + up};
      return is(next, free_log_odds) ||
             (is(next, 0.0F) && is({next.column + right, next.row + up}, free_log_odds));
    };
    const FreeSpace space = free_space(grid, {.island_max_m = 0});
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const Cell cell{column, row};
        bool gap = false;
        for (const auto& [right, up] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
          gap = gap || (free_towards(cell, right, up) && free_towards(cell, -right, -up));
        }
        CAPTURE(world, grid.width, column, row);
        REQUIRE(space.is_free(cell) == (is(cell, free_log_odds) || (is(cell, 0.0F) && gap)));
      }
    }
  }
}

TEST_CASE("a corridor of n cells has a clearance of half its width", "[perception]") {
  const int n = GENERATE(1, 2, 3, 9, 10, 25, 26);
  const bool walled = GENERATE(true, false);
  CAPTURE(n, walled);
  Grid grid = filled(100, 60, walled ? wall_log_odds : 0.0F);
  fill(grid, {0, 15}, 100, n, free_log_odds);
  const FreeSpace space = free_space(grid);
  double most_m = 0;
  for (int row = 0; row < 60; ++row) most_m = std::max(most_m, space.clearance({50, row}));
  // From a cell's middle: with an even number of cells none lies on the corridor's axis.
  CHECK(most_m == Approx(0.1 * (n % 2 == 0 ? n / 2 - 0.5 : n / 2.0)).margin(1e-5));
  CHECK(space.clearance({50, 15}) == Approx(0.05).margin(1e-5));
  CHECK(space.clearance({50, 14}) == 0);
  CHECK(space.clearance({-1, 15}) == 0);
  CHECK(space.clearance({0, 15 + n / 2}) == Approx(0.05).margin(1e-5));  // outside is not free
}

TEST_CASE("cells are known from the log-odds asked for", "[perception]") {
  Grid grid = filled(20, 20, 0.0F);
  fill(grid, {0, 0}, 20, 10, -0.5F);
  fill(grid, {0, 10}, 20, 5, 0.5F);
  const FreeSpace low = free_space(grid, {.known = 0.5});
  CHECK(low.at({5, 5}) == Occupancy::free);
  CHECK(low.at({5, 12}) == Occupancy::occupied);
  CHECK(low.at({5, 17}) == Occupancy::unknown);
  CHECK(low.at({-1, 5}) == Occupancy::unknown);
  const FreeSpace high = free_space(grid, {.known = 0.6});
  CHECK(high.at({5, 5}) == Occupancy::unknown);
  CHECK(high.at({5, 12}) == Occupancy::unknown);
}

}  // namespace asterism
