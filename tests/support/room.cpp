#include "tests/support/room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asterism {
namespace {

// To the wall that a ray meets along one axis.
double along_axis(double from_m, double step, double half_m) {
  if (step == 0) return std::numeric_limits<double>::infinity();
  return (std::copysign(half_m, step) - from_m) / step;
}

}  // namespace

Scan Room::scan(const Pose2& room_from_robot, long long number) const {
  constexpr int beams = 360;
  Scan scan{.number = number,
            .stamp_s = 0.1 * static_cast<double>(number),
            .odom_from_robot = room_from_robot,
            .laser = {.first_beam_rad = -std::numbers::pi,
                      .beam_step_rad = 2 * std::numbers::pi / beams,
                      .max_range_m = 30}};
  for (std::size_t beam = 0; beam < beams; ++beam) {
    const Point2 ray = unit_vector(room_from_robot.heading_rad + scan.laser.beam_rad(beam));
    scan.ranges_m.push_back(std::min(along_axis(room_from_robot.x_m, ray.x_m, width_m / 2),
                                     along_axis(room_from_robot.y_m, ray.y_m, height_m / 2)));
  }
  return scan;
}

double Room::inside_by(Point2 point) const {
  return std::min(width_m / 2 - std::abs(point.x_m), height_m / 2 - std::abs(point.y_m));
}

}  // namespace asterism
