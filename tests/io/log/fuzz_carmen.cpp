#include <cmath>
#include <sstream>

#include "io/log/carmen_log.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

void require_fit(const Scan& scan) {
  require(!scan.ranges_m.empty());
  for (const double range_m : scan.ranges_m) require(std::isfinite(range_m) && range_m >= 0);
  const Pose2& at = scan.odom_from_robot;
  require(std::isfinite(at.x_m + at.y_m + scan.stamp_s));
  require(std::abs(at.heading_rad) <= 3.1416);
  require(scan.laser.max_range_m > 0);
  require(std::isfinite(scan.laser.beam_rad(scan.ranges_m.size())));
}

}  // namespace

/// Any bytes are scans as they must be, and then maybe refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto scans = accepted("input", [&] {
    LogReader reader(std::make_unique<std::istringstream>(fuzz_input(data, size)), "input");
    long long number = 0;
    while (const auto scan = reader.next()) {
      require(scan->number == number++);
      require_fit(*scan);
    }
    return number;
  });
  require(scans != 0);
  return 0;
}
