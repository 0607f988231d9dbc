#include "perception/drift.hpp"

#include <cmath>
#include <numbers>

#include "core/trace.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr DriftOptions exact{
    .wheel_scale = 0.1, .bend_rad_per_m = 0, .position_noise_m = 0, .heading_noise_rad = 0};

// Steps of 1 m straight ahead from a pose.
DriftingPose straight(const DriftingPose& from, int steps, const PoseCovariance& by_chance,
                      const SmallMotion& by_wheels) {
  DriftingPose at = from;
  for (int step = 0; step < steps; ++step) {
    at.map_from_robot = at.map_from_robot * Pose2{1, 0, 0};
    at.drift = drifted(at.drift, at.map_from_robot, {by_chance, by_wheels, 1});
  }
  return at;
}

}  // namespace

TEST_CASE("chance adds up by squares, the wheels' scale by itself", "[perception]") {
  const auto heading_rad = GENERATE(0.0, 0.7, pi);
  const DriftingPose start{{3, -2, heading_rad}, {}};
  const DriftingPose by_chance = straight(start, 9, {0.01, 0, 0, 0, 0, 0, 0, 0, 0}, {});
  CHECK(covariance_between(start, by_chance, exact)[0] == Approx(0.09));
  const DriftingPose by_wheels = straight(start, 9, {}, {1, 0, 0});
  CHECK(covariance_between(start, by_wheels, exact)[0] == Approx(0.81));  // (9 m · 0.1)²
  CHECK(covariance_between(start, by_wheels, exact)[4] == Approx(0).margin(1e-12));
}

//   start ---> ---> --->     headings off at each step's end: 2, 1 and 0 m before the last
TEST_CASE("early headings count for more", "[perception]") {
  const DriftingPose start{{3, -2, 0.7}, {}};
  const DriftingPose end = straight(start, 3, {0, 0, 0, 0, 0, 0, 0, 0, 0.01}, {});
  const PoseCovariance covariance = covariance_between(start, end, exact);
  CHECK(covariance[0] == Approx(0).margin(1e-12));
  CHECK(covariance[4] == Approx(0.01 * (4 + 1 + 0)));
  CHECK(covariance[5] == Approx(0.01 * (2 + 1 + 0)));
  CHECK(covariance[8] == Approx(0.03));
}

TEST_CASE("a map that grows bent leads astray by the square of the way", "[perception]") {
  DriftOptions bent = exact;
  bent.bend_rad_per_m = 0.01;
  const DriftingPose start{{3, -2, 0.7}, {}};
  const auto aside = [&](int steps) {
    const DriftingPose end = straight(start, steps, {}, {});
    const PoseCovariance covariance = covariance_between(start, end, bent);
    CHECK(std::sqrt(covariance[8]) == Approx(0.01 * steps));
    CHECK(covariance[0] == Approx(0).margin(1e-12));
    return std::sqrt(covariance[4]);
  };
  CHECK(aside(4) == Approx(0.01 * (3 + 2 + 1 + 0)));
  CHECK(aside(40) == Approx(0.01 * 39 * 40 / 2));
}

//   -----------------      -------- | |-----
//     > bare corridor        > held | | by a side corridor
//   -----------------      -------- | |-----
TEST_CASE("where walls hold the robot along the way, the wheels do not count", "[perception]") {
  constexpr double sigma_m = 0.02;
  constexpr double wheels = sigma_m * sigma_m;
  const Pose2 motion{0.1, 0, 0.3};
  const DriftOptions options;
  const auto left = [&](double along_m2, double across_m2) {
    return left_to_wheels({along_m2, 0, 0, 0, across_m2, 0, 0, 0, 1e-6}, motion, sigma_m)[0];
  };
  CHECK(left(wheels, wheels) == Approx(0.1));  // no walls at all
  // Walls along the way, leaning, pretend to hold the robot: just as much as they may.
  const double lean = options.lean_rad * options.lean_rad;
  CHECK(left(wheels / (1 + lean * 100), wheels / 100) == Approx(0.1));
  CHECK(left(wheels / (1 + 0.5 * lean * 100), wheels / 100) == Approx(0.1));
  // Walls across the way say as much as the wheels in each of many scans.
  const double held = left(wheels / (2 + lean * 100), wheels / 100);
  CHECK(held == Approx(0.1 / (1 + options.scans_alike)));
  CHECK(left(0.01 * wheels, 0.01 * wheels) < 0.1 * held);
  CHECK(left_to_wheels({wheels, 0, 0, 0, wheels, 0, 0, 0, 1}, {0, 0, 0.3}, sigma_m)[0] == 0);
}

TEST_CASE("what drifted before does not matter", "[perception]") {
  const PoseCovariance chance{0.01, 0.002, 0, 0.002, 0.02, 0.001, 0, 0.001, 0.001};
  const SmallMotion wheels{0.7, 0.1, 0};
  const DriftingPose fresh{};
  DriftingPose late = straight(fresh, 400, chance, wheels);
  late.map_from_robot = late.map_from_robot * Pose2{0, 0, 2};
  const PoseCovariance expected = covariance_between(fresh, straight(fresh, 20, chance, wheels));
  const PoseCovariance found = covariance_between(late, straight(late, 20, chance, wheels));
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(found[i] == Approx(expected[i]).epsilon(1e-6).margin(1e-12));
  CHECK(is_covariance(found));
}

TEST_CASE("a pose is never known better than its map", "[perception]") {
  const DriftOptions options;
  const PoseCovariance covariance = covariance_between({}, {}, options);
  CHECK(covariance[0] == Approx(2 * std::pow(options.position_noise_m, 2)));
  CHECK(covariance[8] == Approx(2 * std::pow(options.heading_noise_rad, 2)));
}

}  // namespace asterism
