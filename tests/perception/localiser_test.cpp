#include "perception/localiser.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "perception/local_perceptual_map.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/room.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;

struct Errors {
  double most_m = 0;
  double most_rad = 0;
  double odometry_m = 0;  ///< how far off the wheels were in the end
  double driven_m = 0;
  Pose2 last = {};
  std::vector<long long> jumps = {};  ///< scans at which the wheels were not believed
};

/// What the wheels tell on top of a step.
struct Leap {
  long long scan = -1;  ///< at which it ends
  Pose2 step = {};
};

// Ten metres round a room in steps of 0.1 m and 9°, the wheels off by `slip` of every step, always
// to the same side as well as at random.
Errors drive(std::uint64_t seed, double slip, const Leap& leap = {}) {
  const Room room{.width_m = 8, .height_m = 6};
  RandomEngine random(seed);
  const Pose2 start{-2, -1.5, 0};
  Pose2 truth = start;
  Pose2 odometry = {};
  LocalPerceptualMap map({});
  Localiser localiser({}, start);
  Errors errors;
  const auto look = [&](long long number) {
    Scan scan = room.scan(truth, number);
    scan.odom_from_robot = odometry;
    const Localiser::Estimate estimate = localiser.observe(scan, map);
    if (estimate.jump) errors.jumps.push_back(number);
    const Pose2 off = inverse(truth) * estimate.map_from_robot;
    errors.most_m = std::max(errors.most_m, norm(off.position()));
    errors.most_rad = std::max(errors.most_rad, std::abs(off.heading_rad));
    errors.last = estimate.map_from_robot;
    map.update(scan, estimate.map_from_robot);
  };
  look(0);
  const double bias = chance(0.5, random) ? slip : -slip;
  long long number = 0;
  const auto move = [&](const Pose2& step) {
    truth = truth * step;
    const double scale = 1 + bias + between(-slip, slip, random);
    odometry = odometry * Pose2{step.x_m * scale, step.x_m * between(-slip, slip, random),
                                step.heading_rad * scale + step.x_m * bias};
    errors.driven_m += step.x_m;
    if (++number == leap.scan) odometry = odometry * leap.step;
    look(number);
  };
  for (const double side_m : {4.0, 2.0, 4.0}) {
    for (int step = 0; step < std::lround(side_m / 0.1); ++step) move({0.1, 0, 0});
    for (int step = 0; step < 10; ++step) move({0, 0, pi / 20});
  }
  errors.odometry_m = norm(truth.position() - (start * odometry).position());
  return errors;
}

}  // namespace

//   +--------------------+
//   |   <------------    |
//   |                ^   |     m, drawn on the way, is all there is to go by
//   |   o------------+   |
//   +--------------------+
TEST_CASE("wheels 5 % off are put right by the walls", "[perception][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 9));
  const Errors errors = drive(seed, 0.05);
  CAPTURE(seed, errors.most_m, errors.most_rad, errors.odometry_m);
  CHECK(errors.driven_m == Approx(10));
  CHECK(errors.odometry_m > 0.2);  // else there was nothing to put right
  CHECK(errors.most_m < 0.05);     // half a cell
  CHECK(errors.most_rad < 0.01);
}

TEST_CASE("wheels that are right stay right", "[perception]") {
  const Errors errors = drive(1, 0);
  CHECK(errors.odometry_m < 1e-6);
  CHECK(errors.most_m < 0.02);  // walls are known finer than their cells
}

TEST_CASE("wheels that jump are not believed, and the walls bridge the jump",
          "[perception][property]") {
  const auto seed = GENERATE(range<std::uint64_t>(1, 25));
  RandomEngine random(seed);
  const double way_rad = between(-pi, pi, random);
  const double far_m = std::pow(10, between(0, 6, random));
  const Leap leap{static_cast<long long>(10 + seed * 4),
                  {far_m * std::cos(way_rad), far_m * std::sin(way_rad), between(-pi, pi, random)}};
  const Errors errors = drive(seed, 0.05, leap);
  CAPTURE(seed, leap.scan, far_m, errors.most_m, errors.most_rad);
  CHECK(errors.jumps == std::vector{leap.scan});
  CHECK(errors.most_m < 0.1);
  CHECK(errors.most_rad < 0.02);
  CHECK(drive(seed, 0.05).jumps.empty());
}

TEST_CASE("the same drive gives the same poses", "[perception]") {
  CHECK(drive(3, 0.05).last == drive(3, 0.05).last);
}

TEST_CASE("the first scan is where it is said to be", "[perception]") {
  Localiser localiser({}, {1, 2, 0.5});
  const Localiser::Estimate estimate =
      localiser.observe(Room{}.scan({}, 0), LocalPerceptualMap({}));
  CHECK(estimate.map_from_robot == Pose2{1, 2, 0.5});
  CHECK(estimate.turned_rad == 0);
}

// No walls, nothing to go by.
TEST_CASE("without returns the odometry rules", "[perception]") {
  LocalPerceptualMap map({});
  Localiser localiser({}, {});
  Scan scan{.ranges_m = {30, 31}, .laser = {.max_range_m = 30}};
  localiser.observe(scan, map);
  scan.odom_from_robot = {0.3, 0.1, 0.2};
  const Localiser::Estimate estimate = localiser.observe(scan, map);
  CHECK(estimate.map_from_robot.x_m == Approx(0.3));
  CHECK(estimate.map_from_robot.y_m == Approx(0.1));
  CHECK(estimate.turned_rad == Approx(0.2));
}

// A turn of 20° that the wheels missed.
TEST_CASE("headings are searched widely where the match is poor", "[perception]") {
  const Room room{.width_m = 9, .height_m = 5};
  const Pose2 start{0.5, -0.5, 0.2};
  LocalPerceptualMap map({});
  Localiser localiser({}, start);
  const Scan first = room.scan(start, 0);
  localiser.observe(first, map);
  for (int scan = 0; scan < 3; ++scan) map.update(first, start);
  const Pose2 after = start * Pose2{0, 0, 20 * pi / 180};
  Scan scan = room.scan(after, 1);
  scan.odom_from_robot = first.odom_from_robot;
  const Localiser::Estimate estimate = localiser.observe(scan, map);
  CHECK(wrapped(estimate.map_from_robot.heading_rad - after.heading_rad) == Approx(0).margin(0.03));
  CHECK(norm(estimate.map_from_robot.position() - after.position()) < 0.1);
  CHECK(estimate.turned_rad == Approx(20 * pi / 180).margin(0.03));
}

}  // namespace asterism
