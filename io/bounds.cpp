#include "io/bounds.hpp"

#include <stdexcept>

namespace asterism {

void require_writable(const Pose2& pose, const std::string& what) {
  if (!position_bounds_m.contain(pose.x_m) || !position_bounds_m.contain(pose.y_m) ||
      !heading_bounds_rad.contain(pose.heading_rad))
    throw std::invalid_argument(what +
                                ": found a pose out of all bounds; expected metres and radians");
}

}  // namespace asterism
