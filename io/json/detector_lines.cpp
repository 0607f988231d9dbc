#include "io/json/detector_lines.hpp"

#include <array>

#include "io/json/json_writer.hpp"
#include "io/json/visit_json.hpp"

namespace asterism {
namespace {

std::array<double, 3> numbers(const Pose2& pose) { return {pose.x_m, pose.y_m, pose.heading_rad}; }

}  // namespace

std::string scan_line(const Scan& scan) {
  JsonWriter json;
  json.tight().object("scan", scan.number, "stamp_s", scan.stamp_s, "odometry",
                      numbers(scan.odom_from_robot), "first_beam_rad", scan.laser.first_beam_rad,
                      "beam_step_rad", scan.laser.beam_step_rad, "max_range_m",
                      scan.laser.max_range_m, "robot_from_laser",
                      numbers(scan.laser.robot_from_laser), "ranges_m", scan.ranges_m);
  return json.take();
}

Visit read_visit_line(std::string_view line, const std::string& where) {
  const JsonDocument document{where, parse_json_line(line, where)};
  return read_visit(JsonNode(document));
}

}  // namespace asterism
