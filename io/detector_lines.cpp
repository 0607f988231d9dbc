#include "io/detector_lines.hpp"

#include <span>

#include "io/json_value.hpp"
#include "io/visit_json.hpp"

namespace asterism {
namespace {

std::string list(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + json_number(number);
  return '[' + text + ']';
}

std::string list(const Pose2& pose) {
  const double numbers[] = {pose.x_m, pose.y_m, pose.heading_rad};
  return list(numbers);
}

}  // namespace

std::string scan_line(const Scan& scan) {
  return "{\"scan\": " + std::to_string(scan.number) +
         ", \"stamp_s\": " + json_number(scan.stamp_s) +
         ", \"odometry\": " + list(scan.odom_from_robot) +
         ", \"first_beam_rad\": " + json_number(scan.laser.first_beam_rad) +
         ", \"beam_step_rad\": " + json_number(scan.laser.beam_step_rad) +
         ", \"max_range_m\": " + json_number(scan.laser.max_range_m) +
         ", \"robot_from_laser\": " + list(scan.laser.robot_from_laser) +
         ", \"ranges_m\": " + list(scan.ranges_m) + '}';
}

Visit read_visit_line(std::string_view line, const std::string& where) {
  const JsonDocument document{where, parse_json_line(line, where)};
  return read_visit(JsonNode(document));
}

}  // namespace asterism
