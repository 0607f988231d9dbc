#include "cli/carmen_log.hpp"

#include <fmt/format.h>

#include <numbers>
#include <ostream>

#include "io/atomic_file.hpp"

namespace asterism {
namespace {

std::string parameters(const LaserLayout& laser) {
  const Pose2& mount = laser.robot_from_laser;
  return fmt::format(
      "PARAM laser_front_laser_resolution {} 0 simulated 0\n"
      "PARAM robot_front_laser_max {} 0 simulated 0\n"
      "PARAM robot_frontlaser_offset {} 0 simulated 0\n"
      "PARAM robot_frontlaser_side_offset {} 0 simulated 0\n"
      "PARAM robot_frontlaser_angular_offset {} 0 simulated 0\n",
      laser.beam_step_rad * 180 / std::numbers::pi, laser.max_range_m, mount.x_m, mount.y_m,
      mount.heading_rad);
}

std::string line(const Scan& scan) {
  std::string result = fmt::format("FLASER {}", scan.ranges_m.size());
  for (const double range_m : scan.ranges_m) result += fmt::format(" {:.2f}", range_m);
  const auto pose = [](const Pose2& of) {
    return fmt::format(" {:.6f} {:.6f} {:.6f}", of.x_m, of.y_m, of.heading_rad);
  };
  result += pose(scan.odom_from_robot * scan.laser.robot_from_laser) + pose(scan.odom_from_robot);
  return result + fmt::format(" {0:.6f} simulated {0:.6f}\n", scan.stamp_s);
}

}  // namespace

void write_carmen_log(std::ostream& out, const ScanSource& next) {
  bool is_first = true;
  while (const auto scan = next()) {
    if (is_first) out << parameters(scan->laser);
    is_first = false;
    out << line(*scan);
  }
}

void write_carmen_log(const std::string& file, const ScanSource& next) {
  write_atomically(file, [&](std::ostream& out) { write_carmen_log(out, next); });
}

}  // namespace asterism
