#pragma once

#include <string>
#include <vector>

#include "core/map_drawing.hpp"
#include "core/ssh_map.hpp"

namespace asterism {

/// A picture of a map of the basic SSH, with a legend of its paths and places: a standalone
/// SVG 1.1.
///
/// Places are discs with their numbers, segments are lines in the colour of their path, several
/// between the same places side by side. The thick ring is where the robot is.
///
/// @param places  where each place is to be; no two at one point
std::string ssh_map_svg(const SshMap& map, const std::vector<MapDrawing::Point>& places,
                        const std::string& title);

}  // namespace asterism
