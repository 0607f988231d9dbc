#pragma once

#include <string>

#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// What is wrong with a drawing, "" if nothing. Written apart from planarity/crossings: by
/// distances and angles, with a tolerance.
std::string fault_of_crossings(const TopologicalMap& map, const MapDrawing& drawing);
/// Segments that do not join their places, arms out of clockwise order, places that coincide.
std::string fault_of_stars(const TopologicalMap& map, const MapDrawing& drawing);

}  // namespace asterism
