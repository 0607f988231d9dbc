#pragma once

#include <string>
#include <vector>

#include "core/pose2.hpp"
#include "simulation/building.hpp"

namespace asterism {

/// A building from above, north up: walls, glass, its places with the arms of their stars (those
/// without gateway dashed), the way truly driven and the way the wheels tell.
std::string building_svg(const Building& building, const std::vector<Pose2>& driven,
                         const std::vector<Pose2>& told);

}  // namespace asterism
