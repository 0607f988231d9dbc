#include <cmath>
#include <numbers>
#include <ostream>
#include <stdexcept>

#include "io/atomic_file.hpp"
#include "io/json/json_value.hpp"
#include "io/line_words.hpp"
#include "io/log/carmen_laser.hpp"
#include "io/log/carmen_log.hpp"

namespace asterism {
namespace {

constexpr double rounding_rad = 1e-9;

[[noreturn]] void refuse(const Scan& scan, const std::string& found, const std::string& expected) {
  throw std::invalid_argument("scan " + std::to_string(scan.number) + ": found " + found +
                              "; expected " + expected);
}

std::string pose_text(const Pose2& pose) {
  return json_number(pose.x_m) + ' ' + json_number(pose.y_m) + ' ' + json_number(pose.heading_rad);
}

bool is_same(const LaserLayout& a, const LaserLayout& b) {
  return a.first_beam_rad == b.first_beam_rad && a.beam_step_rad == b.beam_step_rad &&
         a.max_range_m == b.max_range_m && a.robot_from_laser == b.robot_from_laser;
}

void write_head(std::ostream& out, const LaserLayout& laser) {
  out << "# FLASER num_readings [range_readings] x y theta odom_x odom_y odom_theta ipc_timestamp"
         " ipc_hostname logger_timestamp\n";
  const auto write = [&](std::string_view name, double value) {
    out << "PARAM " << name << ' ' << json_number(value) << " 0 nohost 0\n";
  };
  if (laser.beam_step_rad > 0)
    write(resolution_parameter, laser.beam_step_rad * 180 / std::numbers::pi);
  write(max_range_parameter, laser.max_range_m);
  write(x_parameter, laser.robot_from_laser.x_m);
  write(y_parameter, laser.robot_from_laser.y_m);
  write(heading_parameter, laser.robot_from_laser.heading_rad);
}

void write_scan(std::ostream& out, const Scan& scan) {
  out << "FLASER " << scan.ranges_m.size();
  for (const double range_m : scan.ranges_m) out << ' ' << json_number(range_m);
  const std::string stamp = json_number(scan.stamp_s);
  out << ' ' << pose_text(scan.odom_from_robot * scan.laser.robot_from_laser) << ' '
      << pose_text(scan.odom_from_robot) << ' ' << stamp << " nohost " << stamp << '\n';
}

void require_within(const Scan& scan, const Pose2& pose, Bounds metres, Bounds radians) {
  if (!metres.contain(pose.x_m) || !metres.contain(pose.y_m) || !radians.contain(pose.heading_rad))
    refuse(scan, "a pose out of all bounds", "metres and radians");
}

void require_readable(const Scan& scan, const LaserLayout& first) {
  if (scan.ranges_m.empty()) refuse(scan, "no ranges", "at least one");
  for (const double range_m : scan.ranges_m)
    if (!range_bounds_m.contain(range_m))
      refuse(scan, "range " + std::to_string(range_m), "metres from 0 to 1e6");
  require_within(scan, scan.odom_from_robot, position_bounds_m, heading_bounds_rad);
  require_within(scan, scan.laser.robot_from_laser, offset_bounds, offset_bounds);
  if (!is_same(scan.laser, first)) refuse(scan, "another layout", "that of the first scan");
  const LaserLayout& laser = scan.laser;
  if (!(laser.max_range_m > 0)) refuse(scan, "no maximum range", "metres above 0");
  if (!(laser.beam_step_rad > 0) && scan.ranges_m.size() > 1)
    refuse(scan, "beams without a step", "an angle above 0");
  const double expected_rad = guessed_first_beam_rad(scan.ranges_m.size(), laser.beam_step_rad);
  if (!(std::abs(laser.first_beam_rad - expected_rad) <= rounding_rad))
    refuse(scan, "first beam " + std::to_string(laser.first_beam_rad),
           std::to_string(expected_rad) + " for so many beams");
}

}  // namespace

void write_carmen_log(std::ostream& out, const ScanSource& next) {
  std::optional<LaserLayout> first;
  while (const auto scan = next()) {
    require_readable(*scan, first.value_or(scan->laser));
    if (!first) write_head(out, *(first = scan->laser));
    write_scan(out, *scan);
  }
  if (!first) throw std::invalid_argument("log: found no scan; expected at least one");
}

void write_carmen_log(const std::string& file, const ScanSource& next) {
  write_atomically(file, [&](std::ostream& out) { write_carmen_log(out, next); });
}

}  // namespace asterism
