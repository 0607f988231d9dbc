#include <cmath>

#include "io/json/detector_lines.hpp"
#include "perception/command_detector.hpp"
#include "perception/detector_laws.hpp"
#include "perception/shared_detector.hpp"
#include "tests/perception/corridor_drive.hpp"
#include "tests/perception/messages.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

constexpr double rounding_m = 1e-6;
constexpr double sector_m = 0.27;  // 5°, three metres away

std::unique_ptr<PlaceDetector> plugin() { return load_detector(ASTERISM_EXAMPLE_PLUGIN); }

std::unique_ptr<PlaceDetector> command() {
  return command_detector({ASTERISM_EXAMPLE_COMMAND}, scan_line, read_visit_line);
}

/// "star, entered by, left by", visit by visit, arms by their number.
std::vector<std::string> told(PlaceDetector& detector, const std::vector<Scan>& scans) {
  const auto arm = [](const std::optional<std::size_t>& i) { return i ? std::to_string(*i) : "-"; };
  std::vector<std::string> result;
  for (const auto& [visit, map] : visits_of(detector, scans))
    result.push_back(visit.star.text() + ", " + arm(visit.entered_by) + ", " + arm(visit.left_by));
  return result;
}

}  // namespace

TEST_CASE("the examples of detectors find the places of a drive", "[perception][example]") {
  // Clockwise from the arm ahead; the robot arrives at C and T facing east, then at C facing west.
  const std::vector<std::string> places{"a+1 b+1 a-1 b-1, 2, 0", "a+1 b+1 a-1 b-0, 2, 2",
                                        "a+1 b+1 a-1 b-1, 2, 1"};
  CHECK(told(*plugin(), corridor_drive()) == places);
  CHECK(told(*command(), corridor_drive()) == places);
}

TEST_CASE("the example of a plug-in measures gateways and displacements", "[perception][example]") {
  const auto visits = visits_of(*plugin(), corridor_drive());
  REQUIRE(visits.size() == 3);
  CHECK_FALSE(visits[0].visit.displacement);
  REQUIRE(visits[1].visit.displacement);
  CHECK(std::abs(visits[1].visit.displacement->x_m - 12) < rounding_m);
  CHECK(std::abs(visits[1].visit.displacement->y_m) < rounding_m);
  REQUIRE(visits[0].visit.gateways.size() == 4);
  // Corridors are two metres wide.
  for (const auto& gateway : visits[0].visit.gateways)
    CHECK(std::abs(gateway.width_m - 2) < sector_m);
}

TEST_CASE("the examples of detectors keep the laws", "[perception][example]") {
  const auto scans = corridor_drive();
  CHECK(broken_laws(plugin, scans) == std::vector<std::string>{});
  CHECK(broken_laws(command, scans) == std::vector<std::string>{});
}

}  // namespace asterism
