#include "cli/log_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/option_checks.hpp"
#include "core/angle.hpp"

namespace asterism {

void add_log(CLI::App& command, std::string& log, LogOptions& laser) {
  command.add_option("log", log, "CARMEN log, plain or packed by gzip or xz")->required();
  command
      .add_option_function<double>(
          "--fov", [&](double degrees) { laser.field_of_view_rad = radians(degrees); },
          "Field of view of the laser, degrees")
      ->type_name("DEG")
      ->check(number_between(0.1, 360, "degrees, 0.1 to 360"));
  command.add_option("--max-range", laser.max_range_m, "A range of this or more is no return")
      ->type_name("M")
      ->check(number_between(0.1, 1e4, "metres, 0.1 to 10000"));
  command
      .add_option_function<std::vector<double>>(
          "--laser-offset",
          [&](const std::vector<double>& at) {
            laser.robot_from_laser = {at[0], at[1], wrapped(radians(at[2]))};
          },
          "Where the laser stands on the robot: metres ahead, metres left, degrees")
      ->type_name("X,Y,DEG")
      ->delimiter(',')
      ->expected(3);
}

void add_gateway_width(CLI::App& command, ScanDetectorOptions& detector) {
  command
      .add_option("--min-gateway-width-m,--min-gateway-width",
                  detector.topology.skeleton.min_gateway_width_m,
                  "Openings of less measured clearance lead nowhere")
      ->type_name("M")
      ->check(number_between(0.1, 10, "metres, 0.1 to 10"))
      ->capture_default_str();
}

}  // namespace asterism
