#include "metric/driven_ways.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "metric/free_line.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

using Line = std::vector<Point2>;

constexpr float wall = 5;
constexpr float open = -5;

Grid unknown_floor(double side_m) {
  const int cells = static_cast<int>(side_m / 0.05);
  return {.width = cells,
          .height = cells,
          .resolution_m = 0.05,
          .frame_from_grid = {-side_m / 2, -side_m / 2, 0},
          .log_odds = std::vector<float>(static_cast<std::size_t>(cells * cells))};
}

void paint_disc(Grid& grid, Point2 middle, double radius_m, float value) {
  const int reach = static_cast<int>(radius_m / grid.resolution_m) + 1;
  grid.for_each_round(grid.cell_at(middle), reach, [&](Cell cell) {
    if (norm(grid.centre(cell) - middle) <= radius_m) grid.log_odds[grid.index(cell)] = value;
  });
}

/// What lies below a line, looked at so often that no cell is missed by more than that.
NotFree sampled(const Grid& grid, const Line& line, double apart_m) {
  NotFree result;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length_m = norm(line[i] - line[i - 1]);
    const double parts = std::ceil(length_m / apart_m);
    for (double part = 0; part < parts; ++part) {
      const Point2 at = line[i - 1] + ((part + 0.5) / parts) * (line[i] - line[i - 1]);
      const Ground ground = ground_at(grid, grid.cell_at(at));
      if (ground == Ground::wall) result.wall_m += length_m / parts;
      if (ground == Ground::unknown) result.unknown_m += length_m / parts;
    }
  }
  return result;
}

double away_m(Point2 point, const Line& line) {
  double least_m = norm(point - line.front());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point2 along = line[i] - line[i - 1];
    const double share =
        along == Point2{} ? 0
                          : std::clamp(dot(point - line[i - 1], along) / dot(along, along), 0., 1.);
    least_m = std::min(least_m, norm(point - line[i - 1] - share * along));
  }
  return least_m;
}

double length_m(const Line& line) {
  double sum_m = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum_m += norm(line[i] - line[i - 1]);
  return sum_m;
}

/// There and back again between two dead ends, so many times; each travel its own line, driven from
/// the first place if its number is even.
struct Drive {
  explicit Drive(const std::vector<Line>& travels) {
    const Visit one{.star = Star::parse("a+1 a-0")};
    const Visit other{.star = Star::parse("a+0 a-1")};
    std::vector<Arrival> arrivals;
    for (std::size_t k = 0; k <= travels.size(); ++k) {
      const std::size_t arm = k % 2;
      trace.visits.push_back(k % 2 == 0 ? one : other);
      Visit& visit = trace.visits.back();
      if (k > 0) visit.entered_by = arm;
      if (k < travels.size()) visit.left_by = arm;
      const auto scan = static_cast<long long>(trajectory.size());
      visit.scans = {scan, scan};
      arrivals.push_back({PlaceId(k % 2), k > 0 ? std::optional(arm) : std::nullopt});
      if (k == travels.size()) break;
      Line line = travels[k];
      if (k % 2 != 0) std::ranges::reverse(line);
      line.pop_back();
      for (const Point2 point : line) add(point);
    }
    add(travels.back()[travels.size() % 2 == 0 ? 0 : travels.back().size() - 1]);
    map = make_map(trace, arrivals);
  }

  DrivenWay way(const Grid& grid) const {
    const DrivenWays ways = driven_ways(trace, map, trajectory, grid);
    REQUIRE(ways.of_segment.size() == 1);
    REQUIRE(ways.layout_from_place.size() == 2);
    CHECK(ways.of_segment[0].line.front() == ways.layout_from_place[0].position());
    CHECK(ways.of_segment[0].line.back() == ways.layout_from_place[1].position());
    return ways.of_segment[0];
  }

  Trace trace;
  TopologicalMap map;
  Trajectory trajectory;

 private:
  void add(Point2 at) {
    trajectory.push_back({0.2 * double(trajectory.size()), {at.x_m, at.y_m, 0}});
  }
};

Line winding(RandomEngine& random, std::size_t points) {
  Line line{{0, 0}};
  double heading_rad = between(-3, 3, random);
  double turn_rad = 0;
  while (line.size() < points) {
    if (chance(0.1, random)) turn_rad = between(-0.2, 0.2, random);
    heading_rad += turn_rad;
    line.push_back(line.back() + between(0.02, 0.15, random) * unit_vector(heading_rad));
  }
  return line;
}

}  // namespace

TEST_CASE("what a line runs over is the same, crossed cell by cell or looked at point by point",
          "[metric]") {
  RandomEngine random(1);
  for (int round = 0; round < 300; ++round) {
    Grid grid = unknown_floor(3);
    grid.frame_from_grid = {between(-2, 2, random), between(-2, 2, random), between(-3, 3, random)};
    for (float& cell : grid.log_odds)
      cell = chance(0.4, random) ? open : chance(0.4, random) * wall;
    const auto any = [&] { return Point2{between(-3, 3, random), between(-3, 3, random)}; };
    Point2 from = any(), to = any();
    if (round % 3 == 0) to = from + Point2{0, round % 2 == 0 ? 1.0 : -1.0};
    const NotFree exact = not_free(grid, from, to);
    const NotFree other = sampled(grid, {from, to}, 1e-4);
    CHECK(exact.wall_m == Approx(other.wall_m).margin(0.01));
    CHECK(exact.unknown_m == Approx(other.unknown_m).margin(0.01));
    const NotFree back = not_free(grid, to, from);
    CHECK(back.wall_m == Approx(exact.wall_m).margin(1e-9));
    CHECK(back.unknown_m == Approx(exact.unknown_m).margin(1e-9));
  }
}

TEST_CASE("a way follows the line driven, round what stands on it, and into no wall", "[metric]") {
  RandomEngine random(2);
  std::size_t led_round = 0;
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const Line line = winding(random, 20 + random() % 200);
    Grid grid = unknown_floor(40);
    for (const Point2 point : line) paint_disc(grid, point, 0.7, wall);
    for (const Point2 point : line) paint_disc(grid, point, 0.45, open);
    const Point2 block = line[line.size() / 2];
    const bool has_block =
        round % 2 == 0 && norm(block - line.front()) > 1.5 && norm(block - line.back()) > 1.5;
    if (has_block) {  // as wide as leaves a way on either side
      paint_disc(grid, block, 1, open);
      paint_disc(grid, block, between(0.05, 0.4, random), wall);
    }
    const DrivenWay way = Drive({line}).way(grid);
    const NotFree found = sampled(grid, way.line, 1e-3);
    CHECK(found.wall_m == 0);
    CHECK(found.unknown_m == 0);
    CHECK(way.length_m == Approx(length_m(way.line)));
    CHECK(way.width_m > 0);
    const bool is_led_round = has_block && sampled(grid, line, 1e-3).wall_m > 0;
    led_round += is_led_round;
    for (const Point2 point : way.line) CHECK(away_m(point, line) < (is_led_round ? 1 : 0.051));
    if (!is_led_round) CHECK(way.length_m <= length_m(line) + 1e-9);
  }
  CHECK(led_round > 50);
}

TEST_CASE("of several travels the way in no wall is taken, then the smoothest", "[metric]") {
  const Line straight{{-5, 0}, {0, 0}, {5, 0}};
  const Line bent{{-5, 0}, {-2, 0}, {0, 1}, {2, 0}, {5, 0}};
  Grid grid = unknown_floor(20);
  for (float& cell : grid.log_odds) cell = open;
  CHECK(Drive({bent, straight, bent}).way(grid).line == Line{{-5, 0}, {5, 0}});
  CHECK(Drive({straight, bent}).way(grid).line == Line{{-5, 0}, {5, 0}});
  CHECK(Drive({bent, bent}).way(grid).line.size() == 5);
  // A wall across the whole floor but where the bend is, farther than lines are led round.
  for (double y_m = -10; y_m < 10; y_m += 0.05) {
    if (std::abs(y_m - 1) < 0.3) continue;
    grid.log_odds[grid.index(grid.cell_at({0, y_m}))] = wall;
  }
  CHECK(Drive({straight, bent}).way(grid).line[2] == Point2{0, 1});
}

TEST_CASE("what was driven twice is left out", "[metric]") {
  Grid grid = unknown_floor(20);
  for (float& cell : grid.log_odds) cell = open;
  Line poke{{-5, 0}};
  for (double x_m = -4.9; x_m < 0; x_m += 0.1) poke.push_back({x_m, 0});
  for (double y_m = 0.1; y_m < 3; y_m += 0.1) poke.push_back({0, y_m});
  for (double y_m = 3; y_m > 0; y_m -= 0.1) poke.push_back({0.02, y_m});
  for (double x_m = 0.1; x_m < 5; x_m += 0.1) poke.push_back({x_m, 0});
  const DrivenWay way = Drive({poke}).way(grid);
  CHECK(way.length_m == Approx(length_m({poke.front(), poke.back()})).margin(0.2));
}

TEST_CASE("a way is as wide as its narrowest spot, from wall to wall", "[metric]") {
  Grid grid = unknown_floor(20);
  for (float& cell : grid.log_odds) cell = open;
  for (double x_m = -6; x_m < 6; x_m += 0.04) {
    const double half_m = std::abs(x_m - 2) < 0.1 ? 0.4 : 1;
    for (const double y_m : {-half_m, half_m + 0.2})
      grid.log_odds[grid.index(grid.cell_at({x_m, y_m}))] = wall;
  }
  const Line line{{-5, 0}, {5, 0}};
  CHECK(Drive({line}).way(grid).width_m == Approx(1).margin(0.1));
  CHECK(Drive({{{-5, 0}, {0, 0}}}).way(grid).width_m == Approx(2.2).margin(0.1));
  for (float& cell : grid.log_odds) cell = open;
  CHECK(Drive({line}).way(grid).width_m == 20);
}

}  // namespace asterism
