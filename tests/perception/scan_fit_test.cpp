#include "perception/scan_fit.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "core/trace.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/room.hpp"

namespace asterism {
namespace {

constexpr double pi = std::numbers::pi;
constexpr SmallMotion no_odometry{1e-3, 1e-3, 1e-3};

std::vector<Point2> returns(const Scan& scan) {
  std::vector<Point2> points;
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    if (scan.ranges_m[beam] < scan.laser.max_range_m)
      points.push_back(scan.laser.robot_from_laser *
                       (scan.ranges_m[beam] * unit_vector(scan.laser.beam_rad(beam))));
  }
  return points;
}

ScanFit drawn(const Room& room, const Pose2& seen_from) {
  LocalPerceptualMap map({});
  map.update(room.scan(seen_from, 0), seen_from);
  ScanFit fit({});
  fit.draw(map);
  return fit;
}

}  // namespace

//   +----------------+
//   |   o  o'        |    drawn from o, seen from o', sought from near o'
//   +----------------+
TEST_CASE("a scan is fitted finer than the map's cells", "[perception][property]") {
  const Room room{.width_m = 8.03, .height_m = 5.57};  // walls amid cells
  RandomEngine random(1);
  for (int world = 0; world < 50; ++world) {
    const Pose2 first{between(-1, 1, random), between(-1, 1, random), between(-pi, pi, random)};
    const Pose2 truth =
        first * Pose2{between(-0.5, 0.5, random), between(-0.5, 0.5, random), normal(random)};
    const Pose2 start = truth * Pose2{between(-0.1, 0.1, random), between(-0.1, 0.1, random),
                                      between(-0.03, 0.03, random)};
    const ScanFit::Fit fit =
        drawn(room, first).fit(returns(room.scan(truth, 1)), start, start, no_odometry);
    const Pose2 off = inverse(truth) * fit.map_from_robot;
    CAPTURE(world, off.x_m, off.y_m, off.heading_rad);
    CHECK(norm(off.position()) < 0.01);  // a tenth of a cell
    CHECK(std::abs(off.heading_rad) < 0.002);
    CHECK(fit.matched > 0.95);
    CHECK(is_covariance(fit.covariance));
  }
}

//   -------------------------
//    o                           no end in sight: along it, the odometry is all there is
//   -------------------------
TEST_CASE("a corridor tells nothing of the way along it", "[perception]") {
  const double heading_rad = GENERATE(0.0, 0.5, -2.0);
  CAPTURE(heading_rad);
  const Room room{.width_m = 60, .height_m = 2};
  Scan scan = room.scan({0, 0.1, 0}, 0);
  for (double& range_m : scan.ranges_m) {
    if (range_m > 12) range_m = scan.laser.max_range_m;
  }
  const Pose2 turned{0, 0, heading_rad};
  LocalPerceptualMap map({});
  map.update(scan, turned * Pose2{0, 0.1, 0});
  ScanFit fit({});
  fit.draw(map);
  const Pose2 by_odometry = turned * Pose2{0.2, 0.15, 0.01};
  const SmallMotion odometry{1 / (0.02 * 0.02), 1 / (0.05 * 0.05), 1 / (0.02 * 0.02)};
  const ScanFit::Fit found = fit.fit(returns(scan), by_odometry, by_odometry, odometry);
  const Pose2 in_corridor = inverse(turned) * found.map_from_robot;
  CHECK(in_corridor.x_m == Approx(0.2).margin(0.02));
  CHECK(in_corridor.y_m == Approx(0.1).margin(0.01));
  CHECK(in_corridor.heading_rad == Approx(0).margin(0.003));
  CHECK(std::sqrt(found.covariance[0]) > 0.01);  // of the odometry's 0.02
  CHECK(std::sqrt(found.covariance[4]) < 0.005);
}

TEST_CASE("one who walks about moves no fit", "[perception]") {
  const Room room;
  const Pose2 truth{0.5, 0.3, 0.4};
  Scan scan = room.scan(truth, 1);
  for (std::size_t beam = 30; beam < 60; ++beam) scan.ranges_m[beam] = 1.2;
  const Pose2 start = truth * Pose2{0.05, -0.05, 0.02};
  const ScanFit::Fit fit = drawn(room, {}).fit(returns(scan), start, start, no_odometry);
  const Pose2 off = inverse(truth) * fit.map_from_robot;
  CHECK(norm(off.position()) < 0.01);
  CHECK(std::abs(off.heading_rad) < 0.002);
  CHECK(fit.matched < 0.95);
}

TEST_CASE("without walls the odometry rules", "[perception]") {
  ScanFit fit({});
  fit.draw(LocalPerceptualMap({}));
  const Pose2 by_odometry{1, 2, 0.3};
  const ScanFit::Fit found =
      fit.fit(returns(Room{}.scan({}, 0)), {1.1, 2, 0.3}, by_odometry, {100, 100, 100});
  CHECK(norm(found.map_from_robot.position() - by_odometry.position()) < 1e-3);
  CHECK(found.matched == 0);
  CHECK(found.covariance[0] == Approx(0.01));
}

}  // namespace asterism
