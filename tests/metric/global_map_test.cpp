#include "metric/global_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/room.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double cell_m = 0.1;
constexpr Room off_grid_room{8.03, 5.97};  // no wall lies between two cells

struct Survey {
  std::vector<Scan> scans = {};
  Trajectory trajectory = {};
};

// Scans from all over a room. Between two the robot had time to turn.
Survey survey(const Room& room, int scans, std::uint64_t seed) {
  RandomEngine random(seed);
  Survey result;
  for (int i = 0; i < scans; ++i) {
    const Pose2 pose{between(-0.45, 0.45, random) * room.width_m,
                     between(-0.45, 0.45, random) * room.height_m, between(-pi, pi, random)};
    result.scans.push_back(room.scan(pose, i));
    result.trajectory.push_back({10.0 * i, pose});
  }
  return result;
}

Grid draw(const Survey& survey, GlobalMapOptions options = {}) {
  options.resolution_m = cell_m;
  return global_map(survey.scans, survey.trajectory, options);
}

// One beam, from a laser where the robot is.
Survey single_beam(const Pose2& laser, double range_m, double max_range_m = 50) {
  const Scan scan{.ranges_m = {range_m},
                  .laser = {.beam_step_rad = 0.1, .max_range_m = max_range_m}};
  return {{scan}, {{0, laser}}};
}

// How much of a line is inside a square round a point.
double length_inside_m(Point2 from, Point2 to, Point2 middle, double half_m) {
  double enter = 0;
  double leave = 1;
  const auto clip = [&](double start_m, double way_m) {
    if (way_m == 0) {
      if (std::abs(start_m) > half_m) leave = -1;
      return;
    }
    const double a = (-half_m - start_m) / way_m;
    const double b = (half_m - start_m) / way_m;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(from.x_m - middle.x_m, to.x_m - from.x_m);
  clip(from.y_m - middle.y_m, to.y_m - from.y_m);
  return std::max(0.0, leave - enter) * norm(to - from);
}

std::string message(const Survey& survey, const GlobalMapOptions& options = {}) {
  try {
    global_map(survey.scans, survey.trajectory, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

template <class F>
void for_each_cell(const Grid& grid, F&& f) {
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column) f(Cell{column, row});
}

}  // namespace

//   +--------+
//   |        |     free inside, its walls where they are, unknown outside
//   +--------+
TEST_CASE("a room seen from inside is a room", "[metric]") {
  const Room& room = off_grid_room;
  const Grid grid = draw(survey(room, 40, 1));
  CHECK(grid.frame_from_grid.heading_rad == 0);
  CHECK(grid.log_odds.size() == std::size_t(grid.width) * std::size_t(grid.height));
  int wrong = 0;
  for_each_cell(grid, [&](Cell cell) {
    const double inside_m = room.inside_by(grid.centre(cell));
    const float log_odds = grid.log_odds[grid.index(cell)];
    if (inside_m > cell_m && !(log_odds < 0)) ++wrong;
    if (inside_m < -cell_m && log_odds != 0) ++wrong;
  });
  CHECK(wrong == 0);
  const auto has_wall = [&](Point2 at) {
    const Cell middle = grid.cell_at(at);
    for (int up = -1; up <= 1; ++up) {
      for (int right = -1; right <= 1; ++right) {
        const Cell cell{middle.column + right, middle.row + up};
        if (grid.contains(cell) && grid.log_odds[grid.index(cell)] > 0) return true;
      }
    }
    return false;
  };
  for (double share = -0.5; share <= 0.5; share += 0.01) {
    for (const double side : {-0.5, 0.5}) {
      CHECK(has_wall({share * room.width_m, side * room.height_m}));
      CHECK(has_wall({side * room.width_m, share * room.height_m}));
    }
  }
}

TEST_CASE("a global map is the same however its scans are ordered", "[metric][property]") {
  Survey seen = survey(off_grid_room, 60, 2);
  const Grid grid = draw(seen);
  CHECK(grid == draw(seen));
  RandomEngine random(3);
  for (std::size_t i = seen.scans.size(); i > 1; --i) {
    const std::size_t other = below(i, random);
    std::swap(seen.scans[i - 1], seen.scans[other]);
    std::swap(seen.trajectory[i - 1], seen.trajectory[other]);
  }
  CHECK(grid == draw(seen));
}

TEST_CASE("a global map turns with its trajectory", "[metric][property]") {
  Survey seen = survey(off_grid_room, 60, 4);
  const Grid grid = draw(seen);
  const Pose2 quarter{0, 0, pi / 2};
  for (TimedPose& pose : seen.trajectory) pose.layout_from_robot = quarter * pose.layout_from_robot;
  const Grid turned = draw(seen);
  CHECK(turned.width == grid.height);
  CHECK(turned.height == grid.width);
  int other = 0;
  for_each_cell(grid, [&](Cell cell) {
    const Cell there = turned.cell_at(quarter * grid.centre(cell));
    REQUIRE(turned.contains(there));
    if (turned.log_odds[turned.index(there)] != grid.log_odds[grid.index(cell)]) ++other;
  });
  // A beam that all but meets a corner of a cell may be rounded to its other side.
  CHECK(other <= 5);
}

TEST_CASE("a beam frees the cells it crosses and no others", "[metric][property]") {
  RandomEngine random(5);
  for (int i = 0; i < 300; ++i) {
    // Every third along an axis.
    const double heading_rad =
        i % 3 == 0 ? pi / 2 * double(below(4, random)) : between(-pi, pi, random);
    const Pose2 laser{between(-5, 5, random), between(-5, 5, random), heading_rad};
    const double range_m = between(0, 8, random);
    const Grid grid = draw(single_beam(laser, range_m));
    const Point2 end = laser * Point2{range_m, 0};
    const Cell last = grid.cell_at(end);
    for_each_cell(grid, [&](Cell cell) {
      const float log_odds = grid.log_odds[grid.index(cell)];
      if (cell == last) {
        CHECK(log_odds > 0);
        return;
      }
      const Point2 middle = grid.centre(cell);
      if (length_inside_m(laser.position(), end, middle, cell_m / 2) > 1e-5) CHECK(log_odds < 0);
      if (length_inside_m(laser.position(), end, middle, cell_m / 2 + 1e-6) == 0)
        CHECK(log_odds == 0);
    });
  }
}

TEST_CASE("no return frees little, a far one what is near", "[metric]") {
  const auto free_m = [](const Survey& survey) {
    const Grid grid = draw(survey, {.usable_range_m = 3});
    double farthest_m = 0;
    for_each_cell(grid, [&](Cell cell) {
      CHECK(grid.log_odds[grid.index(cell)] <= 0);
      if (grid.log_odds[grid.index(cell)] < 0)
        farthest_m = std::max(farthest_m, grid.centre(cell).x_m);
    });
    return farthest_m;
  };
  CHECK(free_m(single_beam({}, 50, 50)) == Approx(1).margin(cell_m));
  CHECK(free_m(single_beam({}, 10, 50)) == Approx(3).margin(cell_m));
}

TEST_CASE("a cell counts once a scan, and a return before a miss", "[metric]") {
  // Ten beams along one line, that end one behind the other.
  Survey seen = single_beam({}, 0);
  seen.scans[0].laser.beam_step_rad = 0;
  seen.scans[0].ranges_m.clear();
  for (int i = 0; i < 10; ++i) seen.scans[0].ranges_m.push_back(1.05 + 0.2 * i);
  const GlobalMapOptions options;
  const Grid grid = draw(seen);
  const auto at = [&](double x_m) { return grid.log_odds[grid.index(grid.cell_at({x_m, 0.05}))]; };
  CHECK(at(0.55) == static_cast<float>(options.miss));
  CHECK(at(1.15) == static_cast<float>(options.miss));
  CHECK(at(1.05) == static_cast<float>(options.hit));
  CHECK(at(1.45) == static_cast<float>(options.hit));
}

TEST_CASE("the laser is where it stands on the robot", "[metric]") {
  Survey seen = single_beam({2, 1, pi / 2}, 1);
  seen.scans[0].laser.robot_from_laser = {0.5, 0.25, -pi / 2};
  const Grid grid = draw(seen);
  CHECK(grid.log_odds[grid.index(grid.cell_at({2.75, 1.5001}))] > 0);
  CHECK(grid.log_odds[grid.index(grid.cell_at({1.8, 1.5001}))] < 0);
}

TEST_CASE("scans are drawn where there is something new and nothing is blurred", "[metric]") {
  const Room room;
  const auto visits_of_centre = [&](const std::vector<TimedPose>& poses) {
    Survey seen;
    seen.trajectory = poses;
    for (const TimedPose& pose : poses) seen.scans.push_back(room.scan(pose.layout_from_robot, 0));
    const GlobalMapOptions options{.bound = 1000};
    const Grid grid = draw(seen, options);
    return std::lround(grid.log_odds[grid.index(grid.cell_at({0.05, 0.05}))] / options.miss);
  };
  std::vector<TimedPose> standing;
  std::vector<TimedPose> driving;
  std::vector<TimedPose> spinning;
  std::vector<TimedPose> turning;
  for (int i = 0; i < 20; ++i) {
    standing.push_back({0.2 * i, {-3, 0.05, 0}});
    driving.push_back({0.2 * i, {-3 + 0.2 * i, 0.05, 0}});
    spinning.push_back({0.2 * i, {-3, 0.05, 0.2 * i}});
    turning.push_back({2.0 * i, {-3, 0.05, 0.2 * i}});
  }
  CHECK(visits_of_centre(standing) == 1);
  CHECK(visits_of_centre(driving) == 20);
  CHECK(visits_of_centre(spinning) == 1);
  CHECK(visits_of_centre(turning) == 20);
}

TEST_CASE("a map of too many cells is drawn as one of twice the resolution, or four times ...",
          "[metric]") {
  const Survey seen = survey(off_grid_room, 20, 6);
  const auto cells = [](const Grid& grid) { return grid.log_odds.size(); };
  const Grid fine = draw(seen);
  for (const std::size_t most : {cells(fine), cells(fine) - 1, cells(fine) / 5, std::size_t{16}}) {
    const Grid grid = draw(seen, {.max_cells = most});
    const double times = grid.resolution_m / cell_m;
    CHECK(std::exp2(std::round(std::log2(times))) == times);
    CHECK(cells(grid) <= most);
    CHECK((times == 1) == (most == cells(fine)));
    const GlobalMapOptions as_coarse{.resolution_m = grid.resolution_m};
    CHECK(grid == global_map(seen.scans, seen.trajectory, as_coarse));
    const GlobalMapOptions finer{.resolution_m = grid.resolution_m / 2};
    if (times > 1) CHECK(cells(global_map(seen.scans, seen.trajectory, finer)) > most);
  }
  Survey far = seen;
  far.trajectory[1].layout_from_robot.x_m = 1e7;
  const Grid grid = global_map(far.scans, far.trajectory);
  CHECK(cells(grid) <= 16'000'000);
  CHECK(grid.width * grid.resolution_m > 1e7);
}

TEST_CASE("what cannot be drawn is refused", "[metric]") {
  const Survey seen = survey({}, 3, 6);
  Survey shorter = seen;
  shorter.trajectory.pop_back();
  CHECK(message(shorter) == "global map: found 2 poses; expected one for each of 3 scans");
  CHECK(message({}) == "global map: found no scan; expected one or more");
  Survey broken = seen;
  broken.trajectory[2].layout_from_robot.heading_rad = std::nan("");
  CHECK(message(broken) == "global map: found no number in pose 2; expected finite ones");
  CHECK(message(seen, {.resolution_m = 0}).starts_with("global map: found option 0"));
  CHECK(message(seen) == "none");
}

}  // namespace asterism
