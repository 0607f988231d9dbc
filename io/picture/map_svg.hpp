#pragma once

#include <string>

#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// A picture of a map, with a legend of its paths and visits: a standalone SVG 1.1.
///
/// Places are discs with their numbers, each path has a colour of its own. A dashed arm is an open
/// gateway, an arm with a bar ends there (α = 0). The dark arrow is the robot: at the place of the
/// last visit, facing along the arm left by, else opposite to the arm entered by.
std::string map_svg(const TopologicalMap& map, const MapDrawing& drawing, const std::string& title);

/// A picture of a map without title line and legend, for a page that has its own.
/// @param title  what it shows, for those who cannot see it
std::string bare_map_svg(const TopologicalMap& map, const MapDrawing& drawing,
                         const std::string& title);

}  // namespace asterism
