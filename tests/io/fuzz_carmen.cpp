#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "io/carmen_log.hpp"

namespace {

/// Any bytes are scans as they must be, and then maybe refused.
void check(std::string bytes) {
  using namespace asterism;
  try {
    LogReader reader(std::make_unique<std::istringstream>(std::move(bytes)), "input");
    long long number = 0;
    while (const auto scan = reader.next()) {
      if (scan->number != number++ || scan->ranges_m.empty()) std::abort();
      for (const double range_m : scan->ranges_m)
        if (!std::isfinite(range_m) || range_m < 0) std::abort();
      const Pose2& at = scan->odom_from_robot;
      if (!std::isfinite(at.x_m + at.y_m + scan->stamp_s)) std::abort();
      if (!(std::abs(at.heading_rad) <= 3.1416)) std::abort();
      if (!(scan->laser.max_range_m > 0)) std::abort();
      if (!std::isfinite(scan->laser.beam_rad(scan->ranges_m.size()))) std::abort();
    }
    if (number == 0) std::abort();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.find('\n') != std::string_view::npos) std::abort();
    if (message.find(": found ") == std::string_view::npos) std::abort();
    if (message.find("; expected ") == std::string_view::npos) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check({reinterpret_cast<const char*>(data), size});
  return 0;
}
