#include <cmath>
#include <sstream>

#include "io/log/trajectory_file.hpp"
#include "tests/support/fuzz.hpp"

/// Any bytes are a reference, one that could be written as a trajectory, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const auto reference = accepted("input", [&] {
    return read_reference(std::make_unique<std::istringstream>(fuzz_input(data, size)), "input");
  });
  if (!reference) return 0;
  require(!reference->empty());
  for (const TimedPose& pose : *reference)
    require(std::abs(pose.layout_from_robot.heading_rad) <= 3.1416);
  std::ostringstream written;
  write_trajectory(written, *reference);
  return 0;
}
