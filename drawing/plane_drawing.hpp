#pragma once

#include "core/map_drawing.hpp"
#include "core/topological_map.hpp"

namespace asterism {

/// Draws a map like a floor plan: segments horizontal and vertical with as few bends as there can
/// be, arms at right angles where a place has four, the two directions of a dead end's path
/// opposite. A place with more arms sends them out in all directions. Arms leave in the clockwise
/// order of the stars; the first arm of place 0 leads up, unless that place has more than four.
///
/// Without crossings iff is_planar(map) (checked on the result); otherwise segments that cannot be
/// drawn without cross few others, at right angles.
///
/// @pre the map is connected, as maps of a trace are
MapDrawing draw(const TopologicalMap& map);

}  // namespace asterism
