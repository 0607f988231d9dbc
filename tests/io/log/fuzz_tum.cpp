#include <cmath>
#include <sstream>

#include "io/log/trajectory_file.hpp"
#include "tests/support/fuzz.hpp"

/// Any bytes are a trajectory or refused; a trajectory is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const auto trajectory = accepted("input", [&] {
    return read_trajectory(std::make_unique<std::istringstream>(fuzz_input(data, size)), "input");
  });
  if (!trajectory) return 0;
  std::stringstream written;
  write_trajectory(written, *trajectory);
  const Trajectory again =
      read_trajectory(std::make_unique<std::istringstream>(written.str()), "written");
  require(again.size() == trajectory->size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    const Pose2 a = again[i].layout_from_robot, b = (*trajectory)[i].layout_from_robot;
    require(again[i].stamp_s == (*trajectory)[i].stamp_s && a.position() == b.position());
    require(std::abs(wrapped(a.heading_rad - b.heading_rad)) < 1e-12);
  }
  return 0;
}
